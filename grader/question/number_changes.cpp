#include "question/number_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "question/alike.hpp"
#include "question/rounded.hpp"

namespace umbral::grader {
namespace {

struct KnownConstant {
    double value;
    const char* name;
    const char* remark = "";
};

constexpr double pi = std::numbers::pi;
constexpr double ln2 = std::numbers::ln2;
constexpr double ln10 = std::numbers::ln10;
constexpr std::array<KnownConstant, 23> known_constants{{
    {pi, "pi"},
    {2 * pi, "2 pi"},
    {4 * pi, "4 pi"},
    {pi / 2, "pi/2"},
    {pi / 3, "pi/3"},
    {pi / 4, "pi/4"},
    {pi / 6, "pi/6"},
    {1 / pi, "1/pi"},
    {2 / pi, "2/pi"},
    {0.5 / pi, "1/(2 pi)"},
    {0.25 / pi, "1/(4 pi)"},
    {pi / 180, "pi/180", "degrees to radians"},
    {180 / pi, "180/pi", "radians to degrees"},
    {ln2, "ln 2", "as ln is of log2"},
    {1 / ln2, "1/ln 2", "as log2 is of ln"},
    {ln10, "ln 10", "as ln is of log10"},
    {1 / ln10, "1/ln 10", "as log10 is of ln"},
    {ln2 / ln10, "ln 2/ln 10", "as log10 is of log2"},
    {ln10 / ln2, "ln 10/ln 2", "as log2 is of log10"},
    {std::numbers::sqrt2, "the square root of 2"},
    {std::numbers::sqrt2 / 2, "1 divided by the square root of 2"},
    {std::numbers::sqrt3, "the square root of 3"},
    {std::numbers::inv_sqrt3, "1 divided by the square root of 3"},
}};

std::string digits_of(double number) { return fmt::format("{:.6g}", number); }

bool is_near(double a, double b) { return alike(a, b, std::abs(b)); }

/// Has it no more than four digits?
bool is_short(double number) { return std::abs(rounded_to(number, 4) - number) <= 1e-6 * std::abs(number); }

/// "2/3"; empty if it is no simple fraction.
std::string fraction_text(double number)
{
    for (const int below : {3, 6, 7, 9, 11, 12, 255, 256}) {
        const double above = std::round(number * below);
        if (above == below) return "";
        if (above >= 1 && above <= 2 * 12 && is_near(number, above / below)) return fmt::format("{}/{}", above, below);
    }
    return "";
}

/// "65535/65536": what is lost or won where the largest number of so many bits is taken for how many there are. Empty
/// if it is none of these.
std::string fraction_near_one(double number)
{
    constexpr double same_distance = 0.01;  ///< float knows a factor's distance from 1 no better
    for (int bits = 4; bits <= 16; ++bits) {
        const double all = std::ldexp(1, bits);
        for (const auto& [above, below] : {std::pair(all - 1, all), {all, all - 1}, {all, all + 1}, {all + 1, all}})
            if (is_near(number, above / below) &&
                std::abs(number - above / below) <= same_distance * std::abs(above / below - 1))
                return fmt::format("{}/{}", above, below);
    }
    return "";
}

std::size_t different(std::span<const double> values) { return std::set<double>(values.begin(), values.end()).size(); }

/// The right ones plus a number, or times one.
std::optional<AnswerPattern> sum_or_product(std::span<const double> yours, std::span<const double> right)
{
    std::optional<double> factor;
    const double offset = yours.front() - right.front();
    bool same_offset = true;
    bool same_factor = true;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const double size = std::max(std::abs(yours[i]), std::abs(right[i]));
        same_offset = same_offset && alike(yours[i] - right[i], offset, size);
        if (right[i] == 0) {
            same_factor = same_factor && yours[i] == 0;
            continue;
        }
        if (!factor) factor = yours[i] / right[i];
        same_factor = same_factor && alike(yours[i] / right[i], *factor, std::abs(*factor));
    }
    if (same_offset && offset != 0)
        return AnswerPattern{
            fmt::format("the right one {} {}", offset > 0 ? "plus" : "minus", constant_text(std::abs(offset), false))};
    if (!same_factor || !factor || *factor == 0 || alike(*factor, 1, 1)) return std::nullopt;
    return multiple(*factor);
}

/// A number divided by the right ones: a quotient upside down.
std::optional<std::string> upside_down(std::span<const double> yours, std::span<const double> right)
{
    constexpr std::size_t least_different = 3;
    const double product = yours.front() * right.front();
    if (product == 0 || different(right) < least_different) return std::nullopt;
    for (std::size_t i = 0; i < right.size(); ++i)
        if (!is_near(yours[i] * right[i], product)) return std::nullopt;
    return fmt::format("{} divided by the right one", constant_text(product, false));
}

/// The different numbers that are not whole.
std::set<double> fractions_in(std::span<const double> numbers)
{
    std::set<double> fractions;
    for (const double one : numbers)
        if (std::abs(one - std::round(one)) > rounding * std::max(1.0, std::abs(one))) fractions.insert(one);
    return fractions;
}

std::vector<double> times(double factor, std::span<const double> numbers)
{
    std::vector<double> all;
    for (const double one : numbers) all.push_back(factor * one);
    return all;
}

/// What rounding to decimals, or to what a byte holds, leaves: numbers that are multiples of what the right ones are
/// none of.
std::optional<std::string> multiples_of_a_step(std::span<const double> yours, std::span<const double> right)
{
    constexpr std::size_t least_different = 6;
    for (const double parts : {1.0, 10.0, 100.0, 1e3, 1e4, 255.0, 256.0}) {
        const std::vector<double> scaled = times(parts, yours);
        const std::vector<double> other = times(parts, right);
        if (different(yours) < least_different || !fractions_in(scaled).empty()) continue;
        if (10 * fractions_in(other).size() < 9 * different(right)) return std::nullopt;
        if (parts == 1) return "a whole number, as the right one is not";
        return fmt::format("a multiple of {}, as the right one is not",
                           parts == 255 || parts == 256 ? fmt::format("1/{}", parts) : number_text(1 / parts));
    }
    return std::nullopt;
}

/// What division of integers leaves, or a conversion to one.
std::optional<std::string> made_whole(std::span<const double> yours, std::span<const double> right)
{
    constexpr std::size_t least_different = 4;
    const std::set<double> fractions = fractions_in(right);
    // One number for all of them is no rounding.
    if (fractions.size() < least_different || different(yours) < 2) return std::nullopt;
    const auto all = [&](double (*whole)(double)) {
        return std::ranges::equal(yours, right, {}, {}, [whole](double x) { return whole(x); });
    };
    if (all([](double x) { return std::trunc(x); })) return "the right one without its fraction";
    if (all([](double x) { return std::floor(x); })) return "the right one rounded down";
    if (all([](double x) { return std::ceil(x); })) return "the right one rounded up";
    if (all([](double x) { return std::round(x); })) return "the right one rounded to a whole number";
    return std::nullopt;
}

/// Whole numbers written by a machine whose bytes stand the other way round.
std::optional<std::string> bytes_reversed(std::span<const double> yours, std::span<const double> right)
{
    // Of numbers that one byte holds it is a factor.
    if (std::ranges::none_of(right, [](double b) { return std::abs(b) >= 256; })) return std::nullopt;
    for (const int bytes : {4, 2}) {
        const double range = std::ldexp(1, 8 * bytes);
        const auto bits_of = [range](double x) { return static_cast<std::uint32_t>(x < 0 ? x + range : x); };
        const bool all = std::ranges::equal(yours, right, [&](double a, double b) {
            const auto is_held = [range](double x) { return x == std::trunc(x) && x >= -range / 2 && x < range; };
            if (!is_held(a) || !is_held(b)) return false;
            const std::uint32_t reversed = __builtin_bswap32(bits_of(b)) >> (32U - 8U * static_cast<unsigned>(bytes));
            return bits_of(a) == reversed;
        });
        if (all) return fmt::format("the right one with its {} bytes in the opposite order", bytes);
    }
    return std::nullopt;
}

}

