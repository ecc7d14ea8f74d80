#include <umbral/projections/view.hpp>

#include <cmath>
#include <utility>

// Every entry with at least 64 bits, rounded to float once. Gram-Schmidt instead of the cross product u×n: another way
// to the same frame, so that an error of one of them shows.

namespace umbral::projections {
namespace {

using Wide = long double;
using WideVector = glm::vec<3, Wide>;

WideVector unit(const WideVector& v) { return v / std::sqrt(dot(v, v)); }

WideVector without_part_along(const WideVector& v, const WideVector& axis) { return v - dot(v, axis) * axis; }

/// `up` made perpendicular to the unit vector `z`, or the first of the axes that has most left when this is done.
WideVector vertical(const WideVector& up, const WideVector& z)
{
    const Wide size = std::sqrt(dot(up, up));
    if (size > 0) {
        const WideVector rest = without_part_along(up / size, z);
        if (dot(rest, rest) >= Wide(1e-6) * Wide(1e-6)) return unit(rest);
    }
    int best = 0;
    for (const int axis : {1, 2})
        if (std::abs(z[axis]) < std::abs(z[best])) best = axis;
    WideVector chosen(0);
    chosen[best] = 1;
    return unit(without_part_along(chosen, z));
}

}

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    const WideVector o(eye);
    const WideVector z = eye == target ? WideVector(0, 0, 1) : unit(o - WideVector(target));
    // Twice is enough: what the first pass leaves along z, the second one takes away.
    const WideVector y = unit(without_part_along(vertical(WideVector(up), z), z));
    const WideVector x = cross(y, z);

    glm::mat4 view(1);
    int row = 0;
    for (const WideVector& axis : {x, y, z}) {
        for (int column = 0; column < 3; ++column) view[column][row] = static_cast<float>(axis[column]);
        view[3][row] = static_cast<float>(-dot(axis, o));
        ++row;
    }
    return view;
}

}
