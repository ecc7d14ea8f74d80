#include <umbral/projections/orthographic.hpp>

namespace umbral::projections {

glm::mat4 orthographic_matrix(const ViewVolume& box)
{
    // TODO: a scale on the diagonal and an offset in the last column, for each axis. matrix[3][0] is row 0, column 3.
    // The near plane is z = -near_plane. A box without a size is refused.
    return not_implemented<glm::mat4>(box);
}

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box)
{
    // TODO: what scale and offset take [-1, 1] back to the box?
    return not_implemented<glm::mat4>(box);
}

}
