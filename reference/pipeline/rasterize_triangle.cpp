// Based on: J. Pineda. A Parallel Algorithm for Polygon Rasterization. SIGGRAPH 1988. The top-left rule is that of Direct3D.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {
namespace {

constexpr std::int64_t subpixels = 256;
constexpr float guard_band = 16384;

// Comparisons with NaN are false.
bool drawable(const WindowVertex& vertex)
{
    return std::abs(vertex.position.x) <= guard_band && std::abs(vertex.position.y) <= guard_band && vertex.inverse_w > 0 && !std::isnan(vertex.depth);
}

// A position in 1/256 pixel. Within the guard band products of differences stay below 2^47: int64 and double hold them exactly.
struct Point {
    std::int64_t x, y;
};

Point snapped(const glm::vec2& position) { return {std::llrint(position.x * subpixels), std::llrint(position.y * subpixels)}; }

// Twice the signed area of the triangle a, b, c; positive if they turn clockwise on the screen, where y goes down.
std::int64_t area(const Point& a, const Point& b, const Point& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// The area of a side and a pixel's centre, positive inside: an affine function, so that a step of one pixel adds a constant.
struct Edge {
    std::int64_t value, step_x, step_y;
    std::int64_t least;  // of the values that are covered: 0 on top and left edges, whose inside lies below or to the right; else 1
};

Edge edge(const Point& a, const Point& b, const Point& centre, std::int64_t orientation)
{
    const std::int64_t step_x = orientation * subpixels * (a.y - b.y);
    const std::int64_t step_y = orientation * subpixels * (b.x - a.x);
    const bool top_or_left = step_x > 0 || (step_x == 0 && step_y > 0);
    return {orientation * area(a, b, centre), step_x, step_y, top_or_left ? 0 : 1};
}

bool covered(const std::array<Edge, 3>& edges)
{
    return edges[0].value >= edges[0].least && edges[1].value >= edges[1].least && edges[2].value >= edges[2].least;
}

// What the corners bring along, in double once for all pixels.
struct Corners {
    glm::dvec3 depth, inverse_w;
    double inverse_area;
};

// Each edge's value over their sum is the affine weight of the vertex opposite; multiplied by 1/w and normalised, the perspective-correct one.
Fragment shaded(const Corners& corners, const std::array<Edge, 3>& edges, int x, int y)
{
    const glm::dvec3 affine(edges[0].value, edges[1].value, edges[2].value);
    const glm::dvec3 share = affine * corners.inverse_w;
    const double scale = 1 / (share.x + share.y + share.z);
    return {{x, y}, static_cast<float>(dot(affine, corners.depth) * corners.inverse_area), glm::vec3(share * scale)};
}

// First and last pixel in 0 … count - 1 whose centre lies between two positions. Shifts round down.
struct Range {
    int first, last;
};

Range centres_between(std::int64_t low, std::int64_t high, int count)
{
    static_assert(subpixels == 1 << 8);
    const std::int64_t first = (low + subpixels / 2 - 1) >> 8;
    const std::int64_t last = (high - subpixels / 2) >> 8;
    return {static_cast<int>(std::max<std::int64_t>(first, 0)), static_cast<int>(std::min<std::int64_t>(last, count - 1))};
}

}

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height, std::vector<Fragment>& fragments)
{
    if (!std::all_of(triangle.begin(), triangle.end(), drawable)) return;
    const Point a = snapped(triangle[0].position);
    const Point b = snapped(triangle[1].position);
    const Point c = snapped(triangle[2].position);
    const std::int64_t signed_area = area(a, b, c);
    if (signed_area == 0) return;

    const Range columns = centres_between(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width);
    const Range rows = centres_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height);
    const Point centre{columns.first * subpixels + subpixels / 2, rows.first * subpixels + subpixels / 2};
    const std::int64_t orientation = signed_area > 0 ? 1 : -1;
    const auto& [first, second, third] = triangle;
    const Corners corners{
        {first.depth, second.depth, third.depth}, {first.inverse_w, second.inverse_w, third.inverse_w}, 1 / static_cast<double>(std::abs(signed_area))};
    std::array<Edge, 3> row = {edge(b, c, centre, orientation), edge(c, a, centre, orientation), edge(a, b, centre, orientation)};

    for (int y = rows.first; y <= rows.last; ++y) {
        std::array<Edge, 3> pixel = row;
        bool entered = false;
        for (int x = columns.first; x <= columns.last; ++x) {
            if (covered(pixel))
                fragments.push_back(shaded(corners, pixel, x, y)), entered = true;
            else if (entered)
                break;  // a row of a triangle is one run
            for (Edge& e : pixel) e.value += e.step_x;
        }
        for (Edge& e : row) e.value += e.step_y;
    }
}

}
