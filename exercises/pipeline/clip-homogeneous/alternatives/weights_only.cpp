// alternative: clips the triangle of weights; positions are blended from them at the end

#include <umbral/pipeline/clip.hpp>

namespace umbral::pipeline {
namespace {

struct Point {
    glm::dvec3 weights;
    unsigned planes = 0;  // that it was put on
};

// How far each corner of the triangle lies inside a plane; a blend of these is how far a point does.
using Distances = glm::dvec3;

std::vector<Point> clipped(const std::vector<Point>& points, const Distances& distances, unsigned plane)
{
    std::vector<Point> result;
    const auto inside = [&](const Point& point) { return glm::dot(point.weights, distances); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& here = points[i];
        const Point& next = points[(i + 1) % points.size()];
        const bool leaves = inside(here) > 0 && inside(next) < 0;
        const bool enters = inside(here) < 0 && inside(next) > 0;
        if (inside(here) >= 0) result.push_back(here);
        if (!leaves && !enters) continue;
        const Point& inner = leaves ? here : next;
        const Point& outer = leaves ? next : here;
        const double t = inside(inner) / (inside(inner) - inside(outer));
        result.push_back({(1 - t) * inner.weights + t * outer.weights, (inner.planes & outer.planes) | (1U << plane)});
    }
    return result;
}

}

void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon)
{
    std::vector<Point> points = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    for (unsigned plane = 0; plane < 6; ++plane) {
        Distances distances{};
        for (int k = 0; k < 3; ++k) {
            const glm::dvec4 corner(triangle[static_cast<std::size_t>(k)]);
            if (glm::any(glm::isnan(corner)) || glm::any(glm::isinf(corner))) return;
            const double coordinate = corner[static_cast<int>(plane / 2)];
            distances[k] = corner.w + (plane % 2 == 0 ? coordinate : -coordinate);
        }
        points = clipped(points, distances, plane);
    }

    std::vector<ClipVertex> result;
    for (const Point& point : points) {
        glm::dvec4 position(0);
        for (int k = 0; k < 3; ++k) position += point.weights[k] * glm::dvec4(triangle[static_cast<std::size_t>(k)]);
        for (unsigned plane = 0; plane < 6; ++plane)
            if (((point.planes >> plane) & 1U) != 0)
                position[static_cast<int>(plane / 2)] = plane % 2 == 0 ? -position.w : position.w;
        if (!(position.w > 0)) return;
        const ClipVertex vertex{glm::vec4(position), glm::vec3(point.weights)};
        if (result.empty() || result.back().position != vertex.position) result.push_back(vertex);
    }
    while (result.size() > 1 && result.back().position == result.front().position) result.pop_back();
    if (result.size() > 2) polygon.insert(polygon.end(), result.begin(), result.end());
}

}
