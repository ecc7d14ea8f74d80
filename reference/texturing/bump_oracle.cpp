#include <cmath>
#include <umbral/texturing/bump.hpp>

// In long double: heights by their own blend of the four texels round a place, tangents as the solution for each axis,
// and the raised surface's normal as the flat one less the slopes' gradient, which lies in the surface.

namespace umbral::texturing {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

Vector wide(const glm::vec3& v) { return {v.x, v.y, v.z}; }

Vector cross_of(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dot_of(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Real height_at(const Grid<glm::vec4>& heights, Real u, Real v)
{
    const Real x = (u - std::floor(u)) * heights.width - 0.5L;
    const Real y = (v - std::floor(v)) * heights.height - 0.5L;
    const Real left = std::floor(x);
    const Real below = std::floor(y);
    Real sum = 0;
    for (int k = 0; k < 4; ++k) {
        const int i = static_cast<int>(left) + k % 2;
        const int j = static_cast<int>(below) + k / 2;
        const Real weight = (k % 2 == 1 ? x - left : left + 1 - x) * (k / 2 == 1 ? y - below : below + 1 - y);
        const int row = (j + 2 * heights.height) % heights.height;
        sum += weight * heights.at((i + 2 * heights.width) % heights.width, heights.height - 1 - row).r;
    }
    return sum;
}

}

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    const Real du = 1.0L / heights.width;
    const Real dv = 1.0L / heights.height;
    const Real along_u = height_at(heights, uv.x + du, uv.y) - height_at(heights, uv.x - du, uv.y);
    const Real along_v = height_at(heights, uv.x, uv.y + dv) - height_at(heights, uv.x, uv.y - dv);
    return {k * along_u / (2 * du), k * along_v / (2 * dv)};
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    // By the cofactors of the 3 x 3 system: the weights with which the three corners add up to each tangent.
    const auto u = [&](std::size_t i) { return Real{coordinates[i % 3].x}; };
    const auto v = [&](std::size_t i) { return Real{coordinates[i % 3].y}; };
    const Real area = u(0) * (v(1) - v(2)) + u(1) * (v(2) - v(0)) + u(2) * (v(0) - v(1));
    if (area == 0) return {};
    Tangents result;
    for (int axis = 0; axis < 3; ++axis) {
        Real by_u = 0;
        Real by_v = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            by_u += positions[i][axis] * (v(i + 1) - v(i + 2)) / area;
            by_v += positions[i][axis] * (u(i + 2) - u(i + 1)) / area;
        }
        result.u[axis] = static_cast<float>(by_u);
        result.v[axis] = static_cast<float>(by_v);
    }
    return result;
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    const Vector normal = wide(n);
    const Vector t_u = wide(tangents.u);
    const Vector t_v = wide(tangents.v);
    const Vector flat = cross_of(t_u, t_v);
    const Real side = dot_of(flat, normal);
    if (side == 0) return n;
    const Vector by_u = cross_of(normal, t_v);
    const Vector by_v = cross_of(t_u, normal);
    Vector raised{};
    for (std::size_t i = 0; i < 3; ++i) raised[i] = flat[i] + slopes.x * by_u[i] + slopes.y * by_v[i];
    const Real length = std::copysign(std::sqrt(dot_of(raised, raised)), side);
    return {raised[0] / length, raised[1] / length, raised[2] / length};
}

}
