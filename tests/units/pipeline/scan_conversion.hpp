#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <umbral/core/grid.hpp>
#include <vector>

/// Which pixels a triangle covers, found in another way than by edge functions.
namespace umbral::tests {

__extension__ using Whole = __int128;

/// A rational number with a positive denominator.
struct Rational {
    Whole numerator, denominator;
    friend bool operator<(const Rational& a, const Rational& b)
    {
        return a.numerator * b.denominator < b.numerator * a.denominator;
    }
    friend bool operator==(const Rational& a, const Rational& b)
    {
        return a.numerator * b.denominator == b.numerator * a.denominator;
    }
};

/// Coverage by scan conversion, which no edge function enters into: in each row of centres, the triangle is a run
/// between two sides, and holds those centres that lie on or behind the left one and before the right one. A row
/// through a horizontal side belongs to what lies below it. Corners are multiples of 1/256 pixel.
inline Grid<int> scan_converted(const std::array<glm::vec2, 3>& corners, int width, int height)
{
    std::array<glm::i64vec2, 3> p{};
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = glm::i64vec2(
            glm::round(glm::dvec2(corners[i]) * 512.0));  // in 1/512 pixel centres are odd multiples of 256
    Grid<int> covered(width, height);
    for (int y = 0; y < height; ++y) {
        const std::int64_t row = 512 * std::int64_t{y} + 256;
        std::vector<Rational> crossings;
        for (std::size_t i = 0; i < 3; ++i) {
            glm::i64vec2 upper = p[i];
            glm::i64vec2 lower = p[(i + 1) % 3];
            if (lower.y < upper.y) std::swap(upper, lower);
            if (row < upper.y || row >= lower.y) continue;  // half open: top corners belong to it, bottom ones do not
            crossings.push_back(
                {Whole{upper.x} * (lower.y - upper.y) + Whole{row - upper.y} * (lower.x - upper.x), lower.y - upper.y});
        }
        if (crossings.size() != 2) continue;
        const auto [left, right] = std::minmax(crossings[0], crossings[1]);
        for (int x = 0; x < width; ++x) {
            const Rational centre{512 * std::int64_t{x} + 256, 1};
            covered.at(x, y) = !(centre < left) && centre < right ? 1 : 0;
        }
    }
    return covered;
}

}
