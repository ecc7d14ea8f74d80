// alternative: float throughout; halves are taken before they are added, so that nothing overflows
#include <stdexcept>
#include <umbral/projections/orthographic.hpp>

namespace umbral::projections {
namespace {

struct MiddleAndHalf {
    glm::vec3 middle;
    glm::vec3 half;
};

MiddleAndHalf measured(const ViewVolume& box)
{
    if (box.left == box.right || box.bottom == box.top || box.near_plane == box.far_plane)
        throw std::invalid_argument("flat");
    const glm::vec3 from = 0.5F * glm::vec3(box.left, box.bottom, -box.near_plane);
    const glm::vec3 to = 0.5F * glm::vec3(box.right, box.top, -box.far_plane);
    return {from + to, to - from};
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box)
{
    const auto [middle, half] = measured(box);
    return {{1 / half.x, 0, 0, 0},
            {0, 1 / half.y, 0, 0},
            {0, 0, 1 / half.z, 0},
            {-middle.x / half.x, -middle.y / half.y, -middle.z / half.z, 1}};
}

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box)
{
    const auto [middle, half] = measured(box);
    return {{half.x, 0, 0, 0}, {0, half.y, 0, 0}, {0, 0, half.z, 0}, {middle, 1}};
}

}
