#include <umbral/projections/perspective.hpp>

namespace umbral::projections {

glm::mat4 perspective_matrix(const Lens& lens)
{
    // TODO: half the height of the picture at distance 1 is a tangent; its width follows from the aspect. The depths
    // are those of a frustum. Angles come in degrees.
    return not_implemented<glm::mat4>(lens);
}

glm::mat4 reversed_perspective_matrix(const Lens& lens)
{
    // TODO: only the depths differ: 1 at the near plane, 0 at the far one.
    return not_implemented<glm::mat4>(lens);
}

float vertical_field_of_view(float fovx_degrees, float aspect)
{
    // TODO: half the width at distance 1, then half the height, then the angle.
    return not_implemented<float>(fovx_degrees, aspect);
}

}
