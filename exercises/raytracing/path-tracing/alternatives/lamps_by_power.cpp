// alternative: recursive, in double, one lamp for each reflection, strong ones more often, and survival by albedo where
// all bounces count
#include <algorithm>
#include <cmath>
#include <numbers>
#include <umbral/raytracing/path_tracing.hpp>
#include <vector>

namespace umbral::raytracing {
namespace {

double power_of(const AreaLamp& lamp)
{
    const double area = length(cross(glm::dvec3(lamp.edge_a), glm::dvec3(lamp.edge_b)));
    return area * (double{lamp.radiance.r} + lamp.radiance.g + lamp.radiance.b);
}

glm::dvec3 light_of_a_lamp(const DiffuseScene& scene, const DiffusePoint& at, Random& random)
{
    std::vector<double> powers;
    double all = 0;
    for (const AreaLamp& lamp : scene.lamps()) {
        powers.push_back(power_of(lamp));
        all += powers.back();
    }
    if (all <= 0) return glm::dvec3(0);
    double left = random.uniform_double() * all;
    std::size_t chosen = 0;
    while (chosen + 1 < powers.size() && left >= powers[chosen]) left -= powers[chosen++];
    const AreaLamp& lamp = scene.lamps()[chosen];
    const double chance = powers[chosen] / all;

    const float a = random.uniform();
    const float b = random.uniform();
    const glm::vec3 place = lamp.corner + a * lamp.edge_a + b * lamp.edge_b;
    const glm::vec3 direction = normalize(place - at.position);
    const double reflected = cosine_density(at.normal, direction);
    const bool is_lit = chance > 0 && reflected > 0 && dot(cross(lamp.edge_a, lamp.edge_b), direction) < 0;
    if (!is_lit || scene.blocked(at.position, place)) return glm::dvec3(0);
    return glm::dvec3(lamp.radiance) * (reflected / lamp_density(at.position, lamp, place) / chance);
}

glm::dvec3 follow(const DiffuseScene& scene, const Ray& ray, int bounces, bool with_lamps, Random& random)
{
    const std::optional<DiffusePoint> hit = scene.first_hit(ray);
    if (!hit) return glm::dvec3(scene.sky(ray.direction));
    glm::dvec3 light(0);
    if (with_lamps || hit->lamp < 0) light += glm::dvec3(hit->emitted);
    if (bounces == 0) return light;
    const glm::dvec3 albedo(hit->albedo);
    light += albedo * light_of_a_lamp(scene, *hit, random);

    double survival = 1;
    if (bounces == all_bounces) {
        survival = std::max({albedo.r, albedo.g, albedo.b});
        if (random.uniform_double() >= survival) return light;
    }
    const Ray next{hit->position, cosine_direction(hit->normal, random)};
    const int left = bounces == all_bounces ? all_bounces : bounces - 1;
    return light + albedo / survival * follow(scene, next, left, false, random);
}

}

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    const glm::vec3 sum = normal + random.unit_vector();
    return dot(sum, sum) > 1e-12F ? normalize(sum) : normal;
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    return static_cast<float>(std::max(0.0, dot(glm::dvec3(normal), glm::dvec3(direction))) / std::numbers::pi);
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    const glm::dvec3 way = glm::dvec3(on_lamp) - glm::dvec3(point);
    const double r2 = dot(way, way);
    const glm::dvec3 across = cross(glm::dvec3(lamp.edge_a), glm::dvec3(lamp.edge_b));
    return static_cast<float>(r2 * std::sqrt(r2) / std::abs(dot(across, way)));
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    glm::dvec3 sum(0);
    for (int i = 0; i < samples; ++i) sum += follow(scene, ray, bounces, true, random);
    return glm::vec3(sum / static_cast<double>(samples));
}

}
