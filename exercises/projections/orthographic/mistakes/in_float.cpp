// mistake: adds the sides in float, where large ones overflow
// credit: 88..97
// hint: The largest float is 3.4e38: the sum of two sides of 2e38 is infinite, though its half is not. Halve first, or
// compute in double.
#include <stdexcept>
#include <umbral/projections/orthographic.hpp>

namespace umbral::projections {
namespace {

void require_size(const ViewVolume& box)
{
    if (box.left == box.right || box.bottom == box.top || box.near_plane == box.far_plane)
        throw std::invalid_argument("opposite sides are equal");
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box)
{
    require_size(box);
    const auto [l, r, b, t, n, f] = box;
    glm::mat4 matrix(1);
    matrix[0][0] = 2 / (r - l);
    matrix[1][1] = 2 / (t - b);
    matrix[2][2] = -2 / (f - n);
    matrix[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
    return matrix;
}

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box)
{
    require_size(box);
    const auto [l, r, b, t, n, f] = box;
    glm::mat4 matrix(1);
    matrix[0][0] = (r - l) / 2;
    matrix[1][1] = (t - b) / 2;
    matrix[2][2] = -(f - n) / 2;
    matrix[3] = {(r + l) / 2, (t + b) / 2, -(f + n) / 2, 1};
    return matrix;
}

}
