// Based on: C. Ureña. Informática Gráfica, tema 2, "rotaciones sobre puntos arbitrarios". 2021; two mirrors make a
// rotation by twice their angle: É. Cartan. Leçons sur la théorie des spineurs. 1938.

#include <cmath>
#include <umbral/transforms/about_a_point.hpp>

namespace umbral::transforms {
namespace {

using Vector = glm::dvec3;
using Matrix = glm::dmat3;

// In double, no square of a float overflows or vanishes.
Vector unit(const glm::vec3& v) { return Vector(v) / length(Vector(v)); }

bool is_null(const glm::vec3& v) { return v == glm::vec3(0); }

/// p' = centre + (I + D)(p - centre), by the change D = M - I: the translation -D · centre subtracts nothing.
glm::mat4 about(const glm::vec3& centre, const Matrix& change)
{
    glm::mat4 m{glm::mat3(Matrix(1) + change)};
    m[3] = glm::vec4(-(change * Vector(centre)), 1);
    return m;
}

Matrix mirror_change(const Vector& n) { return -2.0 * outerProduct(n, n); }

Matrix half_turn_change(const Vector& e) { return Matrix(-2) - mirror_change(e); }

/// The change of Rodrigues' formula: sinθ [e]× + (1 - cosθ) [e]×².
Matrix rotation_change(const AxisAngle& turn)
{
    const Vector e = unit(turn.axis);
    const Matrix across(cross(e, {1, 0, 0}), cross(e, {0, 1, 0}), cross(e, {0, 0, 1}));
    const double half = std::sin(0.5 * double{turn.angle});
    return std::sin(double{turn.angle}) * across + 2 * half * half * across * across;
}

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Vector axis_of_smallest(const glm::vec3& v)
{
    int smallest = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(v[i]) < std::abs(v[smallest])) smallest = i;
    Vector axis(0);
    axis[smallest] = 1;
    return axis;
}

}

glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn)
{
    if (is_null(turn.axis) || !finite(turn.axis) || !std::isfinite(turn.angle)) return glm::mat4(1);
    return about(centre, rotation_change(turn));
}

glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors)
{
    Matrix change(0);
    for (int i = 0; i < 3; ++i) change[i][i] = double{factors[i]} - 1;
    return about(centre, change);
}

glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor)
{
    if (is_null(direction)) return glm::mat4(1);
    const Vector e = unit(direction);
    return about(point, (double{factor} - 1) * outerProduct(e, e));
}

glm::mat4 reflection_in_point(const glm::vec3& centre) { return about(centre, Matrix(-2)); }

glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction)
{
    if (is_null(direction)) return glm::mat4(1);
    return about(point, half_turn_change(unit(direction)));
}

glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal)
{
    if (is_null(normal)) return glm::mat4(1);
    return about(point, mirror_change(unit(normal)));
}

// A mirror across u takes u to -u; one across the bisector of u and v takes -u to v. What is perpendicular to both
// stays.
glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to)
{
    if (is_null(from) || is_null(to)) return glm::mat4(1);
    const Vector u = unit(from);
    const Vector v = unit(to);
    // The products of floats are exact in double, so this is 0 for parallel vectors and for no others.
    const bool parallel = cross(Vector(from), Vector(to)) == Vector(0);
    if (parallel && dot(u, v) > 0) return glm::mat4(1);
    if (parallel) return about(glm::vec3(0), half_turn_change(normalize(cross(u, axis_of_smallest(from)))));
    const Vector bisector = normalize(u + v);
    return about(glm::vec3(0), (Matrix(1) + mirror_change(bisector)) * (Matrix(1) + mirror_change(u)) - Matrix(1));
}

glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction)
{
    Matrix axes(1);
    if (!is_null(direction)) {
        const glm::vec3 aside(direction.z, 0, -direction.x);  // Y × direction
        const Vector x = is_null(aside) ? Vector(1, 0, 0) : unit(aside);
        const Vector z = unit(direction);
        axes = Matrix(x, cross(z, x), z);
    }
    glm::mat4 m{glm::mat3(axes)};
    m[3] = glm::vec4(position, 1);
    return m;
}

}
