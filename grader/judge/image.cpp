#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "judge/image_difference.hpp"
#include "judge/image_metrics.hpp"
#include "judge/image_rule.hpp"
#include "judge/rules.hpp"
#include "judge/tensor_view.hpp"

namespace umbral::grader {
namespace {

std::string complaint(const ImageRule& rule)
{
    const auto worst = std::max_element(rule.ratios.begin(), rule.ratios.end()) - rule.ratios.begin();
    switch (worst) {
        case 0: return fmt::format("{:.3g} % of the picture's content has no similar pixel next to its place", 100 * rule.edge_share);
        case 1: return fmt::format("{:.3g} % of the smooth surfaces have another colour", 100 * rule.interior_share);
        case 2: return fmt::format("the picture is too {} by {:.3g} levels of 255 on average", rule.bias > 0 ? "bright" : "dark", std::abs(rule.bias));
        default: return fmt::format("everything is shifted: {} pixel(s) to the right and {} down (negative: left, up)", rule.shift_x, rule.shift_y);
    }
}

std::string pixel_text(const TensorView& view, std::size_t cell) { return cell_text(view, cell); }

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

Judgement judge_image(const Check& check, const Tensor& student_tensor, const Tensor& expected_tensor, bool with_metrics)
{
    if (!complete(expected_tensor)) throw std::invalid_argument("check '" + check.name + "': the expected picture holds values that are not finite");
    if (!student_tensor.present.empty() && !complete(student_tensor)) {
        Judgement wrong;
        wrong.message = "Some pixels of the picture have no value.";
        return wrong;
    }
    if (student_tensor.bytes == expected_tensor.bytes) {
        (void)to_picture(check, Tensor{expected_tensor.element,
                                       1,
                                       1,
                                       expected_tensor.components,
                                       std::vector<std::byte>(expected_tensor.components * size_of(expected_tensor.element)),
                                       {}});
        return identical();
    }
    if (!complete(student_tensor)) {
        Judgement wrong;
        wrong.message = "The picture holds values that are not finite (NaN or infinity): look for a division by zero or the root of a negative number.";
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
                      {"content_pixels", rule.content}};
    add_metrics(measure_image(student, expected), result.metrics);
    if (result.right >= 1) return result;

    const auto region = worst_region(check, student_tensor, expected_tensor);
    result.message = "The picture differs: " + complaint(rule);
    if (region) {
        result.message += fmt::format("; look round pixel ({}, {})", region->peak_x, region->peak_y);
        const std::size_t cell = static_cast<std::size_t>(region->peak_y) * expected_tensor.columns + static_cast<std::size_t>(region->peak_x);
        result.first_difference = Difference{fmt::format("pixel ({}, {})", region->peak_x, region->peak_y), pixel_text(TensorView(student_tensor), cell),
                                             pixel_text(TensorView(expected_tensor), cell)};
    }
    return result;
}

}
