#include <umbral/texturing/coordinates.hpp>

namespace umbral::texturing {

glm::vec2 planar_coordinates(const glm::vec3& point, const TexturePlane& plane)
{
    // TODO: measure how far the point lies from the plane's origin along each of its two axes.
    return not_implemented<glm::vec2>(point, plane);
}

glm::vec2 spherical_coordinates(const glm::vec3& point)
{
    // TODO: 1. the longitude, by atan2, and from it u in [0, 1]
    //       2. the latitude, by atan2 again, and from it v in [0, 1]
    //       3. the axis has no longitude; and what does atan2 make of -0?
    return not_implemented<glm::vec2>(point);
}

glm::vec2 cylindrical_coordinates(const glm::vec3& point, float y_min, float y_max)
{
    // TODO: u as on the sphere; v by the height; a cylinder may have none.
    return not_implemented<glm::vec2>(point, y_min, y_max);
}

std::vector<glm::vec2> parametric_coordinates(int columns, int rows)
{
    // TODO: one pair for each vertex of the grid, row by row; refuse a grid without cells.
    return not_implemented<std::vector<glm::vec2>>(columns, rows);
}

std::array<glm::vec2, 3> spherical_triangle(const std::array<glm::vec3, 3>& corners)
{
    // TODO: 1. the three corners' own coordinates
    //       2. does the triangle cross the seam? Then move the corners that lie behind it one turn on
    //       3. corners on the axis take the mean of the others
    return not_implemented<std::array<glm::vec2, 3>>(corners);
}

}
