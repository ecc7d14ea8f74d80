#include <algorithm>
#include <cmath>
#include <numbers>
#include <umbral/raytracing/path_tracing.hpp>

// Based on: J. T. Kajiya. The Rendering Equation. SIGGRAPH 1986; J. Arvo, D. Kirk. Particle Transport and Image
// Synthesis. SIGGRAPH 1990 (Russian roulette); T. Duff et al. Building an Orthonormal Basis, Revisited. JCGT 2017.
namespace umbral::raytracing {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Paths are ended by chance from their third reflection on: the first ones carry most of the light.
constexpr int certain_reflections = 3;

glm::vec3 uniform_point(const AreaLamp& lamp, Random& random)
{
    const float a = random.uniform();
    const float b = random.uniform();
    return lamp.corner + a * lamp.edge_a + b * lamp.edge_b;
}

/// What a white surface reflects of the lamps' light that reaches it directly: an estimate from one point of each.
glm::vec3 light_of_lamps(const DiffuseScene& scene, const DiffusePoint& at, Random& random)
{
    glm::vec3 light(0);
    for (const AreaLamp& lamp : scene.lamps()) {
        const glm::vec3 place = uniform_point(lamp, random);
        const glm::vec3 direction = normalize(place - at.position);
        const bool shines_here = dot(direction, cross(lamp.edge_a, lamp.edge_b)) < 0;
        const float reflected = cosine_density(at.normal, direction);
        if (!shines_here || reflected == 0 || scene.blocked(at.position, place)) continue;
        light += lamp.radiance * (reflected / lamp_density(at.position, lamp, place));
    }
    return light;
}

/// One path from the eye towards the light. `share` is what of the light at its end would reach the eye.
glm::vec3 light_of_one_path(const DiffuseScene& scene, Ray ray, int bounces, Random& random)
{
    glm::vec3 light(0);
    glm::vec3 share(1);
    for (int reflections = 0;; ++reflections) {
        const std::optional<DiffusePoint> hit = scene.first_hit(ray);
        if (!hit) return light + share * scene.sky(ray.direction);
        // Behind a reflection, the light of the lamps has been counted already.
        if (reflections == 0 || hit->lamp < 0) light += share * hit->emitted;
        if (reflections == bounces) return light;

        share *= hit->albedo;
        light += share * light_of_lamps(scene, *hit, random);
        if (reflections + 1 >= certain_reflections) {
            const float survival = std::min(1.0F, std::max({share.r, share.g, share.b}));
            if (random.uniform() >= survival) return light;
            share /= survival;
        }
        // The density of the direction is the reflected share of the light from there: they cancel.
        ray = Ray{hit->position, cosine_direction(hit->normal, random)};
    }
}

}

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    // Malley: a uniform point of the unit disc, lifted to the hemisphere above it.
    const float squared_radius = random.uniform();
    const float angle = 2 * pi * random.uniform();
    const float x = std::sqrt(squared_radius) * std::cos(angle);
    const float y = std::sqrt(squared_radius) * std::sin(angle);
    const float z = std::sqrt(1 - squared_radius);

    const float sign = std::copysign(1.0F, normal.z);
    const float a = -1 / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    const glm::vec3 right(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    const glm::vec3 up(b, sign + normal.y * normal.y * a, -normal.y);
    return x * right + y * up + z * normal;
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    return std::max(0.0F, dot(normal, direction)) / pi;
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    // The length of the cross product is the area: times the cosine, it is the dot product over the distance.
    const glm::vec3 way = on_lamp - point;
    const float distance = length(way);
    return distance * distance * distance / std::abs(dot(cross(lamp.edge_a, lamp.edge_b), way));
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    glm::vec3 sum(0);
    for (int i = 0; i < samples; ++i) sum += light_of_one_path(scene, ray, bounces, random);
    return sum / static_cast<float>(samples);
}

}
