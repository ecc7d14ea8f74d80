#include "judge/explain/transforms_tone.hpp"
#include "judge/judges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/explain/transforms.hpp"
#include "judge/picture/srgb.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;
constexpr double one_level = 1.0 / 255;
/// How far a value may lie from what a tone makes of the expected one, by rounding on both sides.
constexpr double rounding = 1.5 * one_level;

struct Range {
    double low = 0;
    double high = 1;
    [[nodiscard]] double normal(double value) const { return (value - low) / (high - low); }
};

Range range_of(const Check& check, const Tensor& tensor)
{
    if (tensor.element == Element::float32 || tensor.element == Element::float64)
        return {check.range_low, check.range_high};
    return {0, 255};
}

bool has_colours(const Check& check) { return judge_of(check).look == Look::colours; }

// Alpha carries no light.
std::size_t colours(const Tensor& tensor) { return tensor.components < 3 ? 1 : 3; }

template <class Tone>
Tensor recognise(const Check& check, const Tensor& student, const Tensor& expected, Tone tone)
{
    const Range range = range_of(check, expected);
    const std::size_t light = colours(expected);
    return map_cells(student, expected, [&](std::span<double> pixel, std::span<const double> target) {
        for (std::size_t c = 0; c < light; ++c)
            if (std::abs(range.normal(pixel[c]) - std::clamp(tone(range.normal(target[c])), 0.0, 1.0)) <= rounding)
                pixel[c] = target[c];
    });
}

/// Values 0..1 of the colour channels of both pictures, where they differ and the student's is not clamped.
std::vector<ValuePair> free_values(const Check& check, const Tensor& student, const Tensor& expected)
{
    const Range range = range_of(check, expected);
    const TensorView yours(student);
    const TensorView target(expected);
    std::vector<ValuePair> pairs;
    for (std::size_t cell = 0; cell < target.cells(); ++cell)
        for (std::size_t c = 0; c < colours(expected); ++c) {
            const ValuePair pair{range.normal(yours.cell(cell)[c]), range.normal(target.cell(cell)[c])};
            if (pair.student > one_level && pair.student < 1 - one_level &&
                std::abs(pair.student - pair.expected) > 0.5 * one_level)
                pairs.push_back(pair);
        }
    return pairs;
}

// One number fits any picture of one colour: it means something from four levels on. And where most differences are as
// small as what is taken for rounding, any tone near none fits them.
bool telling(const std::vector<ValuePair>& pairs)
{
    const auto large = std::ranges::count_if(
        pairs, [](const ValuePair& pair) { return std::abs(pair.student - pair.expected) > 2 * rounding; });
    if (2 * large < std::ssize(pairs)) return false;
    std::set<int> levels;
    for (const ValuePair& pair : pairs) levels.insert(static_cast<int>(std::lround(pair.expected * 255)));
    return levels.size() >= 4;
}

double invert(double v) { return 1 - v; }

template <double (*tone)(double)>
Result by_tone(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check) || !telling(free_values(check, student, expected))) return std::nullopt;
    return recognise(check, student, expected, tone);
}

// Least squares: bright pixels, whose rounding matters least, weigh most.
std::optional<double> light_factor(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check)) return std::nullopt;
    const auto pairs = free_values(check, student, expected);
    if (!telling(pairs)) return std::nullopt;
    double products = 0;
    double squares = 0;
    for (const ValuePair& pair : pairs) {
        products += pair.student * pair.expected;
        squares += pair.expected * pair.expected;
    }
    return products / squares;
}

Result rescale_light(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = light_factor(check, student, expected);
    if (!factor) return std::nullopt;
    return recognise(check, student, expected, [f = *factor](double v) { return f * v; });
}

std::string describe_light(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = light_factor(check, student, expected);
    return factor ? fmt::format(
                        "Your picture has about {:.2g} times the expected light: a constant factor is missing or too "
                        "much (pi, 2, the number of lights).",
                        *factor)
                  : std::string{};
}

std::optional<double> light_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check)) return std::nullopt;
    const auto pairs = free_values(check, student, expected);
    if (!telling(pairs)) return std::nullopt;
    std::vector<double> differences;
    for (const ValuePair& pair : pairs) differences.push_back(pair.student - pair.expected);
    return median(std::move(differences));
}

Result remove_light_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto offset = light_offset(check, student, expected);
    if (!offset) return std::nullopt;
    return recognise(check, student, expected, [o = *offset](double v) { return v + o; });
}

std::string describe_light_offset(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto offset = light_offset(check, student, expected);
    if (!offset) return {};
    return fmt::format("Your picture is too {} by the constant {:.3g} (of 1): {}.", *offset < 0 ? "dark" : "bright",
                       std::abs(*offset),
                       *offset < 0 ? "a term is missing, such as the ambient light"
                                   : "a term such as the ambient light is counted twice");
}

}

std::vector<NamedTransform> tone_transforms()
{
    return {
        {"inverted", "Your picture is a negative: the levels run the wrong way (1 - x instead of x).", by_tone<invert>},
        {"gamma applied twice",
         "Your picture is too bright in its dark parts as if sRGB had been encoded twice: encode once, when the "
         "picture is written.",
         by_tone<srgb_encoded>},
        {"gamma missing",
         "Your picture is too dark in its middle tones as if sRGB had been decoded once too often, or never encoded.",
         by_tone<srgb_decoded>},
        {"light scaled", "Your picture has a constant factor times the expected light.", rescale_light, describe_light,
         6},
        {"too dark by a constant", "Your picture differs from the expected one by a constant light.",
         remove_light_offset, describe_light_offset, 6},
    };
}

}
