#include <cmath>
#include <umbral/pipeline/clip.hpp>

#include "wide.hpp"

// Corners as weights with 113 bits; the distances to all six planes are linear in them. Positions are made from weights
// at the end, and everything is rounded to float once.

namespace umbral::pipeline {
namespace {

// A point of the triangle, and the planes that it was put on.
struct Point {
    std::array<Wide, 3> weights;
    unsigned on = 0;
};

// -w <= x, x <= w, -w <= y, ...
Wide sign_of(int plane) { return plane % 2 == 0 ? -1 : 1; }

Wide coordinate(const std::array<glm::vec4, 3>& triangle, const Point& point, int axis)
{
    Wide sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += point.weights[i] * Wide(triangle[i][axis]);
    return sum;
}

// 0 on a plane that the point was put on, where rounding would say otherwise.
Wide distance(const std::array<glm::vec4, 3>& triangle, const Point& point, int plane)
{
    if (((point.on >> plane) & 1U) != 0) return 0;
    return coordinate(triangle, point, 3) - sign_of(plane) * coordinate(triangle, point, plane / 2);
}

std::vector<Point> clipped(const std::array<glm::vec4, 3>& triangle, const std::vector<Point>& points, int plane)
{
    std::vector<Point> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& a = points[i];
        const Point& b = points[(i + 1) % points.size()];
        const Wide at_a = distance(triangle, a, plane);
        const Wide at_b = distance(triangle, b, plane);
        if (at_a >= 0) result.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
            Point between{{}, (a.on & b.on) | (1U << plane)};
            for (std::size_t k = 0; k < 3; ++k)
                between.weights[k] = (at_a * b.weights[k] - at_b * a.weights[k]) / (at_a - at_b);
            result.push_back(between);
        }
    }
    return result;
}

ClipVertex rounded(const std::array<glm::vec4, 3>& triangle, const Point& point)
{
    ClipVertex vertex{};
    const Wide w = coordinate(triangle, point, 3);
    vertex.position.w = static_cast<float>(w);
    for (int axis = 0; axis < 3; ++axis) {
        Wide value = coordinate(triangle, point, axis);
        for (const int plane : {2 * axis, 2 * axis + 1})
            if (((point.on >> plane) & 1U) != 0) value = sign_of(plane) * w;
        vertex.position[axis] = static_cast<float>(value > w ? w : value < -w ? -w : value);
        vertex.weights[axis] = static_cast<float>(point.weights[static_cast<std::size_t>(axis)]);
    }
    return vertex;
}

}

void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon)
{
    for (const glm::vec4& corner : triangle)
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(corner[i])) return;

    std::vector<Point> points = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    for (int plane = 0; plane < 6; ++plane) points = clipped(triangle, points, plane);

    std::vector<ClipVertex> vertices;
    for (const Point& point : points) {
        const ClipVertex vertex = rounded(triangle, point);
        if (!(vertex.position.w > 0)) return;
        if (vertices.empty() || vertex.position != vertices.back().position) vertices.push_back(vertex);
    }
    while (vertices.size() > 1 && vertices.back().position == vertices.front().position) vertices.pop_back();
    if (vertices.size() >= 3) polygon.insert(polygon.end(), vertices.begin(), vertices.end());
}

}
