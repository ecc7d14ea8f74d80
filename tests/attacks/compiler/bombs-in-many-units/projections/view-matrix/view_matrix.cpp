// Based on: the course's view frame (z = n/|n|, x = u×n/|u×n|, y = z×x) and V = R·Tra[-o]; problems 3.3 and 3.4.

#include <umbral/projections/view.hpp>

#include <cmath>

namespace umbral::projections {
namespace {

/// Below this sine of the angle between them, `up` says nothing about the view's roll.
constexpr double parallel_sine = 1e-6;

// Of equals, the first.
glm::dvec3 most_perpendicular_axis(const glm::dvec3& direction)
{
    const glm::dvec3 size = abs(direction);
    if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
    return size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

}

// In double throughout: u×n subtracts products that agree in nearly all digits if u is almost parallel to n, and so
// does x·o if the eye is far away. Each entry is rounded to float once, at the end.
glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const glm::dvec3 o(eye);
    const glm::dvec3 u(up);
    const glm::dvec3 n = eye == target ? glm::dvec3(0, 0, 1) : o - glm::dvec3(target);

    // The camera's axes in world coordinates: it looks along -z.
    const glm::dvec3 z = normalize(n);
    const glm::dvec3 side = cross(u, z);
    const bool parallel = length(side) < parallel_sine * length(u) || length(u) == 0;
    const glm::dvec3 x = normalize(parallel ? cross(most_perpendicular_axis(z), z) : side);
    const glm::dvec3 y = cross(z, x);

    // The axes are the rows. GLM's constructor takes columns.
    return glm::mat4(glm::dmat4(x.x, y.x, z.x, 0,  //
                                x.y, y.y, z.y, 0,  //
                                x.z, y.z, z.z, 0,  //
                                -dot(x, o), -dot(y, o), -dot(z, o), 1));
}

}
namespace n1 {
template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};
template <int I> struct B<0, I> {};
B<24, 0> all;
}
