#include <umbral/projections/viewport.hpp>

namespace umbral::projections {

glm::mat4 viewport_matrix(const Viewport& viewport)
{
    // TODO: move [-1, 1] to [0, 2], scale by half the size, move to the corner. matrix[3][0] is row 0, column 3.
    return not_implemented<glm::mat4>(viewport);
}

glm::vec3 ndc_from_window(const Viewport& viewport, const glm::vec3& window)
{
    // TODO: undo the three steps in the opposite order.
    return not_implemented<glm::vec3>(viewport, window);
}

std::optional<glm::ivec2> pixel_at(const Viewport& viewport, const glm::vec2& ndc)
{
    // TODO: pixels own their left and lower borders. Which points belong to no pixel of the viewport?
    return not_implemented<std::optional<glm::ivec2>>(viewport, ndc);
}

glm::vec2 pixel_centre(const Viewport& viewport, const glm::ivec2& pixel)
{
    // TODO: where is the middle of pixel (i, j) in window coordinates? Then back to NDC.
    return not_implemented<glm::vec2>(viewport, pixel);
}

}
