#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "judge/image/complaint.hpp"
#include "judge/image/rule.hpp"
#include "judge/picture/image_difference.hpp"
#include "judge/picture/image_metrics.hpp"
#include "judge/picture/image_rule.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

std::string pixel_text(const Tensor& picture, int x, int y)
{
    const auto size = static_cast<std::ptrdiff_t>(size_of(picture.element) * picture.components);
    const auto start = picture.bytes.begin() + (static_cast<std::ptrdiff_t>(y) * picture.columns + x) * size;
    return cell_text(TensorView(Tensor{picture.element, 1, 1, picture.components, {start, start + size}, {}}), 0);
}

/// Have all pixels one value?
bool is_plain(const Tensor& picture)
{
    const std::size_t size = size_of(picture.element) * picture.components;
    return picture.bytes.size() >= size && std::equal(picture.bytes.begin() + static_cast<std::ptrdiff_t>(size),
                                                      picture.bytes.end(), picture.bytes.begin());
}

Judgement identical()
{
    Judgement result;
    result.right = 1;
    result.error = 0;
    result.metrics["worst_ratio"] = 0;
    add_metrics(ImageMetrics{0, std::numeric_limits<double>::infinity(), 1, 0, 0}, result.metrics);
    return result;
}

}

Judgement judge_image(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor,
                      bool with_metrics)
{
    if (!complete(expected_tensor))
        throw std::invalid_argument("check '" + check.name +
                                    "': the expected picture holds values that are not finite");
    if (!student_tensor.present.empty() && !complete(student_tensor)) {
        Judgement wrong;
        wrong.message = "Some pixels of the picture have no value.";
        return wrong;
    }
    check_picture(check, expected_tensor);
    // Both hold as many bytes: their shapes are the same.
    if (std::memcmp(student_tensor.bytes.data(), expected_tensor.bytes.data(), expected_tensor.bytes.size()) == 0)
        return identical();
    if (!complete(student_tensor)) {
        Judgement wrong;
        wrong.message =
            "The picture holds values that are not finite (NaN or infinity): look for a division by zero or the root "
            "of a negative number.";
        return wrong;
    }
    const Picture student = to_picture(check, student_tensor);
    const Picture expected = to_picture(check, expected_tensor);
    const ImageRule rule = apply_image_rule(student, expected);

    Judgement result;
    result.right = rule.right();
    result.error = rule.worst();
    if (!with_metrics) return result;
    result.metrics = {{"worst_ratio", rule.worst()},
                      {"edge_percent", 100 * rule.edge_share},
                      {"interior_percent", 100 * rule.interior_share},
                      {"bias_levels", rule.bias},
                      {"shift_x", rule.shift_x},
                      {"shift_y", rule.shift_y},
                      {"cluster_pixels", rule.cluster.count},
                      {"window_levels", rule.surface.difference},
                      {"content_pixels", rule.content}};
    add_metrics(measure_image(student, expected), result.metrics);
    if (result.right >= 1) return result;

    const auto region = worst_region(check, student_tensor, expected_tensor);
    const bool blank = is_plain(student_tensor) && !is_plain(expected_tensor);
    result.message = blank ? fmt::format("Every pixel of the picture is {}: nothing else was drawn",
                                         pixel_text(student_tensor, 0, 0))
                           : "The picture differs: " + complaint(rule);
    if (region) {
        result.message += fmt::format("; look round pixel ({}, {})", region->peak_x, region->peak_y);
        result.first_difference = Difference{fmt::format("pixel ({}, {})", region->peak_x, region->peak_y),
                                             pixel_text(student_tensor, region->peak_x, region->peak_y),
                                             pixel_text(expected_tensor, region->peak_x, region->peak_y),
                                             static_cast<std::size_t>(region->peak_y) * expected_tensor.columns +
                                                 static_cast<std::size_t>(region->peak_x)};
    }
    return result;
}

}
