// alternative: the surface's normal less the gradient of the height in it, in double; tangents by an inverse matrix
#include <cmath>
#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    glm::vec2 result(0);
    for (int axis = 0; axis < 2; ++axis) {
        const auto count = static_cast<float>(axis == 0 ? heights.width : heights.height);
        glm::vec2 step(0);
        step[axis] = 1 / count;
        const glm::vec4 ahead = lookup(heights, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, uv + step);
        const glm::vec4 behind = lookup(heights, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, uv - step);
        result[axis] = k * (ahead.r - behind.r) * 0.5F * count;
    }
    return result;
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    glm::dmat2 steps(0);
    glm::dmat2x3 edges(0);
    for (int i = 0; i < 2; ++i) {
        const auto k = static_cast<std::size_t>(i) + 1;
        steps[i] = glm::dvec2(coordinates[k]) - glm::dvec2(coordinates[0]);
        edges[i] = glm::dvec3(positions[k]) - glm::dvec3(positions[0]);
    }
    const double area = determinant(steps);
    Tangents tangents;
    if (area != 0) {
        tangents.u = (edges[0] * steps[1].y - edges[1] * steps[0].y) / area;
        tangents.v = (edges[1] * steps[0].x - edges[0] * steps[1].x) / area;
    }
    return tangents;
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    const glm::dvec3 normal(n);
    const glm::dvec3 u(tangents.u);
    const glm::dvec3 v(tangents.v);
    const double volume = dot(cross(u, v), normal);
    if (volume == 0.0) return n;
    // If n is perpendicular to the surface, the vector in it whose products with the tangents are the slopes.
    const glm::dvec3 gradient =
        (cross(v, normal) * static_cast<double>(slopes.x) + cross(normal, u) * static_cast<double>(slopes.y)) / volume;
    // n itself need not be perpendicular to the surface.
    return normalize(cross(u, v) / volume - gradient);
}

}
