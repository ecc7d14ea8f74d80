// Based on: I. Sutherland, G. Hodgman. Reentrant Polygon Clipping. Communications of the ACM, 1974.

#include <algorithm>
#include <umbral/pipeline/clip_polygon.hpp>

namespace umbral::pipeline {
namespace {

using Corners = std::vector<glm::dvec2>;

// A side of the window with its whole line; the inside lies to the left. In double, differences and products of floats
// are exact.
struct Side {
    glm::dvec2 from, to;
};

// Positive inside, in proportion to how far.
double distance(const Side& side, const glm::dvec2& point)
{
    const glm::dvec2 along = side.to - side.from;
    const glm::dvec2 off = point - side.from;
    return along.x * off.y - along.y * off.x;
}

// From the inner end to the outer one, so that polygons with a common side get the same corner on it.
glm::dvec2 crossing(const glm::dvec2& inner, double inner_distance, const glm::dvec2& outer, double outer_distance)
{
    const double span = inner_distance - outer_distance;
    return (-outer_distance / span) * inner + (inner_distance / span) * outer;
}

Corners clipped(const Corners& polygon, const Side& side)
{
    Corners result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2& a = polygon[i];
        const glm::dvec2& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_a = distance(side, a);
        const double at_b = distance(side, b);
        if (at_a >= 0) result.push_back(a);
        if (at_a > 0 && at_b < 0) result.push_back(crossing(a, at_a, b, at_b));
        if (at_a < 0 && at_b > 0) result.push_back(crossing(b, at_b, a, at_a));
    }
    return result;
}

bool finite(const std::vector<glm::vec2>& points)
{
    return std::all_of(points.begin(), points.end(),
                       [](const glm::vec2& p) { return glm::all(glm::equal(0.0F * p, glm::vec2(0))); });
}

std::vector<glm::vec2> rounded(const Corners& corners)
{
    std::vector<glm::vec2> result;
    for (const glm::dvec2& corner : corners)
        if (result.empty() || glm::vec2(corner) != result.back()) result.emplace_back(corner);
    while (result.size() > 1 && result.back() == result.front()) result.pop_back();
    if (result.size() < 3) result.clear();
    return result;
}

}

std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon, const std::vector<glm::vec2>& window)
{
    if (polygon.size() < 3 || window.size() < 3 || !finite(polygon) || !finite(window)) return {};
    Corners corners(polygon.begin(), polygon.end());
    for (std::size_t i = 0; i < window.size(); ++i)
        corners = clipped(corners, {window[i], window[i + 1 < window.size() ? i + 1 : 0]});
    return rounded(corners);
}

}
