#include "judge/explain/transforms_tone.hpp"
#include "judge/judges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/explain/transforms.hpp"
#include "judge/picture/srgb.hpp"
#include "judge/rows/background.hpp"
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
    if (is_real(tensor.element)) return {check.range_low, check.range_high};
    return {0, 255};
}

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

/// Values 0..1 of the colour channels of both pictures, where they differ and the student's is not clamped. None where
/// more bright values are equal: then it is not the picture's light that differs. A background that is equal everywhere
/// does not count.
std::vector<ValuePair> free_values(const Check& check, const Tensor& student, const Tensor& expected)
{
    constexpr double bright = 0.1;
    const Range range = range_of(check, expected);
    const TensorView yours(student);
    const TensorView target(expected);
    if (target.cells() == 0) return {};
    const std::size_t light = colours(expected);
    const auto background = target.cell(background_cell(expected, target));
    std::vector<ValuePair> pairs;
    std::size_t unchanged = 0;
    std::size_t unchanged_background = 0;
    bool is_background_changed = false;
    for (std::size_t cell = 0; cell < target.cells(); ++cell) {
        const bool is_background = std::ranges::equal(target.cell(cell), background);
        for (std::size_t c = 0; c < light; ++c) {
            const ValuePair pair{range.normal(yours.cell(cell)[c]), range.normal(target.cell(cell)[c])};
            if (pair.student <= one_level || pair.student >= 1 - one_level) continue;
            if (std::abs(pair.student - pair.expected) > 0.5 * one_level) {
                pairs.push_back(pair);
                is_background_changed = is_background_changed || is_background;
            } else if (pair.expected > bright) {
                ++(is_background ? unchanged_background : unchanged);
            }
        }
    }
    if (is_background_changed) unchanged += unchanged_background;
    return unchanged > pairs.size() ? std::vector<ValuePair>() : pairs;
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

double negative(double v) { return 1 - v; }

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
    const double factor = products / squares;
    // What is nearly one fits many things that are not factors.
    constexpr double least_factor = 1.05;
    if (std::abs(std::log(factor)) < std::log(least_factor)) return std::nullopt;
    return factor;
}

Result rescale_light(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = light_factor(check, student, expected);
    if (!factor) return std::nullopt;
    return recognise(check, student, expected, [f = *factor](double v) { return f * v; });
}

// 1.06 must not read as 1.1, which is almost twice as far from 1.
std::string factor_text(double factor) { return fmt::format("{:.{}g}", factor, std::abs(factor) < 1 ? 2 : 3); }

std::string describe_light(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto factor = light_factor(check, student, expected);
    return factor ? fmt::format(
                        "Your picture has about {} times the expected light: a constant factor is missing or too "
                        "much (pi, 2, the number of lights).",
                        factor_text(*factor))
                  : std::string{};
}

double apart(const ValuePair& pair, double tone) { return std::abs(pair.student - std::clamp(tone, 0.0, 1.0)); }

/// Do nearly all of the pairs look as this tone makes them?
template <class Tone>
bool explains(const std::vector<ValuePair>& pairs, Tone tone)
{
    const auto explained = std::ranges::count_if(
        pairs, [&](const ValuePair& pair) { return apart(pair, tone(pair.expected)) <= rounding; });
    return 100 * explained >= 99 * std::ssize(pairs);
}

/// The power of the expected light that the student's is, if it is not what sRGB would make of it, or next to none.
std::optional<double> light_power(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check)) return std::nullopt;
    const auto pairs = free_values(check, student, expected);
    if (!telling(pairs) || explains(pairs, srgb_encoded) || explains(pairs, srgb_decoded)) return std::nullopt;
    std::vector<double> powers;
    for (const ValuePair& pair : pairs)
        if (pair.student > 0.1 && pair.expected > 0.1 && pair.expected < 0.9)
            powers.push_back(std::log(pair.student) / std::log(pair.expected));
    const auto power = median(std::move(powers));
    if (!power || std::abs(*power - 1) < 0.1 || *power < 0.1 || *power > 10) return std::nullopt;
    return power;
}

Result undo_power(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto power = light_power(check, student, expected);
    if (!power) return std::nullopt;
    return recognise(check, student, expected, [p = *power](double v) { return std::pow(std::max(v, 0.0), p); });
}

std::string describe_power(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto power = light_power(check, student, expected);
    return power ? fmt::format(
                       "Your picture has the expected levels to the power of {}: too {} in its middle tones, as by a "
                       "gamma that is used once too often or left out.",
                       factor_text(*power), *power < 1 ? "bright" : "dark")
                 : std::string{};
}

struct Line {
    double factor = 1;
    double offset = 0;
};

/// Factor and offset, by least squares, where neither alone would do.
std::optional<Line> light_line(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!has_colours(check)) return std::nullopt;
    const auto pairs = free_values(check, student, expected);
    if (!telling(pairs)) return std::nullopt;
    ValuePair mean;
    for (const ValuePair& pair : pairs) mean.student += pair.student, mean.expected += pair.expected;
    mean.student /= static_cast<double>(pairs.size());
    mean.expected /= static_cast<double>(pairs.size());
    double products = 0;
    double squares = 0;
    for (const ValuePair& pair : pairs) {
        products += (pair.student - mean.student) * (pair.expected - mean.expected);
        squares += (pair.expected - mean.expected) * (pair.expected - mean.expected);
    }
    const double factor = products / squares;
    const Line line{factor, mean.student - factor * mean.expected};
    constexpr double least = 0.05;
    const bool inverted = std::abs(line.factor + 1) < least && std::abs(line.offset - 1) < least;
    if (!(std::abs(line.factor) >= least && std::abs(line.factor) <= 8) || std::abs(line.factor - 1) < least ||
        std::abs(line.offset) < least || inverted)
        return std::nullopt;
    return line;
}

Result undo_line(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto line = light_line(check, student, expected);
    if (!line) return std::nullopt;
    return recognise(check, student, expected, [l = *line](double v) { return l.factor * v + l.offset; });
}

std::string describe_line(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto line = light_line(check, student, expected);
    return line ? fmt::format(
                      "Your picture has {} times the expected levels {} {:.2g} (of 1): look for a change of range, "
                      "such as x / 2 + 1 / 2, that is missing or too much.",
                      factor_text(line->factor), line->offset < 0 ? "minus" : "plus", std::abs(line->offset))
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

double one_level_of(const Tensor& tensor) { return is_real(tensor.element) ? one_level : 1; }

std::vector<NamedTransform> tone_transforms()
{
    return {
        {"inverted", "Your picture is a negative: the levels run the wrong way (1 - x instead of x).",
         by_tone<negative>},
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
        {"to a power", "Your picture has the expected levels to a power.", undo_power, describe_power, 6},
        {"another range", "Your picture has the expected levels in another range.", undo_line, describe_line, 12},
    };
}

}
