// Based on: J. Pineda. A Parallel Algorithm for Polygon Rasterization. SIGGRAPH 1988 (edge functions). The top-left
// rule is that of Direct3D.
//
// Every pixel of the triangle's box is asked. The engine's renderer finds whole rows at once, by the same rule:
// reference/render/rows.hpp.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <umbral/pipeline/rasterize.hpp>
#include <utility>

namespace umbral::pipeline {
namespace {

// Comparisons with NaN are false.
bool drawable(const WindowVertex& vertex)
{
    constexpr float guard_band = 16384;
    return std::abs(vertex.position.x) <= guard_band && std::abs(vertex.position.y) <= guard_band &&
           vertex.inverse_w > 0 && !std::isnan(vertex.depth);
}

// A position in 1/256 pixel. Within the guard band products of differences stay below 2^47: int64 and double hold them
// exactly.
struct Point {
    std::int64_t x, y;
};

Point snapped(const glm::vec2& position)
{
    return {std::llrint(256 * double{position.x}), std::llrint(256 * double{position.y})};
}

// Twice the signed area of the triangle a, b, c; positive if they turn clockwise on the screen, where y goes down.
std::int64_t area(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// With the inside to the right of the way from a to b: on the screen, a left edge goes up, and a top edge goes to the
// right.
bool is_top_or_left(const Point& a, const Point& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

// `edge` is the area of side a, b and a pixel's centre.
bool is_inside(std::int64_t edge, const Point& a, const Point& b)
{
    return edge > 0 || (edge == 0 && is_top_or_left(a, b));
}

// The pixels from first to last that two positions lie in, cut to a picture's.
struct Range {
    int first, last;
};

Range pixels_between(std::int64_t low, std::int64_t high, int size)
{
    const auto pixel = [](std::int64_t position) {
        return static_cast<int>(std::floor(static_cast<double>(position) / 256));
    };
    return {std::max(pixel(low), 0), std::min(pixel(high), size - 1)};
}

// `affine` are the weights on the screen. Multiplied by 1/w and normalised they are the perspective-correct ones.
Fragment shaded(const std::array<WindowVertex, 3>& triangle, const glm::dvec3& affine, int x, int y)
{
    const auto& [a, b, c] = triangle;
    const glm::dvec3 share = affine * glm::dvec3(a.inverse_w, b.inverse_w, c.inverse_w);
    const double depth = dot(affine, glm::dvec3(a.depth, b.depth, c.depth));
    return {{x, y}, static_cast<float>(depth), glm::vec3(share / (share.x + share.y + share.z))};
}

}

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments)
{
    if (!drawable(triangle[0]) || !drawable(triangle[1]) || !drawable(triangle[2])) return;
    const Point a = snapped(triangle[0].position);
    Point b = snapped(triangle[1].position);
    Point c = snapped(triangle[2].position);
    const bool turned = area(a, b, c) < 0;
    if (turned) std::swap(b, c);  // clockwise, so that the inside is positive
    const std::int64_t whole = area(a, b, c);
    if (whole == 0) return;

    const Range columns = pixels_between(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width);
    const Range rows = pixels_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height);
    for (int y = rows.first; y <= rows.last; ++y)
        for (int x = columns.first; x <= columns.last; ++x) {
            const Point centre = {256 * std::int64_t{x} + 128, 256 * std::int64_t{y} + 128};
            const std::int64_t bc = area(b, c, centre);
            const std::int64_t ca = area(c, a, centre);
            const std::int64_t ab = area(a, b, centre);
            if (!is_inside(bc, b, c) || !is_inside(ca, c, a) || !is_inside(ab, a, b)) continue;
            // The weight of a corner is the share of the side opposite.
            const glm::dvec3 affine = glm::dvec3(bc, turned ? ab : ca, turned ? ca : ab) / static_cast<double>(whole);
            fragments.push_back(shaded(triangle, affine, x, y));
        }
}

}
namespace n4 {
template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};
template <int I> struct B<0, I> {};
B<24, 0> all;
}
