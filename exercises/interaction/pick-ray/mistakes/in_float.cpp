// mistake: leads from a point of the near plane to one of the far plane, both found by inverted matrices in float
// credit: 40..90
// hint: Inverting the whole way from the world to the picture and back loses digits where the camera is far from the
// world's origin or the far plane is far away. You know the frame: add up multiples of its axes, in double.
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    for (int i = 0; i < 2; ++i)
        if (window[i] <= 0 || framebuffer[i] <= 0 || !(cursor[i] >= 0) || !(cursor[i] < window[i])) return std::nullopt;
    return glm::ivec2(cursor.x * framebuffer.x / window.x, cursor.y * framebuffer.y / window.y);
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    const auto& [l, r, b, t, n, f] = view.frustum;
    const float far_plane = std::min(f, 1e6F * n);
    const glm::mat3 axes(view.frame.x, view.frame.y, view.frame.z);
    glm::mat4 to_camera(glm::transpose(axes));
    to_camera[3] = glm::vec4(-(glm::transpose(axes) * view.frame.origin), 1);
    const glm::mat4 back = glm::inverse(glm::frustum(l, r, b, t, n, far_plane) * to_camera);

    const glm::vec2 share = (glm::vec2(pixel) + 0.5F) / glm::vec2(view.picture);
    const glm::vec2 ndc(2 * share.x - 1, 1 - 2 * share.y);
    const glm::vec4 near_point = back * glm::vec4(ndc, -1, 1);
    const glm::vec4 far_point = back * glm::vec4(ndc, 1, 1);
    const glm::vec3 p = glm::vec3(near_point) / near_point.w;
    const glm::vec3 q = glm::vec3(far_point) / far_point.w;
    const glm::vec3 direction = glm::normalize(q - p);
    const float cosine = -glm::dot(direction, view.frame.z);
    return {view.frame.origin, direction, n / cosine, f / cosine};
}

}
