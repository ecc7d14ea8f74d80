#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <umbral/pipeline/rasterize.hpp>

/// Which pixels a triangle covers, row by row: the rule of pipeline/rasterize-triangle, whose reference is the plain
/// form of this. Exact, too: tests/render/rows_test.cpp compares the two.
///
/// Based on: J. Pineda. A Parallel Algorithm for Polygon Rasterization. SIGGRAPH 1988 (edge functions); C. Hecker.
/// Perspective Texture Mapping, part 2. Game Developer, 1995 (exact ends of rows by quotients and remainders).
namespace umbral::render {

inline constexpr std::int64_t subpixels = 256;
inline constexpr float farthest = 16384;  ///< of a corner that is drawn, in pixels: the unit's guard band

/// Comparisons with NaN are false.
[[nodiscard]] inline bool drawable(const pipeline::WindowVertex& vertex)
{
    return std::abs(vertex.position.x) <= farthest && std::abs(vertex.position.y) <= farthest && vertex.inverse_w > 0 &&
           !std::isnan(vertex.depth);
}

/// A position in 1/256 pixel. Within the guard band products of differences stay below 2^47: int64 and double hold them
/// exactly.
struct Point {
    std::int64_t x, y;
};

/// As std::llrint, ties to even: at 1.5 * 2^52 doubles are whole, and their last bits count.
[[nodiscard]] inline std::int64_t rounded(double value)
{
    const double shifted = value + 0x1.8p52;
    std::int64_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits - 0x4338000000000000;
}

[[nodiscard]] inline Point snapped(const glm::vec2& position)
{
    return {rounded(double{position.x} * subpixels), rounded(double{position.y} * subpixels)};
}

/// Twice the signed area of the triangle a, b, c; positive if they turn clockwise on the screen, where y goes down.
[[nodiscard]] inline std::int64_t area(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The area of a side and the centre of pixel (x, y), positive inside: an affine function of whole numbers.
struct Edge {
    std::int64_t origin;          ///< of pixel (0, 0)
    std::int64_t step_x, step_y;  ///< a step of one pixel adds 256 of these
    std::int64_t least;  ///< of the values that are covered: 0 on top and left edges, whose inside lies below or to the
                         ///< right; else 1

    /// At pixel (x, y).
    [[nodiscard]] std::int64_t at(std::int64_t x, std::int64_t y) const
    {
        return origin + subpixels * (x * step_x + y * step_y);
    }
};

[[nodiscard]] inline Edge edge(const Point& a, const Point& b, std::int64_t orientation)
{
    const std::int64_t step_x = orientation * (a.y - b.y);
    const std::int64_t step_y = orientation * (b.x - a.x);
    const bool top_or_left = step_x > 0 || (step_x == 0 && step_y > 0);
    return {orientation * area(a, b, {subpixels / 2, subpixels / 2}), step_x, step_y, top_or_left ? 0 : 1};
}

/// First and last of a run of pixels; empty if they are the other way round.
struct Range {
    std::int64_t first, last;
};

/// The pixels of `all` whose centre lies between two positions. Shifts round down.
[[nodiscard]] inline Range centres_between(std::int64_t low, std::int64_t high, const Range& all)
{
    static_assert(subpixels == 1 << 8);
    const std::int64_t first = (low + subpixels / 2 - 1) >> 8;
    const std::int64_t last = (high - subpixels / 2) >> 8;
    return {std::max(first, all.first), std::min(last, all.last)};
}

/// The part of a picture that is drawn.
struct Window {
    Range columns, rows;
};

/// A triangle ready to be drawn. Without area, or with nonsense in it, it has no rows.
struct Setup {
    std::array<Edge, 3> edges;
    double inverse_area = 0;
    Range columns{0, -1}, rows{0, -1};
};

[[nodiscard]] inline Setup set_up(const std::array<pipeline::WindowVertex, 3>& triangle, const Window& window)
{
    Setup setup;
    if (!drawable(triangle[0]) || !drawable(triangle[1]) || !drawable(triangle[2])) return setup;
    const Point a = snapped(triangle[0].position);
    const Point b = snapped(triangle[1].position);
    const Point c = snapped(triangle[2].position);
    const std::int64_t signed_area = area(a, b, c);
    if (signed_area == 0) return setup;
    const std::int64_t orientation = signed_area > 0 ? 1 : -1;
    setup.edges = {edge(b, c, orientation), edge(c, a, orientation), edge(a, b, orientation)};
    setup.inverse_area = 1 / static_cast<double>(std::abs(signed_area));
    setup.columns = centres_between(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), window.columns);
    setup.rows = centres_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), window.rows);
    return setup;
}

/// floor(n / d) where n grows by the same amount from row to row: a division at the beginning, then additions.
class Quotient {
public:
    Quotient() = default;
    Quotient(std::int64_t n, std::int64_t step, std::int64_t d)
        : divisor_(d), value_(floor(n)), rest_(n - value_ * d), step_(floor(step)), step_rest_(step - step_ * d)
    {
    }

    [[nodiscard]] std::int64_t value() const { return value_; }
    void next_row()
    {
        value_ += step_;
        rest_ += step_rest_;
        const std::int64_t carry = rest_ >= divisor_ ? 1 : 0;
        value_ += carry;
        rest_ -= carry * divisor_;
    }

private:
    [[nodiscard]] std::int64_t floor(std::int64_t n) const { return n / divisor_ - (n % divisor_ < 0 ? 1 : 0); }

    std::int64_t divisor_ = 1, value_ = std::numeric_limits<std::int32_t>::max(), rest_ = 0, step_ = 0, step_rest_ = 0;
};

/// Calls visit(y, first, last) for each row of covered pixels, from the top: what a triangle has in a row is one run.
///
/// Values of an edge at pixels differ by multiples of 256, so they reach `least` where (origin - least) / 256, rounded
/// down, plus x * step_x + y * step_y is at least 0. Solved for x, that is where an edge to the left begins and where
/// one to the right ends.
template <class Visit>
inline void for_each_run(const Setup& setup, Visit visit)
{
    Range rows = setup.rows;
    if (rows.first > rows.last || setup.columns.first > setup.columns.last) return;
    std::array<Quotient, 2> left;  // minus the first column
    std::array<Quotient, 2> right;
    std::size_t lefts = 0;
    std::size_t rights = 0;
    for (const Edge& edge : setup.edges) {
        const std::int64_t n = ((edge.origin - edge.least) >> 8) + rows.first * edge.step_y;
        if (edge.step_x > 0) {
            left[lefts++] = Quotient(n, edge.step_y, edge.step_x);
        } else if (edge.step_x < 0) {
            right[rights++] = Quotient(n, edge.step_y, -edge.step_x);
        } else if (edge.step_y < 0 && n + (rows.last - rows.first) * edge.step_y < 0) {
            --rows.last;  // centres on a bottom edge
        }
    }
    for (std::int64_t y = rows.first; y <= rows.last; ++y) {
        const std::int64_t first = std::max({setup.columns.first, -left[0].value(), -left[1].value()});
        const std::int64_t last = std::min({setup.columns.last, right[0].value(), right[1].value()});
        if (first <= last) visit(static_cast<int>(y), static_cast<int>(first), static_cast<int>(last));
        for (Quotient& end : left) end.next_row();
        for (Quotient& end : right) end.next_row();
    }
}

}
