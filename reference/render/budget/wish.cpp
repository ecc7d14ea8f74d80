#include "render/budget/wish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace umbral::render::budget {
namespace {

/// The number before the unit; nothing if it is none, or not finite.
std::optional<double> number_before(const std::string& text, const std::string& unit)
{
    if (!text.ends_with(unit)) return std::nullopt;
    const char* stop = text.data() + text.size() - unit.size();
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), stop, value, std::chars_format::fixed);
    if (fault != std::errc() || end != stop || !(value < 1e9)) return std::nullopt;
    return value;
}

std::string shown(std::string text)
{
    text.resize(std::min<std::size_t>(text.size(), 40));
    std::ranges::replace_if(
        text, [](char letter) { return letter < 0x20 || letter == 0x7F; }, '?');
    return text;
}

}

Wish parse_wish(const std::string& error, const std::string& time)
{
    if (error.empty() && time.empty())
        throw std::runtime_error("expected --error as 1% or --time as 2s, got nothing behind it");
    if (!error.empty() && !time.empty())
        throw std::runtime_error("expected --error or --time, got both: ask for one, the other follows from it");
    if (!error.empty()) {
        const auto percent = number_before(error, "%");
        if (percent && *percent > 0 && *percent < 100) return Wish{true, *percent / 100};
        throw std::runtime_error(fmt::format(
            "--error: expected a part of full scale above 0% and below 100%, as 1% or 0.5%, got '{}'", shown(error)));
    }
    const auto milliseconds = number_before(time, "ms");
    const auto seconds = milliseconds ? *milliseconds / 1000 : number_before(time, "s");
    if (seconds && *seconds > 0 && *seconds <= 86400) return Wish{false, *seconds};
    throw std::runtime_error(
        fmt::format("--time: expected a time above 0s and of at most 86400s, as 2s or 250ms, got '{}'", shown(time)));
}

}