std::string constant_text(double number, bool remark)
{
    const double size = std::abs(number);
    const std::string sign = number < 0 ? "-" : "";
    if (!std::isfinite(number) || is_short(number)) return digits_of(number);
    int power = 0;
    if (std::frexp(size, &power) == 0.5 && power > 13) return fmt::format("{}2^{}", sign, power - 1);
    const auto* const found =
        std::ranges::find_if(known_constants, [&](const KnownConstant& one) { return is_near(size, one.value); });
    if (found != known_constants.end()) {
        const std::string told = remark && *found->remark != '\0' ? fmt::format(" ({})", found->remark) : "";
        return sign + found->name + told;
    }
    for (const std::string& fraction : {fraction_text(size), fraction_near_one(size)})
        if (!fraction.empty()) return sign + fraction;
    return digits_of(number);
}

AnswerPattern multiple(double factor)
{
    if (alike(factor, -1, 1)) return {"the right one with the opposite sign", CommonTells::opposite};
    const std::string text = constant_text(factor);
    const bool has_name = text != digits_of(factor);
    return {text + " times the right one", has_name ? CommonTells::other : CommonTells::multiple};
}

std::optional<AnswerPattern> change_of_numbers(std::span<const double> yours, std::span<const double> right)
{
    // Of a single right value anything is true.
    if (yours.empty() || different(right) < 2) return std::nullopt;
    if (auto words = bytes_reversed(yours, right)) return AnswerPattern{*std::move(words)};
    if (auto found = sum_or_product(yours, right)) return found;
    auto words = wrapped_numbers(yours, right);
    if (!words) words = made_whole(yours, right);
    if (!words) words = upside_down(yours, right);
    if (!words) words = multiples_of_a_step(yours, right);
    return words ? std::optional(AnswerPattern{*std::move(words)}) : std::nullopt;
}

