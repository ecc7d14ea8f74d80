// alternative: in float, with the tangents brought to a common size and their product multiplied out, and a 2 x 2
// matrix inverted by GLM
#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    const Sampler sampler{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    const auto columns = static_cast<float>(heights.width);
    const auto rows = static_cast<float>(heights.height);
    const float right = lookup(heights, sampler, {uv.x + 1 / columns, uv.y}).x;
    const float left = lookup(heights, sampler, {uv.x - 1 / columns, uv.y}).x;
    const float above = lookup(heights, sampler, {uv.x, uv.y + 1 / rows}).x;
    const float below = lookup(heights, sampler, {uv.x, uv.y - 1 / rows}).x;
    return {k * columns * (right - left) / 2, k * rows * (above - below) / 2};
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    const glm::mat2x3 edges(positions[1] - positions[0], positions[2] - positions[0]);
    const glm::mat2 steps(coordinates[1] - coordinates[0], coordinates[2] - coordinates[0]);
    if (determinant(steps) == 0) return {glm::vec3(0), glm::vec3(0)};
    const glm::mat2x3 tangents = edges * inverse(steps);
    return {tangents[0], tangents[1]};
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    float size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(tangents.u[i]), std::abs(tangents.v[i])});
    if (size == 0) return n;
    const glm::vec3 t_u = tangents.u / size;
    const glm::vec3 t_v = tangents.v / size;
    const glm::vec3 flat = cross(t_u, t_v);
    const float side = dot(flat, n);
    if (side == 0) return n;
    const glm::vec3 normal = normalize(flat + slopes.x / size * cross(n, t_v) + slopes.y / size * cross(t_u, n));
    return side > 0 ? normal : -normal;
}

}
