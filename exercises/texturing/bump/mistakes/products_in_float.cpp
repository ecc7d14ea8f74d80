// mistake: multiplies tangents of any size in float
// credit: 93..98
// hint: Tangents of 10²⁵, or of 10⁻²⁵, have cross products that no float can hold: use double, or divide all by a
// common length first.
#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    constexpr Sampler sampler{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    const glm::vec2 du(1.0F / static_cast<float>(heights.width), 0);
    const glm::vec2 dv(0, 1.0F / static_cast<float>(heights.height));
    return {k * (lookup(heights, sampler, uv + du).r - lookup(heights, sampler, uv - du).r) / (2 * du.x),
            k * (lookup(heights, sampler, uv + dv).r - lookup(heights, sampler, uv - dv).r) / (2 * dv.y)};
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    const glm::vec3 e1 = positions[1] - positions[0];
    const glm::vec3 e2 = positions[2] - positions[0];
    const glm::vec2 c1 = coordinates[1] - coordinates[0];
    const glm::vec2 c2 = coordinates[2] - coordinates[0];
    const float area = c1.x * c2.y - c2.x * c1.y;
    if (area == 0) return {};
    return {(c2.y * e1 - c1.y * e2) / area, (c1.x * e2 - c2.x * e1) / area};
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    const float side = dot(cross(tangents.u, tangents.v), n);
    if (side == 0) return n;
    const glm::vec3 raised = cross(tangents.u + slopes.x * n, tangents.v + slopes.y * n);
    return normalize(side < 0 ? -raised : raised);
}

}
