// Based on: P. Shirley, M. Ashikhmin, S. Marschner. Fundamentals of Computer Graphics. 3rd edition, 2009, section 4.3
// (computing viewing rays).

#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    // The product first: it is exact for cursors of few digits, and then the quotient cannot round across a border.
    // Where there is no window it is infinite or NaN, and where there is no framebuffer 0: all outside.
    const glm::dvec2 place = cursor * glm::dvec2(framebuffer) / glm::dvec2(window);
    const bool is_inside = place.x >= 0 && place.y >= 0 && place.x < framebuffer.x && place.y < framebuffer.y;
    if (!is_inside) return std::nullopt;
    return glm::ivec2(place);
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    const auto& [left, right, bottom, top, near_plane, far_plane] = view.frustum;
    // The pixel's centre, as a share of the picture from its upper left corner.
    const glm::dvec2 share = (glm::dvec2(pixel) + 0.5) / glm::dvec2(view.picture);
    // The same place in the near plane, in camera coordinates.
    const double x = left + (double{right} - left) * share.x;
    const double y = top - (double{top} - bottom) * share.y;
    const double z = -double{near_plane};

    const auto& [x_axis, y_axis, z_axis, eye] = view.frame;
    const glm::dvec3 to_near = x * glm::dvec3(x_axis) + y * glm::dvec3(y_axis) + z * glm::dvec3(z_axis);
    const double near_distance = length(to_near);
    const double far_distance = near_distance * (far_plane / double{near_plane});
    return {eye, glm::vec3(to_near / near_distance), static_cast<float>(near_distance),
            static_cast<float>(far_distance)};
}

}
