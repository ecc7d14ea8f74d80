// Based on: the course's matrix O; J. Foley, A. van Dam, S. Feiner, J. Hughes. Computer Graphics: Principles and
// Practice. 1990, 6.5.

#include <umbral/projections/orthographic.hpp>

#include <stdexcept>

namespace umbral::projections {
namespace {

/// The function scale · x + offset of one coordinate.
struct Map {
    double scale;
    double offset;
};

struct Interval {
    double from;
    double to;
};

// Takes `from` to -1 and `to` to 1. Sums and differences of floats are in the range of double.
Map onto_unit(const Interval& side)
{
    const double size = side.to - side.from;
    return {2 / size, -(side.to + side.from) / size};
}

// Takes -1 to `from` and 1 to `to`.
Map from_unit(const Interval& side) { return {(side.to - side.from) / 2, (side.to + side.from) / 2}; }

glm::mat4 mapped(const ViewVolume& box, Map (*map)(const Interval&))
{
    // The camera looks along -z: the near plane is z = -near_plane.
    const Interval sides[] = {{box.left, box.right}, {box.bottom, box.top}, {-box.near_plane, -box.far_plane}};
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 3; ++axis) {
        if (sides[axis].from == sides[axis].to) throw std::invalid_argument("a box of camera coordinates needs a size");
        const Map along = map(sides[axis]);
        matrix[axis][axis] = static_cast<float>(along.scale);
        matrix[3][axis] = static_cast<float>(along.offset);
    }
    return matrix;
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box) { return mapped(box, onto_unit); }

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box) { return mapped(box, from_unit); }

}
