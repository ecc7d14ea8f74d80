// Based on: the course's positioning (transformación lineal, restricción a un plano, cursor virtual 3D, cursores
// ligados); the point of a line on a plane in homogeneous coordinates: R. Goldman. "Pyramid algorithms". 2002, and
// J. Blinn. "A homogeneous formulation for lines in 3-space". 1977.

#include <umbral/interaction/positioning.hpp>

#include <cmath>

namespace umbral::interaction {
namespace {

constexpr double least_sine = 1e-9;

/// The place in normalised device coordinates of a pixel's centre.
glm::dvec2 centre_in_ndc(glm::ivec2 pixel, glm::ivec2 size)
{
    const glm::dvec2 share = (glm::dvec2(pixel) + 0.5) / glm::dvec2(size);
    return {2 * share.x - 1, 1 - 2 * share.y};
}

}

std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window_size, glm::ivec2 framebuffer_size)
{
    if (glm::any(glm::lessThanEqual(glm::min(window_size, framebuffer_size), glm::ivec2(0)))) return std::nullopt;
    // Rounded down: a conversion to int would round towards 0, and give pixel 0 twice its share.
    return glm::ivec2(glm::floor(cursor * glm::dvec2(framebuffer_size) / glm::dvec2(window_size)));
}

glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& limits, glm::ivec2 viewport_size)
{
    const glm::dvec2 share = (glm::dvec2(pixel) + 0.5) / glm::dvec2(viewport_size);
    return {limits.left + (limits.right - limits.left) * share.x, limits.top - (limits.top - limits.bottom) * share.y};
}

std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 viewport_size, const glm::mat4& view,
                                         const glm::mat4& projection, const SnapPlane& plane)
{
    const glm::dmat4 to_clip = glm::dmat4(projection) * glm::dmat4(view);
    const glm::dmat4 to_world = glm::inverse(to_clip);
    const glm::dvec2 ndc = centre_in_ndc(pixel, viewport_size);
    const glm::dvec4 near = to_world * glm::dvec4(ndc, -1, 1);
    const glm::dvec4 far = to_world * glm::dvec4(ndc, 1, 1);

    // The point of the line that lies in the plane, in homogeneous coordinates; its w is normal · direction.
    const glm::dvec4 equation(plane.normal, -plane.offset);
    const glm::dvec4 point = glm::dot(equation, far) * near - glm::dot(equation, near) * far;
    const glm::dvec3 direction = near.w * glm::dvec3(far) - far.w * glm::dvec3(near);
    if (std::abs(point.w) <= least_sine * glm::length(plane.normal) * glm::length(direction)) return std::nullopt;

    const glm::dvec3 place = glm::dvec3(point) / point.w;
    const double clip_w = (to_clip * glm::dvec4(place, 1)).w;
    return clip_w > 0 ? std::optional(place) : std::nullopt;
}

glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons, const ViewLimits& limits,
                        glm::ivec2 window_size)
{
    const double right = motion.x * (limits.right - limits.left) / window_size.x;
    const double down = motion.y * (limits.top - limits.bottom) / window_size.y;
    if ((buttons & 2U) != 0) return cursor + glm::dvec3(right, 0, down);
    if ((buttons & 1U) != 0) return cursor + glm::dvec3(right, -down, 0);
    return cursor;
}

glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& cursor)
{
    switch (view) {
        case LinkedView::front: return {cursor.x, cursor.y};
        case LinkedView::top: return {cursor.x, -cursor.z};
        case LinkedView::side: return {-cursor.z, cursor.y};
    }
    return {0, 0};
}

glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 place, const glm::dvec3& cursor)
{
    switch (view) {
        case LinkedView::front: return {place.x, place.y, cursor.z};
        case LinkedView::top: return {place.x, cursor.y, -place.y};
        case LinkedView::side: return {cursor.x, place.y, -place.x};
    }
    return cursor;
}

std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor)
{
    if (reference == cursor) return std::nullopt;
    // Subtracted this way round, a height of 0 is +0, and the angle to the left π and not -π.
    return std::atan2(reference.y - cursor.y, cursor.x - reference.x);
}

}