std::optional<std::string> wrapped_numbers(std::span<const double> yours, std::span<const double> right)
{
    constexpr std::size_t least_bits = 32;  ///< of all different numbers together: so many agree by no chance
    for (const int bits : {32, 16, 8}) {
        if (different(right) * static_cast<std::size_t>(bits) < least_bits) continue;
        const double range = std::ldexp(1, bits);
        const bool held = std::ranges::equal(yours, right, [range](double a, double b) {
            const double left = std::fmod(b, range);
            return b == std::trunc(b) && std::abs(b) >= range / 2 && (a == left || a == left - range);
        });
        if (held)
            return fmt::format("what an integer of {} bits can hold of the right one (its rest modulo 2^{})", bits,
                               bits);
        // Of a sum one term may have wrapped round, and large ones may be recorded as floats.
        const bool lacks_multiples =
            bits > 8 && std::ranges::equal(yours, right, [range](double a, double b) {
                const double rounded = b * std::numeric_limits<float>::epsilon() / 2;
                return a == std::trunc(a) && b == std::trunc(b) && b - a > range / 2 && rounded < range / 1024 &&
                       std::abs(std::remainder(b - a, range)) <= (b < std::ldexp(1, 24) ? 0 : rounded);
            });
        if (lacks_multiples)
            return fmt::format("the right one less a multiple of 2^{}: an integer of {} bits is too small for a part",
                               bits, bits);
    }
    return std::nullopt;
}

std::optional<std::string> side_of_numbers(std::span<const double> yours, std::span<const double> right)
{
    constexpr std::size_t least = 8;  ///< of fewer, all may lie on one side by chance
    std::size_t larger = 0;
    std::size_t smaller = 0;
    for (std::size_t i = 0; i < yours.size(); ++i) {
        if (alike(yours[i], right[i], std::max(std::abs(yours[i]), std::abs(right[i])))) continue;
        ++(yours[i] > right[i] ? larger : smaller);
    }
    const auto is_bit = [](double x) { return x == 0 || x == 1; };
    const bool bits = std::ranges::all_of(yours, is_bit) && std::ranges::all_of(right, is_bit);
    if (bits && larger >= least && smaller == 0) return "1 (or true) where 0 (or false) is right";
    if (bits && smaller >= least && larger == 0) return "0 (or false) where 1 (or true) is right";
    if (larger >= least && smaller == 0) return "larger than the right one";
    if (smaller >= least && larger == 0) return "smaller than the right one";
    return std::nullopt;
}

}
