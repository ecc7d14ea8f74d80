// alternative: alignment by the axis and the angle of atan2, and objects placed by yaw and pitch
#include <cmath>
#include <umbral/transforms/about_a_point.hpp>

namespace umbral::transforms {
namespace {

using Long = long double;
using Vector = glm::vec<3, Long>;
using Matrix3 = glm::mat<3, 3, Long>;
using Matrix4 = glm::mat<4, 4, Long>;

Matrix4 translation(const Vector& d)
{
    Matrix4 m(1);
    m[3] = glm::vec<4, Long>(d, 1);
    return m;
}

glm::mat4 about(const glm::vec3& centre, const Matrix3& m)
{
    return glm::mat4(translation(Vector(centre)) * Matrix4(m) * translation(-Vector(centre)));
}

Vector unit(const glm::vec3& v) { return Vector(v) / length(Vector(v)); }

/// The rotation of a quaternion of any length.
Matrix3 rotation(Long w, const Vector& v)
{
    const Long square = w * w + dot(v, v);
    const Matrix3 across(cross(v, {1, 0, 0}), cross(v, {0, 1, 0}), cross(v, {0, 0, 1}));
    return Matrix3(1) + 2 / square * (w * across + across * across);
}

bool finite(const AxisAngle& turn)
{
    return std::isfinite(turn.axis.x + turn.axis.y + turn.axis.z) && std::isfinite(turn.angle);
}

}

glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn)
{
    if (turn.axis == glm::vec3(0) || !finite(turn)) return glm::mat4(1);
    const Long half = Long{turn.angle} / 2;
    return about(centre, rotation(std::cos(half), std::sin(half) * unit(turn.axis)));
}

glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors)
{
    Matrix3 m(1);
    for (int i = 0; i < 3; ++i) m[i][i] = factors[i];
    return about(centre, m);
}

// Turned so that the direction becomes z, scaled there, and turned back.
glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor)
{
    if (direction == glm::vec3(0)) return glm::mat4(1);
    const Vector z = unit(direction);
    const Vector aside = std::abs(z.x) < Long(0.8) ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector x = normalize(cross(aside, z));
    const Matrix3 axes(x, cross(z, x), z);
    Matrix3 scaled(1);
    scaled[2][2] = factor;
    return about(point, axes * scaled * transpose(axes));
}

glm::mat4 reflection_in_point(const glm::vec3& centre) { return about(centre, Matrix3(-1)); }

glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction)
{
    return direction == glm::vec3(0) ? glm::mat4(1) : about(point, rotation(0, unit(direction)));
}

glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return glm::mat4(1);
    const Vector n = unit(normal);
    return about(point, Matrix3(1) - Long(2) * outerProduct(n, n));
}

glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to)
{
    if (from == glm::vec3(0) || to == glm::vec3(0)) return glm::mat4(1);
    const Vector u(from);
    const Vector v(to);
    const Vector axis = cross(u, v);
    const Long angle = std::atan2(length(axis), dot(u, v));
    if (angle == 0) return glm::mat4(1);
    if (axis != Vector(0))
        return about(glm::vec3(0), rotation(std::cos(angle / 2), std::sin(angle / 2) * axis / length(axis)));
    int smallest = 0;
    for (const int i : {1, 2})
        if (std::abs(from[i]) < std::abs(from[smallest])) smallest = i;
    Vector e(0);
    e[smallest] = 1;
    return about(glm::vec3(0), rotation(0, cross(u, e)));
}

glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction)
{
    if (direction == glm::vec3(0)) return glm::mat4(translation(Vector(position)));
    const Long yaw = std::atan2(Long{direction.x}, Long{direction.z});
    const Long pitch = std::atan2(Long{direction.y}, std::hypot(Long{direction.x}, Long{direction.z}));
    const Vector x(std::cos(yaw), 0, -std::sin(yaw));
    const Vector z(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    return glm::mat4(translation(Vector(position)) * Matrix4(Matrix3(x, cross(z, x), z)));
}

}
