#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <kit/color.hpp>
#include <limits>
#include <umbral/core/ray.hpp>

/// What is there to pick: polished balls on a floor, by a small ray tracer of the driver's own.
namespace umbral::interaction {

struct Ball {
    glm::vec3 centre;
    float radius;
    glm::vec3 color;  ///< linear
};

inline const std::array<Ball, 7>& balls()
{
    const auto color = [](float hue) { return glm::vec3(srgb_decoded(glm::dvec3(rainbow(hue, 0.66F, 0.94F)))); };
    static const std::array<Ball, 7> all = {{{{-1.75F, 0.62F, -0.9F}, 0.62F, color(0.58F)},
                                             {{-0.45F, 0.8F, -1.9F}, 0.8F, color(0.09F)},
                                             {{1.15F, 0.7F, -1.25F}, 0.7F, color(0.36F)},
                                             {{-0.62F, 0.36F, 0.15F}, 0.36F, color(0.95F)},
                                             {{0.42F, 0.27F, 0.3F}, 0.27F, color(0.14F)},
                                             {{1.75F, 0.32F, 0.1F}, 0.32F, color(0.72F)},
                                             {{0.35F, 0.45F, -0.75F}, 0.45F, color(0.5F)}}};
    return all;
}

/// What a ray meets first: a ball's place in the list plus one, 0 for the floor, and where; t is infinite for nothing.
struct Met {
    std::uint32_t id = 0;
    float t = std::numeric_limits<float>::infinity();
    glm::vec3 normal{0, 1, 0};
};

/// Between t_min and t_max of the ray, whose direction is a unit vector.
inline Met first_met(const Ray& ray)
{
    Met met;
    met.t = ray.t_max;
    bool any = false;
    const float floor = -ray.origin.y / ray.direction.y;
    if (floor > ray.t_min && floor < met.t) met = {0, floor, {0, 1, 0}}, any = true;
    for (std::size_t i = 0; i < balls().size(); ++i) {
        const Ball& ball = balls()[i];
        const glm::vec3 aside = ray.origin - ball.centre;
        const float along = -dot(aside, ray.direction);
        const float chord = ball.radius * ball.radius - dot(aside, aside) + along * along;
        if (!(chord > 0)) continue;
        const float t = along - std::sqrt(chord);
        if (!(t > ray.t_min && t < met.t)) continue;
        met = {static_cast<std::uint32_t>(i + 1), t, (aside + t * ray.direction) / ball.radius};
        any = true;
    }
    if (!any) met.t = std::numeric_limits<float>::infinity();
    return met;
}

inline glm::vec3 backdrop(const glm::vec3& direction)
{
    return glm::mix(glm::vec3(0.035F, 0.05F, 0.10F), glm::vec3(0.004F, 0.006F, 0.016F),
                    glm::smoothstep(-0.1F, 0.55F, direction.y));
}

/// The light that comes back along a ray. `picked` is the ball that glows; polished things show others once.
inline glm::vec3 light_of_balls(const Ray& ray, std::uint32_t picked, bool mirrors = true)
{
    const Met met = first_met(ray);
    if (!std::isfinite(met.t)) return backdrop(ray.direction);
    const glm::vec3 place = ray.origin + met.t * ray.direction;
    const glm::vec3 sun = normalize(glm::vec3(-0.55F, 0.9F, 0.45F));
    const glm::vec3 lifted = place + 1e-3F * met.normal;
    float key = std::max(0.0F, dot(met.normal, sun));
    if (key > 0 && std::isfinite(first_met({lifted, sun, 0, 20}).t)) key = 0;
    const glm::vec3 mirrored = glm::reflect(ray.direction, met.normal);
    const float facing = std::clamp(-dot(ray.direction, met.normal), 0.0F, 1.0F);
    const float polish = 0.04F + 0.5F * std::pow(1 - facing, 5.0F);
    const glm::vec3 around = mirrors ? light_of_balls({lifted, mirrored, 0, 40}, picked, false) : backdrop(mirrored);
    if (met.id == 0) {
        const bool odd = (static_cast<int>(std::floor(place.x)) + static_cast<int>(std::floor(place.z))) % 2 != 0;
        float shade = 1;
        for (const Ball& ball : balls()) {
            const float reach = length(glm::vec2(place.x - ball.centre.x, place.z - ball.centre.z)) / ball.radius;
            shade *= 1 - 0.55F * std::exp(-1.6F * reach * reach);
        }
        const glm::vec3 tile = odd ? glm::vec3(0.085F, 0.10F, 0.15F) : glm::vec3(0.17F, 0.19F, 0.25F);
        glm::vec3 light = tile * shade * (0.22F + 0.9F * key) + polish * around;
        if (picked > 0 && picked <= balls().size()) {
            const Ball& ball = balls()[picked - 1];
            const glm::vec3 to = place - ball.centre;
            light += ball.color * 0.10F * ball.radius * ball.radius / (dot(to, to) + 0.02F);
        }
        const float fade = std::exp(-0.012F * dot(place, place));
        return glm::mix(backdrop(ray.direction), light, fade);
    }
    const Ball& ball = balls()[met.id - 1];
    const float glance = key > 0 ? std::pow(std::max(0.0F, dot(mirrored, sun)), 60.0F) : 0.0F;
    const float sky = 0.5F + 0.5F * met.normal.y;
    glm::vec3 light = ball.color * (0.06F + 0.14F * sky + 0.85F * key) + 0.6F * glance + polish * around;
    if (met.id == picked) light = light + ball.color * 0.35F + glm::vec3(1.2F) * std::pow(1 - facing, 2.5F);
    return light;
}

}
