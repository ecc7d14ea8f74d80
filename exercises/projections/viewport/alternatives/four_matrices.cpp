// alternative: the course's product of four matrices; back by the inverse matrix; pixels through the matrix
#include <umbral/projections/viewport.hpp>

namespace umbral::projections {
namespace {

glm::dmat4 moved(const glm::dvec3& by)
{
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(by, 1.0);
    return matrix;
}

glm::dmat4 scaled(const glm::dvec3& by)
{
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) matrix[i][i] = by[i];
    return matrix;
}

glm::dmat4 wide_matrix(const Viewport& v)
{
    return moved({v.left, v.bottom, v.near_depth}) * scaled({v.width, v.height, double{v.far_depth} - v.near_depth}) *
           scaled(glm::dvec3(0.5)) * moved(glm::dvec3(1.0));
}

}

glm::mat4 viewport_matrix(const Viewport& viewport) { return glm::mat4(wide_matrix(viewport)); }

glm::vec3 ndc_from_window(const Viewport& viewport, const glm::vec3& window)
{
    return glm::vec3(glm::inverse(wide_matrix(viewport)) * glm::dvec4(window, 1.0));
}

std::optional<glm::ivec2> pixel_at(const Viewport& viewport, const glm::vec2& ndc)
{
    // Counted from the viewport's corner: with a far one added a double loses the last digits.
    const glm::dvec2 place(wide_matrix({0, 0, viewport.width, viewport.height}) * glm::dvec4(ndc, 0.0, 1.0));
    const bool inside = place.x >= 0 && place.y >= 0 && place.x < viewport.width && place.y < viewport.height;
    if (!inside) return {};
    return glm::ivec2(viewport.left, viewport.bottom) + glm::ivec2(place);
}

glm::vec2 pixel_centre(const Viewport& viewport, const glm::ivec2& pixel)
{
    return glm::vec2(ndc_from_window(viewport, glm::vec3(glm::vec2(pixel) + 0.5F, 0.0F)));
}

}
