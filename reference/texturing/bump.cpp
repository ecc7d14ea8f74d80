// Based on: J. Blinn. Simulation of Wrinkled Surfaces. SIGGRAPH 1978.

#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    const auto height = [&](float du, float dv) {
        return lookup(heights, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, uv + glm::vec2(du, dv)).r;
    };
    const glm::vec2 step = 1.0F / glm::vec2(heights.width, heights.height);
    return k * glm::vec2(height(step.x, 0) - height(-step.x, 0), height(0, step.y) - height(0, -step.y)) /
           (2.0F * step);
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    // Two edges: e1 = u1 t_u + v1 t_v and e2 = u2 t_u + v2 t_v, solved by Cramer's rule.
    const glm::dvec3 e1 = glm::dvec3(positions[1]) - glm::dvec3(positions[0]);
    const glm::dvec3 e2 = glm::dvec3(positions[2]) - glm::dvec3(positions[0]);
    const glm::dvec2 c1 = glm::dvec2(coordinates[1]) - glm::dvec2(coordinates[0]);
    const glm::dvec2 c2 = glm::dvec2(coordinates[2]) - glm::dvec2(coordinates[0]);
    const double area = c1.x * c2.y - c2.x * c1.y;
    if (area == 0) return {};
    return {(c2.y * e1 - c1.y * e2) / area, (c1.x * e2 - c2.x * e1) / area};
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    const glm::dvec3 normal(n);
    const glm::dvec3 t_u(tangents.u);
    const glm::dvec3 t_v(tangents.v);
    const double side = dot(cross(t_u, t_v), normal);
    if (side == 0) return n;
    const glm::dvec3 raised = cross(t_u + double{slopes.x} * normal, t_v + double{slopes.y} * normal);
    return normalize(side < 0 ? -raised : raised);
}

}
