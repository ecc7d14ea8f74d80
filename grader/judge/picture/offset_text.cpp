#include "judge/picture/offset_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace umbral::grader {

std::string offset_text(double x, double y)
{
    constexpr double least = 0.05;
    std::string text;
    const auto add = [&text](double by, const char* positive, const char* negative) {
        const double size = std::abs(by);
        if (size < least) return;
        text += fmt::format("{}{:.2g} pixel{} {}", text.empty() ? "" : " and ", size, size == 1 ? "" : "s",
                            by > 0 ? positive : negative);
    };
    add(x, "to the right", "to the left");
    add(y, "down", "up");
    return text;
}

}
