#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <umbral/raytracing/disc.hpp>
#include <vector>

#include "../cast.hpp"
#include "../rays.hpp"

/// The goal picture: a ball of sequins over a polished floor. All of it is discs.
namespace umbral::raytracing {

/// The unit's function, one of several called intersect.
inline constexpr std::optional<float> (*intersect_disc)(const Ray&, const Disc&) = intersect;

constexpr glm::vec3 ball_centre(0, 1.3F, 0);
constexpr float ball_reach = 1.1F;  ///< no sequin reaches farther from the ball's centre

/// The floor, and the sequins: places of equal area round the ball, on a spiral with the golden angle.
inline std::vector<Disc> sequin_ball()
{
    constexpr int sequins = 230;
    std::vector<Disc> discs = {{{0, 0, 0}, {0, 1, 0}, 2.9F}};
    for (int i = 0; i < sequins; ++i) {
        const float height = 1 - (2 * static_cast<float>(i) + 1) / sequins;
        const float angle = 2.3999632F * static_cast<float>(i);
        const float ring = std::sqrt(1 - height * height);
        const glm::vec3 outwards(ring * std::cos(angle), height, ring * std::sin(angle));
        discs.push_back({ball_centre + outwards, outwards, 0.117F});
    }
    return discs;
}

/// Does the line of the ray pass a ball? The driver's own test, which spares most questions.
inline bool passes_near(const Ray& ray, const glm::vec3& centre, float reach)
{
    const glm::vec3 aside = cross(centre - ray.origin, ray.direction);
    return dot(aside, aside) < reach * reach;
}

/// The nearest disc along a ray of unit direction: its place in the list plus one (0 for none), and where it is met.
struct DiscHit {
    std::uint32_t id = 0;
    glm::vec3 point{0};
};

/// `meets(ray, disc)` is the unit's function, or the question what it answers.
template <class Meets>
DiscHit nearest(Meets meets, Ray ray, const std::vector<Disc>& discs)
{
    DiscHit hit;
    const bool near_ball = passes_near(ray, ball_centre, ball_reach);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        if (i > 0 && !near_ball) break;
        if (i > 0 && !passes_near(ray, discs[i].centre, 1.1F * discs[i].radius)) continue;
        const std::optional<float> t = meets(ray, discs[i]);
        if (!t || !(*t < ray.t_max)) continue;
        ray.t_max = *t;
        hit = {static_cast<std::uint32_t>(i + 1), ray.origin + *t * ray.direction};
    }
    return hit;
}

inline glm::vec3 night_sky(const glm::vec3& direction)
{
    return glm::mix(glm::vec3(0.030F, 0.034F, 0.075F), glm::vec3(0.004F, 0.005F, 0.014F),
                    glm::smoothstep(-0.35F, 0.5F, direction.y));
}

/// The light that comes back along a ray: the sun's, the sky's, and on the floor what it mirrors.
inline glm::vec3 sequin_light(const Ray& ray, const std::vector<Disc>& discs, int mirrors = 1)
{
    const DiscHit hit = nearest(intersect_disc, ray, discs);
    if (hit.id == 0) return night_sky(ray.direction);
    const glm::vec3 sun = normalize(glm::vec3(-0.6F, 1.25F, 0.75F));
    glm::vec3 normal = discs[hit.id - 1].normal;
    if (dot(normal, ray.direction) > 0) normal = -normal;
    const glm::vec3 mirrored = glm::reflect(ray.direction, normal);
    float key = std::max(0.0F, dot(normal, sun));
    if (key > 0 && nearest(intersect_disc, Ray{hit.point, sun, 1e-3F}, discs).id != 0) key = 0;
    if (hit.id == 1) {
        const float distance = length(hit.point);
        const bool odd = static_cast<int>(distance / 0.29F) % 2 == 1;
        const glm::vec3 color = odd ? glm::vec3(0.20F, 0.19F, 0.26F) : glm::vec3(0.035F, 0.035F, 0.06F);
        const glm::vec3 light = color * (0.16F + 0.95F * key);
        if (mirrors == 0) return light;
        const float share = 0.22F + 0.7F * std::pow(1 - std::abs(ray.direction.y), 4.0F);
        return light + share * sequin_light(Ray{hit.point, mirrored, 1e-3F}, discs, mirrors - 1);
    }
    const glm::vec3 outwards = discs[hit.id - 1].normal;
    const float hue = 0.86F + 0.29F * outwards.y + 0.04F * std::sin(3 * std::atan2(outwards.z, outwards.x));
    const glm::vec3 color(srgb_decoded(glm::dvec3(rainbow(hue, 0.78F, 1))));
    const float glance = std::pow(std::max(0.0F, dot(mirrored, sun)), 24.0F);
    const bool inside = dot(outwards, normal) < 0;
    return color * ((inside ? 0.05F : 0.16F) + 0.85F * key) + (key > 0 ? 1.2F * glance : 0);
}

}
