#pragma once

#include "../cast.hpp"
#include "bodies.hpp"

/// The goal picture: Menger's sponge of level 3, with a lamp in its middle.
namespace umbral::raytracing::sdf {

inline glm::vec3 sponge_normal(const DistanceFunction& distance, const glm::vec3& p)
{
    constexpr float h = 4e-4F;
    const glm::vec3 x(h, 0, 0);
    const glm::vec3 y(0, h, 0);
    const glm::vec3 z(0, 0, h);
    const glm::vec3 rise(distance(p + x) - distance(p - x), distance(p + y) - distance(p - y),
                         distance(p + z) - distance(p - z));
    return rise == glm::vec3(0) ? glm::vec3(0, 1, 0) : normalize(rise);
}

inline glm::vec3 deep_space(const glm::vec3& direction)
{
    const float glow = std::pow(std::max(0.0F, dot(direction, normalize(glm::vec3(-2.5F, -1.75F, -3.6F)))), 12.0F);
    return glm::vec3(0.006F, 0.007F, 0.016F) + glow * glm::vec3(0.035F, 0.035F, 0.085F);
}

/// The share of open space near a surface: the distance five steps along the normal, against the steps.
inline float openness(const DistanceFunction& distance, const glm::vec3& p, const glm::vec3& normal)
{
    float closed = 0;
    float weight = 1;
    for (const float step : {0.02F, 0.06F, 0.14F}) {
        closed += weight * std::max(0.0F, step - distance(p + step * normal)) / step;
        weight *= 0.6F;
    }
    return std::clamp(1 - 0.5F * closed, 0.0F, 1.0F);
}

inline glm::vec3 sponge_light(const Ray& ray, const Bodies& sponge)
{
    const TraceLimits limits{4e-4F, 90};
    const glm::vec3 aside = cross(ray.origin, ray.direction);
    if (dot(aside, aside) > 3.05F) return deep_space(ray.direction);
    const std::optional<TracedPoint> hit = sphere_trace(ray, sponge, limits);
    if (!hit) return deep_space(ray.direction);
    const glm::vec3 p = ray.origin + hit->t * ray.direction;
    const glm::vec3 normal = sponge_normal(sponge[0], p);
    const glm::vec3 from = p + 2e-3F * normal;
    const float open = openness(sponge[0], p, normal);

    const glm::vec3 sun = normalize(glm::vec3(-0.62F, 0.75F, 0.34F));
    float key = std::max(0.0F, dot(normal, sun));
    if (key > 0 && sphere_trace(Ray{from, sun, 0, 3}, sponge, limits)) key = 0;
    // The lamp: warm, from the middle, weaker with the square of the distance.
    const float from_lamp = std::max(0.2F, length(p));
    float lamp = std::max(0.0F, dot(normal, -p / from_lamp));
    if (lamp > 0 && sphere_trace(Ray{from, -p / from_lamp, 0, 0.9F * from_lamp}, sponge, limits)) lamp = 0;
    const glm::vec3 stone = glm::mix(glm::vec3(0.42F, 0.47F, 0.58F), glm::vec3(0.62F, 0.52F, 0.45F), 0.5F + 0.5F * p.y);
    return stone * (0.75F * key * glm::vec3(1, 0.96F, 0.9F) + open * glm::vec3(0.035F, 0.055F, 0.13F)) +
           (0.55F / (from_lamp * from_lamp)) * (0.10F * open + lamp) * glm::vec3(1, 0.38F, 0.08F);
}

inline Image sponge_picture(Variation& vary)
{
    const Bodies sponge{[](const glm::vec3& p) { return menger_distance(p, 3); }};
    return ray_traced(144, 136, varied(vary, {{2.5F, 1.75F, 3.6F}, {0, -0.05F, 0}, 0.39F}),
                      [&](const Ray& ray) { return sponge_light(ray, sponge); });
}

}
