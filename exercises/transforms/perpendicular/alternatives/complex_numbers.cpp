// alternative: the plane as complex numbers, where P is a product with i; the matrix of P_e written entry by entry
#include <cmath>
#include <umbral/transforms/perpendicular.hpp>

namespace umbral::transforms {
namespace {

/// x + i y.
using Complex = glm::dvec2;

Complex product(const Complex& a, const Complex& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Complex conjugate(const Complex& a) { return {a.x, -a.y}; }
constexpr Complex i(0, 1);

// The frame's axes are e and ±i e: in a mirrored frame P is the product with -i.
Complex unit_of(const PlaneFrame& frame)
{
    return product(conjugate(Complex(frame.x)), Complex(frame.y)).y < 0 ? conjugate(i) : i;
}

}

glm::vec2 turn_left(const glm::vec2& u) { return glm::vec2(product(i, Complex(u))); }
glm::vec2 turn_right(const glm::vec2& u) { return glm::vec2(product(conjugate(i), Complex(u))); }
glm::vec2 turn_vector_in(const PlaneFrame& frame, const glm::vec2& u)
{
    return glm::vec2(product(unit_of(frame), Complex(u)));
}

glm::vec2 turn_point_in(const PlaneFrame& frame, const glm::vec2& point)
{
    const Complex origin(frame.origin);
    return glm::vec2(origin + product(unit_of(frame), Complex(point) - origin));
}

glm::vec2 rotate_in_plane(const glm::vec2& u, float angle)
{
    return glm::vec2(product({std::cos(double{angle}), std::sin(double{angle})}, Complex(u)));
}

glm::mat3 plane_rotation_matrix(float angle)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return glm::transpose(glm::mat3(c, -s, 0, s, c, 0, 0, 0, 1));
}

glm::vec3 across(const glm::vec3& e, const glm::vec3& u) { return across_matrix(e) * u; }

glm::mat3 across_matrix(const glm::vec3& e)
{
    return glm::transpose(glm::mat3(0, -e.z, e.y, e.z, 0, -e.x, -e.y, e.x, 0));
}

}
