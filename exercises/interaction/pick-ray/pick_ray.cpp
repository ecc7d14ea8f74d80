#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    // TODO
    // 1. Is there a window at all, and is the cursor in it?
    // 2. Change from screen coordinates to pixels.
    return not_implemented<std::optional<glm::ivec2>>(cursor, window, framebuffer);
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    // TODO
    // 1. Where is the pixel's centre on the near plane, in camera coordinates?
    // 2. Lead there from the eye, in world coordinates.
    // 3. Make it a unit vector, and say where the ray passes the two planes.
    return not_implemented<Ray>(view, pixel);
}

}
