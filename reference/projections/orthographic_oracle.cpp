#include <umbral/projections/orthographic.hpp>

#include <stdexcept>
#include <wide.hpp>

// With 113 bits, each entry rounded to float once. The offsets follow from what becomes of one corner, instead of from
// the formula.

namespace umbral::projections {
namespace {

struct Corners {
    Wide low[3];
    Wide high[3];
};

Corners corners_of(const ViewVolume& box)
{
    const Corners corners{{box.left, box.bottom, -Wide(box.near_plane)}, {box.right, box.top, -Wide(box.far_plane)}};
    for (int axis = 0; axis < 3; ++axis)
        if (corners.low[axis] == corners.high[axis]) throw std::invalid_argument("flat box");
    return corners;
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box)
{
    const Corners corners = corners_of(box);
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 3; ++axis) {
        const Wide middle = (corners.low[axis] + corners.high[axis]) / 2;
        const Wide scale = 1 / (corners.high[axis] - middle);
        matrix[axis][axis] = static_cast<float>(scale);
        matrix[3][axis] = static_cast<float>(-scale * middle);
    }
    return matrix;
}

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box)
{
    const Corners corners = corners_of(box);
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 3; ++axis) {
        const Wide middle = (corners.low[axis] + corners.high[axis]) / 2;
        matrix[axis][axis] = static_cast<float>(corners.high[axis] - middle);
        matrix[3][axis] = static_cast<float>(middle);
    }
    return matrix;
}

}
