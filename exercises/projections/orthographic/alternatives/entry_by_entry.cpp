// alternative: the course's matrix, written entry by entry
#include <stdexcept>
#include <umbral/projections/orthographic.hpp>

namespace umbral::projections {
namespace {

void require_size(const ViewVolume& box)
{
    if (box.left == box.right || box.bottom == box.top || box.near_plane == box.far_plane)
        throw std::invalid_argument("orthographic_matrix: opposite sides are equal");
}

}

glm::mat4 orthographic_matrix(const ViewVolume& box)
{
    require_size(box);
    const double l = box.left;
    const double r = box.right;
    const double b = box.bottom;
    const double t = box.top;
    const double n = box.near_plane;
    const double f = box.far_plane;
    glm::dmat4 matrix(1.0);
    matrix[0][0] = 2 / (r - l);
    matrix[1][1] = 2 / (t - b);
    matrix[2][2] = -2 / (f - n);
    matrix[3][0] = -(r + l) / (r - l);
    matrix[3][1] = -(t + b) / (t - b);
    matrix[3][2] = -(f + n) / (f - n);
    return glm::mat4(matrix);
}

glm::mat4 inverse_orthographic_matrix(const ViewVolume& box)
{
    require_size(box);
    glm::dmat4 matrix(1.0);
    matrix[0][0] = (double{box.right} - box.left) / 2;
    matrix[1][1] = (double{box.top} - box.bottom) / 2;
    matrix[2][2] = (double{box.near_plane} - box.far_plane) / 2;
    matrix[3][0] = (double{box.right} + box.left) / 2;
    matrix[3][1] = (double{box.top} + box.bottom) / 2;
    matrix[3][2] = -(double{box.near_plane} + box.far_plane) / 2;
    return glm::mat4(matrix);
}

}
