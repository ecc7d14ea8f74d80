// alternative: moves the middle of the box to the origin, then scales; the inverse is that of the product, in double
#include <stdexcept>
#include <umbral/projections/orthographic.hpp>

namespace umbral::projections {
namespace {

glm::dmat4 product(const ViewVolume& box)
{
    const glm::dvec3 low(box.left, box.bottom, -double{box.far_plane});
    const glm::dvec3 high(box.right, box.top, -double{box.near_plane});
    const glm::dvec3 size = high - low;
    if (size.x == 0 || size.y == 0 || size.z == 0) throw std::invalid_argument("the box is flat");

    glm::dmat4 translation(1.0);
    translation[3] = glm::dvec4(-0.5 * (low + high), 1.0);
    glm::dmat4 scaling(1.0);
    scaling[0][0] = 2.0 / size.x;
    scaling[1][1] = 2.0 / size.y;
    scaling[2][2] = -2.0 / size.z;
    return scaling * translation;
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box) { return glm::mat4(product(box)); }

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box) { return glm::mat4(glm::inverse(product(box))); }

}
