// alternative: from normalised device coordinates back to the world, through the inverse of a view matrix and the
// corners of a projection without depth, in double
#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    if (glm::any(glm::lessThanEqual(window, glm::ivec2(0)))) return std::nullopt;
    if (glm::any(glm::lessThanEqual(framebuffer, glm::ivec2(0)))) return std::nullopt;
    if (!(cursor.x >= 0 && cursor.x < window.x && cursor.y >= 0 && cursor.y < window.y)) return std::nullopt;
    const int column = static_cast<int>(std::floor(cursor.x * framebuffer.x / window.x));
    const int row = static_cast<int>(std::floor(cursor.y * framebuffer.y / window.y));
    return glm::ivec2(column, row);
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    const projections::ViewVolume& v = view.frustum;
    const double ndc_x = 2 * (pixel.x + 0.5) / view.picture.x - 1;
    const double ndc_y = 1 - 2 * (pixel.y + 0.5) / view.picture.y;
    const double half_width = (double(v.right) - double(v.left)) / 2;
    const double half_height = (double(v.top) - double(v.bottom)) / 2;
    const glm::dvec4 on_near((double(v.right) + double(v.left)) / 2 + half_width * ndc_x,
                             (double(v.top) + double(v.bottom)) / 2 + half_height * ndc_y, -double(v.near_plane), 0);

    glm::dmat4 to_world(1);
    to_world[0] = glm::dvec4(view.frame.x, 0);
    to_world[1] = glm::dvec4(view.frame.y, 0);
    to_world[2] = glm::dvec4(view.frame.z, 0);
    to_world[3] = glm::dvec4(view.frame.origin, 1);
    const glm::dvec3 direction(to_world * on_near);

    Ray ray;
    ray.origin = view.frame.origin;
    ray.direction = glm::vec3(glm::normalize(direction));
    ray.t_min = float(glm::length(direction));
    ray.t_max = float(glm::length(direction * (double(v.far_plane) / double(v.near_plane))));
    return ray;
}

}
