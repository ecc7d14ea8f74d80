#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "judge/explain/transforms.hpp"
#include "judge/explain/transforms_tone.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;
using Channels = std::array<std::size_t, 3>;

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

bool has_channels(const Check& check, const Tensor& tensor)
{
    return judge_of(check).look == Look::colours && tensor.components >= 3;
}

/// The orders of three channels that are neither right nor red and blue swapped, which has a name of its own.
constexpr std::array<Channels, 4> orders{{{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}}};

std::pair<Channels, Tensor> best_order(const Tensor& student, const Tensor& expected)
{
    std::optional<std::pair<Channels, Tensor>> best;
    double nearest = 0;
    for (const Channels& order : orders) {
        Tensor candidate = map_cells(student, expected, [&](std::span<double> pixel, std::span<const double>) {
            const std::array<double, 3> old{pixel[0], pixel[1], pixel[2]};
            for (std::size_t c = 0; c < 3; ++c) pixel[c] = old[order[c]];
        });
        const double apart = distance(candidate, expected);
        if (!best || apart < nearest) nearest = apart, best = {order, std::move(candidate)};
    }
    return std::move(*best);
}

Result reorder_channels(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_channels(check, student)) return std::nullopt;
    return best_order(student, expected).second;
}

std::string describe_channels(const Check&, const Tensor& student, const Tensor& expected)
{
    const Channels order = best_order(student, expected).first;
    return fmt::format(
        "Your colours are right, but in another order: the expected red, green and blue are your {}, {} and {}.",
        channel_names[order[0]], channel_names[order[1]], channel_names[order[2]]);
}

/// The channels that are 0 in all of a picture.
std::vector<std::size_t> empty_channels(const Tensor& tensor)
{
    const TensorView view(tensor);
    std::vector<std::size_t> empty;
    for (std::size_t c = 0; c < 3; ++c) {
        bool is_empty = true;
        for (std::size_t cell = 0; is_empty && cell < view.cells(); ++cell) is_empty = view.cell(cell)[c] == 0;
        if (is_empty) empty.push_back(c);
    }
    return empty;
}

/// The channels that the student lost: one or two, since a black picture lost more than channels.
std::vector<std::size_t> lost_channels(const Tensor& student, const Tensor& expected)
{
    std::vector<std::size_t> lost = empty_channels(student);
    if (lost.size() > 2) return {};
    for (const std::size_t c : empty_channels(expected)) std::erase(lost, c);
    return lost;
}

Result restore_channels(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_channels(check, student)) return std::nullopt;
    const std::vector<std::size_t> lost = lost_channels(student, expected);
    if (lost.empty()) return std::nullopt;
    return map_cells(student, expected, [&](std::span<double> pixel, std::span<const double> target) {
        for (const std::size_t c : lost) pixel[c] = target[c];
    });
}

std::string describe_lost_channels(const Check&, const Tensor& student, const Tensor& expected)
{
    std::vector<std::string> names;
    for (const std::size_t c : lost_channels(student, expected)) names.emplace_back(channel_names[c]);
    return fmt::format("Your picture is right but for its {}, which {} 0 everywhere.", fmt::join(names, " and "),
                       names.size() == 1 ? "is" : "are");
}

glm::dvec3 colour(std::span<const double> pixel) { return {pixel[0], pixel[1], pixel[2]}; }
double spread(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z}); }

/// How much of each expected channel stands in a grey picture, by least squares; nothing if the student's picture is
/// not grey, or the expected one is nearly so.
std::optional<glm::dvec3> grey_mixture(const Tensor& student, const Tensor& expected)
{
    const TensorView yours(student);
    const TensorView target(expected);
    const double level = one_level_of(expected);
    std::size_t coloured = 0;
    glm::dmat3 products(0);
    glm::dvec3 sums(0);
    for (std::size_t cell = 0; cell < target.cells(); ++cell) {
        const glm::dvec3 mine = colour(yours.cell(cell));
        const glm::dvec3 wanted = colour(target.cell(cell));
        if (!(spread(mine) <= level)) return std::nullopt;
        if (spread(wanted) > 8 * level) ++coloured;
        products += glm::outerProduct(wanted, wanted);
        sums += wanted * mine.x;
    }
    if (10 * coloured < target.cells()) return std::nullopt;
    const glm::dvec3 mixture = glm::inverse(products) * sums;
    for (int c = 0; c < 3; ++c)
        if (!(mixture[c] > -0.02 && mixture[c] < 1.02)) return std::nullopt;
    return mixture;
}

Result colour_grey(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_channels(check, student)) return std::nullopt;
    const auto mixture = grey_mixture(student, expected);
    if (!mixture) return std::nullopt;
    const double level = one_level_of(expected);
    return map_cells(student, expected, [&](std::span<double> pixel, std::span<const double> target) {
        if (std::abs(pixel[0] - glm::dot(*mixture, colour(target))) <= 2 * level)
            std::copy_n(target.begin(), 3, pixel.begin());
    });
}

std::string describe_grey(const Check&, const Tensor& student, const Tensor& expected)
{
    const auto mixture = grey_mixture(student, expected);
    if (!mixture) return {};
    for (std::size_t c = 0; c < 3; ++c)
        if ((*mixture)[static_cast<glm::length_t>(c)] > 0.98)
            return fmt::format("Your picture is grey: all three channels hold the expected {}.", channel_names[c]);
    return fmt::format(
        "Your picture is grey: all three channels hold {:.1f} of the expected red, {:.1f} of the green and {:.1f} of "
        "the blue.",
        mixture->x, mixture->y, mixture->z);
}

}

std::vector<NamedTransform> channel_transforms()
{
    return {
        {"channels in another order", "Your colours are right, but their channels stand in another order.",
         reorder_channels, describe_channels, 2},
        {"channels lost", "Your picture is right but for channels that are 0 everywhere.", restore_channels,
         describe_lost_channels, -20},
        {"grey", "Your picture is grey: all three channels hold the same.", colour_grey, describe_grey, 12},
    };
}

}
