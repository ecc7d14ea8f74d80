// alternative: the near window's upper left corner in the world, and steps from one pixel to the next; rows counted
// from below in between
#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    glm::ivec2 pixel;
    for (int i = 0; i < 2; i++) {
        if (window[i] <= 0 || framebuffer[i] <= 0) return std::nullopt;
        const double steps = cursor[i] * framebuffer[i];  // window[i] of them are a pixel
        if (!(steps >= 0) || !(steps < double(window[i]) * framebuffer[i])) return std::nullopt;
        pixel[i] = static_cast<int>(steps / window[i]);
    }
    return pixel;
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    using glm::dvec3;
    const auto& f = view.frustum;
    const dvec3 x = view.frame.x;
    const dvec3 y = view.frame.y;
    const dvec3 z = view.frame.z;
    const dvec3 lower_left = double(f.left) * x + double(f.bottom) * y - double(f.near_plane) * z;
    const dvec3 to_right = (double(f.right) - f.left) / view.picture.x * x;
    const dvec3 upwards = (double(f.top) - f.bottom) / view.picture.y * y;
    const double row_from_below = double(view.picture.y) - 1 - pixel.y;
    const dvec3 v = lower_left + (pixel.x + 0.5) * to_right + (row_from_below + 0.5) * upwards;
    const double d = glm::length(v);
    return {view.frame.origin, glm::vec3(v / d), (float)d, (float)(d / f.near_plane * f.far_plane)};
}

}
