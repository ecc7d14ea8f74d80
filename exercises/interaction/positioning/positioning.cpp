#include <umbral/interaction/positioning.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window_size, glm::ivec2 framebuffer_size)
{
    // TODO: pixels for each screen coordinate, then round down. Replace the next line.
    return not_implemented<std::optional<glm::ivec2>>(cursor, window_size, framebuffer_size);
}

glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& limits, glm::ivec2 viewport_size)
{
    // TODO: the share of the viewport at which the pixel's centre lies, then the limits. Replace the next line.
    return not_implemented<glm::dvec2>(pixel, limits, viewport_size);
}

std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 viewport_size, const glm::mat4& view,
                                         const glm::mat4& projection, const SnapPlane& plane)
{
    // TODO: two points of the pixel's ray in the world, their line and the plane. Replace the next line.
    return not_implemented<std::optional<glm::dvec3>>(pixel, viewport_size, view, projection, plane);
}

glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons, const ViewLimits& limits,
                        glm::ivec2 window_size)
{
    // TODO: from screen coordinates to lengths of the world, then the plane that the buttons say. Replace the next
    // line.
    return not_implemented<glm::dvec3>(cursor, motion, buttons, limits, window_size);
}

glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& cursor)
{
    // TODO: two of the three coordinates. Replace the next line.
    return not_implemented<glm::dvec2>(view, cursor);
}

glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 place, const glm::dvec3& cursor)
{
    // TODO: the way back; one coordinate stays. Replace the next line.
    return not_implemented<glm::dvec3>(view, place, cursor);
}

std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor)
{
    // TODO: an angle with y turned up. Replace the next line.
    return not_implemented<std::optional<double>>(reference, cursor);
}

}
