// alternative: points of the disc by rejection, one lamp at random for each ray, and rays through a picture that stands
// in the plane of focus
#include <cmath>
#include <umbral/raytracing/distributed.hpp>

namespace umbral::raytracing {

glm::vec2 disc_point(Random& random)
{
    for (int tries = 0; tries < 100; ++tries) {
        const float x = random.uniform(-1, 1);
        const glm::vec2 point(x, random.uniform(-1, 1));
        if (dot(point, point) <= 1) return point;
    }
    return glm::vec2(0);
}

Ray lens_ray(const LensCamera& camera, PictureSize size, glm::vec2 place, glm::vec2 lens)
{
    const float half_height = camera.half_height * camera.focus_depth;
    const float half_width = half_height * float(size.width) / float(size.height);
    const glm::vec3 middle = camera.eye - camera.focus_depth * camera.back;
    const glm::vec3 target = middle + (2 * place.x / float(size.width) - 1) * half_width * camera.right +
                             (1 - 2 * place.y / float(size.height)) * half_height * camera.up;
    Ray ray;
    ray.origin = camera.eye;
    ray.origin += camera.right * lens.x * camera.lens_radius;
    ray.origin += camera.up * lens.y * camera.lens_radius;
    ray.direction = target - ray.origin;
    ray.direction /= length(ray.direction);
    return ray;
}

float lamp_light(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, float time, int samples,
                 Random& random)
{
    const glm::vec3 area = cross(lamp.edge_a, lamp.edge_b);
    const glm::vec3 front = normalize(area);
    float mean = 0;
    for (int i = 0; i < samples; ++i) {
        const float b = random.uniform();
        const glm::vec3 y = lamp.corner + lamp.edge_b * b + lamp.edge_a * random.uniform();
        if (scene.blocked(at.position, y, time)) continue;
        const glm::vec3 direction = normalize(y - at.position);
        const float cosines = std::max(0.0F, dot(direction, at.normal)) * std::max(0.0F, -dot(direction, front));
        mean += cosines / (dot(y - at.position, y - at.position) * float(samples));
    }
    return mean * length(area) / 3.14159265F;
}

static glm::vec3 seen(const MovingScene& scene, const Ray& ray, float time, Random& random)
{
    const auto hit = scene.first_hit(ray, time);
    if (!hit) return scene.sky(ray.direction);
    glm::vec3 light = hit->emitted + hit->albedo * scene.ambient();
    const auto count = static_cast<std::uint32_t>(scene.lamps().size());
    if (count == 0) return light;
    const AreaLamp& lamp = scene.lamps()[random.below(count)];
    light += float(count) * hit->albedo * lamp.radiance * lamp_light(scene, *hit, lamp, time, 1, random);
    return light;
}

glm::vec3 pixel_light(const MovingScene& scene, const LensCamera& camera, PictureSize size, glm::ivec2 pixel,
                      int samples, Random& random)
{
    glm::vec3 mean(0);
    for (int i = 1; i <= samples; ++i) {
        const glm::vec2 on_lens = disc_point(random);
        const float share = random.uniform();
        const float time = (1 - share) * camera.shutter_opens + share * camera.shutter_closes;
        const float x = float(pixel.x) + random.uniform();
        const Ray ray = lens_ray(camera, size, {x, float(pixel.y) + random.uniform()}, on_lens);
        mean += (seen(scene, ray, time, random) - mean) / float(i);
    }
    return mean;
}

}
