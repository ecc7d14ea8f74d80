// alternative: in double; the samples of a pixel are jittered in its square and in time, in shuffled order, and lens
// and lamps are stratified too, with the concentric map for the disc
#include <algorithm>
#include <cmath>
#include <umbral/raytracing/distributed.hpp>
#include <vector>

namespace umbral::raytracing {
namespace {

constexpr double pi = 3.14159265358979323846;

glm::vec2 concentric(double u, double v)
{
    const double a = 2 * u - 1;
    const double b = 2 * v - 1;
    if (a == 0 && b == 0) return glm::vec2(0);
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle = wide ? pi / 4 * b / a : pi / 2 - pi / 4 * a / b;
    return glm::vec2(radius * std::cos(angle), radius * std::sin(angle));
}

/// One number in each of n equal parts of [0, 1), in random order.
std::vector<double> jittered(int n, Random& random)
{
    std::vector<double> numbers;
    for (int i = 0; i < n; ++i) numbers.push_back((i + random.uniform_double()) / n);
    for (std::size_t i = numbers.size(); i > 1; --i)
        std::swap(numbers[i - 1], numbers[random.below(static_cast<std::uint32_t>(i))]);
    return numbers;
}

double share_of_place(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, double a, double b,
                      float time)
{
    const glm::dvec3 place = glm::dvec3(lamp.corner) + a * glm::dvec3(lamp.edge_a) + b * glm::dvec3(lamp.edge_b);
    const glm::dvec3 across = cross(glm::dvec3(lamp.edge_a), glm::dvec3(lamp.edge_b));
    const glm::dvec3 way = place - glm::dvec3(at.position);
    const double r = length(way);
    const double here = dot(way, glm::dvec3(at.normal)) / r;
    const double there = dot(-way, normalize(across)) / r;
    if (here <= 0 || there <= 0) return 0;
    if (scene.blocked(at.position, glm::vec3(place), time)) return 0;
    return length(across) * here * there / (pi * r * r);
}

}

glm::vec2 disc_point(Random& random)
{
    const double u = random.uniform_double();
    return concentric(u, random.uniform_double());
}

Ray lens_ray(const LensCamera& camera, PictureSize size, glm::vec2 place, glm::vec2 lens)
{
    const double pixel = 2.0 * camera.half_height / size.height;
    const glm::dvec3 through = pixel * (place.x - size.width / 2.0) * glm::dvec3(camera.right) -
                               pixel * (place.y - size.height / 2.0) * glm::dvec3(camera.up) - glm::dvec3(camera.back);
    const glm::dvec3 origin = glm::dvec3(camera.eye) + double(camera.lens_radius * lens.x) * glm::dvec3(camera.right) +
                              double(camera.lens_radius * lens.y) * glm::dvec3(camera.up);
    const glm::dvec3 sharp = glm::dvec3(camera.eye) + double(camera.focus_depth) * through;
    return Ray{glm::vec3(origin), glm::vec3(normalize(sharp - origin))};
}

float lamp_light(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, float time, int samples,
                 Random& random)
{
    const std::vector<double> a = jittered(samples, random);
    const std::vector<double> b = jittered(samples, random);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += share_of_place(scene, at, lamp, a[i], b[i], time);
    return static_cast<float>(sum / samples);
}

glm::vec3 pixel_light(const MovingScene& scene, const LensCamera& camera, PictureSize size, glm::ivec2 pixel,
                      int samples, Random& random)
{
    const std::vector<double> right = jittered(samples, random);
    const std::vector<double> down = jittered(samples, random);
    const std::vector<double> when = jittered(samples, random);
    const std::vector<double> u = jittered(samples, random);
    const std::vector<double> v = jittered(samples, random);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < right.size(); ++i) {
        const float time =
            static_cast<float>(camera.shutter_opens + when[i] * double(camera.shutter_closes - camera.shutter_opens));
        const glm::vec2 place(pixel.x + right[i], pixel.y + down[i]);
        const Ray ray = lens_ray(camera, size, place, concentric(u[i], v[i]));
        const auto hit = scene.first_hit(ray, time);
        if (!hit) {
            sum += glm::dvec3(scene.sky(ray.direction));
            continue;
        }
        glm::dvec3 arriving(scene.ambient());
        for (const AreaLamp& lamp : scene.lamps())
            arriving += glm::dvec3(lamp.radiance) *
                        share_of_place(scene, *hit, lamp, random.uniform_double(), random.uniform_double(), time);
        sum += glm::dvec3(hit->emitted) + glm::dvec3(hit->albedo) * arriving;
    }
    return glm::vec3(sum / double(samples));
}

}
