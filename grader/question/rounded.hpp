#pragma once

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace umbral::grader {

/// The number of so many digits that is nearest to this one; the number itself where that is none of double's.
[[nodiscard]] inline double rounded_to(double number, int digits)
{
    const std::string text = fmt::format("{:.{}g}", number, digits);
    double rounded = number;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rounded);
    return error == std::errc() ? rounded : number;
}

}
