// alternative: the point of the near plane by the inverse of projection times view, in double, and from the eye to it
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
    glm::dmat4 camera(1);
    camera[0] = glm::dvec4(view.frame.x, 0);
    camera[1] = glm::dvec4(view.frame.y, 0);
    camera[2] = glm::dvec4(view.frame.z, 0);
    // The far plane moves no point of the near one.
    const glm::dmat4 projection =
        glm::frustum<double>(v.left, v.right, v.bottom, v.top, v.near_plane, 2.0 * v.near_plane);
    const glm::dmat4 to_world = glm::inverse(projection * glm::inverse(camera));

    const glm::dvec2 size(view.picture);
    const glm::dvec4 in_world =
        to_world * glm::dvec4((2.0 * pixel.x + 1) / size.x - 1, 1 - (2.0 * pixel.y + 1) / size.y, -1, 1);
    const glm::dvec3 from_eye = glm::dvec3(in_world) / in_world.w;
    const double near_distance = glm::length(from_eye);

    Ray ray;
    ray.origin = view.frame.origin;
    ray.direction = glm::vec3(glm::normalize(from_eye));
    ray.t_min = static_cast<float>(near_distance);
    ray.t_max = static_cast<float>(near_distance / v.near_plane * v.far_plane);
    return ray;
}

}
