#pragma once

#include <cmath>
#include <string>

#include "make.hpp"

namespace umbral::grader::test {

/// Of the pictures that are painted by functions.
inline constexpr std::uint32_t side = 24;

inline Judgement buffer(const Tensor& student, const Tensor& expected, Tolerance tolerance = {})
{
    return judge(check_of(JudgeKind{"buffer"}, tolerance), student, expected, nullptr);
}

inline bool says(const Judgement& found, const std::string& words)
{
    return found.message.find(words) != std::string::npos;
}

/// -1 if there is none of this name.
inline double metric(const Judgement& found, const std::string& name)
{
    const auto at = found.metrics.find(name);
    return at == found.metrics.end() ? -1 : at->second;
}

/// About the middle of a picture.
inline bool in_disc(double x, double y, double radius = 8) { return std::hypot(x - 11.5, y - 11.5) < radius; }

}
