#include <cmath>
#include <numbers>
#include <umbral/raytracing/distributed.hpp>

// Based on: R. L. Cook, T. Porter, L. Carpenter. Distributed Ray Tracing. SIGGRAPH 1984; M. Pharr, W. Jakob,
// G. Humphreys. Physically Based Rendering, 4th edition, 2023, section 5.2.3 (the thin lens).
namespace umbral::raytracing {
namespace {

/// What one point of a lamp, drawn uniformly over its area, says of its light. The length of `across` is the area, so
/// that the cosine at the lamp, times the area, is a dot product.
float light_of_point(const LitPoint& at, const glm::vec3& across, const glm::vec3& way)
{
    const float here = dot(at.normal, way);
    const float there = -dot(across, way);
    if (here <= 0 || there <= 0) return 0;
    const float square = dot(way, way);
    return here * there / (std::numbers::pi_v<float> * square * square);
}

glm::vec3 light_along(const MovingScene& scene, const Ray& ray, float time, Random& random)
{
    const std::optional<LitPoint> hit = scene.first_hit(ray, time);
    if (!hit) return scene.sky(ray.direction);
    glm::vec3 arriving = scene.ambient();
    for (const AreaLamp& lamp : scene.lamps())
        arriving += lamp.radiance * lamp_light(scene, *hit, lamp, time, 1, random);
    return hit->emitted + hit->albedo * arriving;
}

}

glm::vec2 disc_point(Random& random)
{
    // The area within a radius grows with its square: so a uniform share of the area has the root as its radius.
    const float radius = std::sqrt(random.uniform());
    const float angle = 2 * std::numbers::pi_v<float> * random.uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

Ray lens_ray(const LensCamera& camera, PictureSize size, glm::vec2 place, glm::vec2 lens)
{
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    // At the depth 1, relative to the eye.
    const float x = camera.half_height * (2 * place.x - width) / height;
    const float y = camera.half_height * (height - 2 * place.y) / height;
    const glm::vec3 in_focus = camera.focus_depth * (x * camera.right + y * camera.up - camera.back);
    const glm::vec3 on_lens = camera.lens_radius * (lens.x * camera.right + lens.y * camera.up);
    return Ray{camera.eye + on_lens, normalize(in_focus - on_lens)};
}

float lamp_light(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, float time, int samples,
                 Random& random)
{
    const glm::vec3 across = cross(lamp.edge_a, lamp.edge_b);
    float sum = 0;
    for (int i = 0; i < samples; ++i) {
        const float a = random.uniform();
        const float b = random.uniform();
        const glm::vec3 place = lamp.corner + a * lamp.edge_a + b * lamp.edge_b;
        const float light = light_of_point(at, across, place - at.position);
        if (light > 0 && !scene.blocked(at.position, place, time)) sum += light;
    }
    return sum / static_cast<float>(samples);
}

glm::vec3 pixel_light(const MovingScene& scene, const LensCamera& camera, PictureSize size, glm::ivec2 pixel,
                      int samples, Random& random)
{
    glm::vec3 sum(0);
    for (int i = 0; i < samples; ++i) {
        const float right = random.uniform();
        const float down = random.uniform();
        const glm::vec2 place = glm::vec2(pixel) + glm::vec2(right, down);
        const float time = random.uniform(camera.shutter_opens, camera.shutter_closes);
        sum += light_along(scene, lens_ray(camera, size, place, disc_point(random)), time, random);
    }
    return sum / static_cast<float>(samples);
}

}
