#include <cmath>
#include <umbral/transforms/about_a_point.hpp>

#include "wide_vector.hpp"

// In __float128 but for the sine and the cosine, which have 64 bits; rounded to float once. Images of points instead of
// products of matrices.

namespace umbral::transforms {
namespace {

/// `moves(p)` is how far a point at p from the centre goes.
template <class Moves>
glm::mat4 about(const glm::vec3& centre, Moves moves)
{
    glm::mat4 m(1);
    for (int column = 0; column < 4; ++column) {
        WideVector axis{0, 0, 0};
        if (column < 3) axis[static_cast<std::size_t>(column)] = 1;
        const WideVector move = column < 3 ? moves(axis) : Wide(-1) * moves(widened(centre));
        for (int row = 0; row < 3; ++row)
            m[column][row] = static_cast<float>(move[static_cast<std::size_t>(row)] + (row == column ? 1 : 0));
    }
    return m;
}

auto mirror(const WideVector& n)
{
    return [n](const WideVector& p) { return -2 * dot(n, p) * n; };
}

auto half_turn(const WideVector& e)
{
    return [e](const WideVector& p) { return 2 * dot(e, p) * e - Wide(2) * p; };
}

}

glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn)
{
    const bool finite = std::isfinite(turn.axis.x) && std::isfinite(turn.axis.y) && std::isfinite(turn.axis.z) &&
                        std::isfinite(turn.angle);
    if (is_null(widened(turn.axis)) || !finite) return glm::mat4(1);
    const WideVector e = unit(widened(turn.axis));
    const Wide sine = std::sin(static_cast<long double>(turn.angle));
    const Wide half = std::sin(static_cast<long double>(turn.angle) / 2);
    return about(centre, [&](const WideVector& p) {
        const WideVector aside = cross(e, p);
        return sine * aside + 2 * half * half * cross(e, aside);
    });
}

glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors)
{
    const WideVector f = widened(factors);
    return about(centre, [&](const WideVector& p) {
        return WideVector{(f[0] - 1) * p[0], (f[1] - 1) * p[1], (f[2] - 1) * p[2]};
    });
}

glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor)
{
    if (is_null(widened(direction))) return glm::mat4(1);
    const WideVector e = unit(widened(direction));
    return about(point, [&](const WideVector& p) { return (Wide{factor} - 1) * dot(e, p) * e; });
}

glm::mat4 reflection_in_point(const glm::vec3& centre)
{
    return about(centre, [](const WideVector& p) { return Wide(-2) * p; });
}

glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction)
{
    return is_null(widened(direction)) ? glm::mat4(1) : about(point, half_turn(unit(widened(direction))));
}

glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal)
{
    return is_null(widened(normal)) ? glm::mat4(1) : about(point, mirror(unit(widened(normal))));
}

// With e the unit normal of the plane of both: p' = p + sinθ e × p + (1 - cosθ) e × (e × p).
glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to)
{
    const WideVector u = widened(from);
    const WideVector v = widened(to);
    if (is_null(u) || is_null(v)) return glm::mat4(1);
    const WideVector normal = cross(u, v);
    const Wide size = square_root(dot(u, u) * dot(v, v));
    if (is_null(normal)) {
        if (dot(u, v) > 0) return glm::mat4(1);
        std::size_t smallest = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (std::abs(from[static_cast<int>(i)]) < std::abs(from[static_cast<int>(smallest)])) smallest = i;
        WideVector axis{0, 0, 0};
        axis[smallest] = 1;
        return about(glm::vec3(0), half_turn(unit(cross(u, axis))));
    }
    const WideVector e = unit(normal);
    const Wide sine = dot(e, normal) / size;
    const Wide versine = 1 - dot(u, v) / size;
    return about(glm::vec3(0), [&](const WideVector& p) {
        const WideVector aside = cross(e, p);
        return sine * aside + versine * cross(e, aside);
    });
}

glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction)
{
    glm::mat4 m(1);
    if (!is_null(widened(direction))) {
        const WideVector z = unit(widened(direction));
        const WideVector aside = cross({0, 1, 0}, widened(direction));
        const WideVector x = is_null(aside) ? WideVector{1, 0, 0} : unit(aside);
        const WideVector y = cross(z, x);
        for (int row = 0; row < 3; ++row) {
            const auto i = static_cast<std::size_t>(row);
            m[0][row] = static_cast<float>(x[i]);
            m[1][row] = static_cast<float>(y[i]);
            m[2][row] = static_cast<float>(z[i]);
        }
    }
    m[3] = glm::vec4(position, 1);
    return m;
}

}
