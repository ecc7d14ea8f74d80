// mistake: products of matrices in float, and the angle of an alignment by the arc cosine
// credit: 60..78
// hint: Far from the origin the translation is a difference of nearly equal points, near 0 and 180 degrees the arc
// cosine has lost its digits, and squares of tiny and huge directions are no floats. Compute in double, and take the
// angle by atan2.
#include <cmath>
#include <umbral/transforms/about_a_point.hpp>

namespace umbral::transforms {
namespace {

glm::mat4 about(const glm::vec3& centre, const glm::mat4& m)
{
    return glm::translate(glm::mat4(1), centre) * m * glm::translate(glm::mat4(1), -centre);
}
bool is_null(const glm::vec3& v) { return v == glm::vec3(0); }

}

glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn)
{
    return about(centre, rotation_matrix(turn));
}
glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors)
{
    return about(centre, glm::scale(glm::mat4(1), factors));
}
glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor)
{
    if (is_null(direction)) return glm::mat4(1);
    const glm::vec3 e = normalize(direction);
    return about(point, glm::mat4(glm::mat3(1) + (factor - 1) * glm::outerProduct(e, e)));
}
glm::mat4 reflection_in_point(const glm::vec3& centre)
{
    return about(centre, glm::scale(glm::mat4(1), glm::vec3(-1)));
}

glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction)
{
    if (is_null(direction)) return glm::mat4(1);
    const glm::vec3 e = normalize(direction);
    return about(point, glm::mat4(2.0F * glm::outerProduct(e, e) - glm::mat3(1)));
}

glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal)
{
    if (is_null(normal)) return glm::mat4(1);
    const glm::vec3 n = normalize(normal);
    return about(point, glm::mat4(glm::mat3(1) - 2.0F * glm::outerProduct(n, n)));
}

glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to)
{
    if (is_null(from) || is_null(to)) return glm::mat4(1);
    const glm::vec3 u = normalize(from);
    const glm::vec3 v = normalize(to);
    const glm::vec3 axis = cross(u, v);
    if (axis == glm::vec3(0) && dot(u, v) < 0) {
        const glm::vec3 size = abs(from);
        const int smallest = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
        glm::vec3 e(0);
        e[smallest] = 1;
        return reflection_in_line(glm::vec3(0), cross(u, e));
    }
    return rotation_matrix({axis, std::acos(std::clamp(dot(u, v), -1.0F, 1.0F))});
}

glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction)
{
    glm::mat4 m(1);
    m[3] = glm::vec4(position, 1);
    if (is_null(direction)) return m;
    const glm::vec3 z = normalize(direction);
    const glm::vec3 aside = cross(glm::vec3(0, 1, 0), z);
    const glm::vec3 x = is_null(aside) ? glm::vec3(1, 0, 0) : normalize(aside);
    m[0] = glm::vec4(x, 0);
    m[1] = glm::vec4(cross(z, x), 0);
    m[2] = glm::vec4(z, 0);
    return m;
}

}
