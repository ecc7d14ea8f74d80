#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <umbral/raytracing/reflect_refract.hpp>

#include "../cast.hpp"
#include "../rays.hpp"

/// The goal picture: balls of glass and one of metal on a floor of tiles. The driver finds what rays meet, and the unit
/// where they go on.
namespace umbral::raytracing {

/// A ball of index `inside` in a medium of index `outside`: glass in air, or a bubble in glass. `absorbed` is what a
/// length of it takes from each colour. One without an index is a mirror.
struct GlassBall {
    glm::vec3 centre;
    float radius;
    float outside;
    float inside;
    glm::vec3 absorbed;
};

inline constexpr float no_index = 0;

inline constexpr std::array glass_balls = {
    GlassBall{{0, 1.0F, 0}, 1.0F, 1, 1.5F, {0.06F, 0.02F, 0.015F}},
    GlassBall{{0.12F, 1.08F, 0.05F}, 0.46F, 1.5F, 1, {0, 0, 0}},
    GlassBall{{-2.05F, 0.75F, -0.45F}, 0.75F, 1, 1.5F, {0.12F, 1.5F, 1.7F}},
    GlassBall{{2.0F, 0.8F, -0.7F}, 0.8F, 1, 1.5F, {1.6F, 0.5F, 0.05F}},
    GlassBall{{1.12F, 0.42F, 1.05F}, 0.42F, 1, 2.42F, {0.02F, 0.02F, 0.02F}},
    GlassBall{{-1.05F, 0.45F, 1.1F}, 0.45F, 1, 1.33F, {0.05F, 0.5F, 2.6F}},
    GlassBall{{0.55F, 0.7F, -2.6F}, 0.7F, 1, no_index, {0, 0, 0}},
    GlassBall{{-3.3F, 0.6F, -3.4F}, 0.6F, 1, no_index, {0, 0, 0}},
};

inline const glm::vec3 glass_sun = glm::normalize(glm::vec3(-0.55F, 0.75F, -0.5F));

/// The first ball along a ray of unit direction, 1e-3 or more away.
struct GlassHit {
    const GlassBall* ball = nullptr;
    float t = endless;
};

inline GlassHit first_glass(const glm::vec3& origin, const glm::vec3& direction)
{
    GlassHit hit;
    for (const GlassBall& ball : glass_balls) {
        const glm::vec3 e = ball.centre - origin;
        const float middle = dot(e, direction);
        const glm::vec3 aside = e - middle * direction;
        const float inside = ball.radius * ball.radius - dot(aside, aside);
        if (inside <= 0) continue;
        const float half = std::sqrt(inside);
        for (const float t : {middle - half, middle + half}) {
            if (t < 1e-3F || t >= hit.t) continue;
            hit = {&ball, t};
            break;
        }
    }
    return hit;
}

inline glm::vec3 glass_sky(const glm::vec3& direction)
{
    const float height = std::clamp(direction.y, 0.0F, 1.0F);
    const glm::vec3 sky =
        glm::mix(glm::vec3(0.80F, 0.74F, 0.68F), glm::vec3(0.05F, 0.16F, 0.36F), std::pow(height, 0.55F));
    const float towards_sun = std::max(0.0F, dot(direction, glass_sun));
    return sky + glm::vec3(1.0F, 0.75F, 0.4F) * (std::pow(towards_sun, 24.0F) + 30 * std::pow(towards_sun, 2000.0F));
}

/// How much sun reaches the floor: glass takes its colour, and gathers the light behind the middle of a ball.
inline glm::vec3 floor_sun(const glm::vec3& point)
{
    glm::vec3 light(1);
    for (const GlassBall& ball : glass_balls) {
        const glm::vec3 aside = cross(ball.centre - point, glass_sun);
        const float share = dot(aside, aside) / (ball.radius * ball.radius);
        if (share >= 1 || ball.outside > 1) continue;
        if (ball.inside == no_index) return glm::vec3(0);
        const glm::vec3 tint = glm::exp(-1.3F * ball.radius * ball.absorbed);
        light *= tint * (0.22F + 2.6F * std::pow(1 - share, 5.0F));
    }
    return light;
}

inline glm::vec3 floor_light(const glm::vec3& point, float distance)
{
    const auto tile = static_cast<int>(std::floor(point.x / 0.8F) + std::floor(point.z / 0.8F));
    const bool dark = (tile & 1) != 0;
    const glm::vec3 color = dark ? glm::vec3(0.075F, 0.105F, 0.15F) : glm::vec3(0.66F, 0.62F, 0.56F);
    float open = 1;  // of the sky above
    for (const GlassBall& ball : glass_balls) {
        const float away = length(point - glm::vec3(ball.centre.x, 0, ball.centre.z)) / ball.radius;
        open *= 1 - 0.45F * std::exp(-1.6F * away * away);
    }
    const glm::vec3 light = color * (0.30F * open * glm::vec3(0.75F, 0.88F, 1.1F) +
                                     0.85F * floor_sun(point) * glm::vec3(1.15F, 0.98F, 0.78F));
    return glm::mix(light, glm::vec3(0.80F, 0.74F, 0.68F), 1 - std::exp(-0.0025F * distance * distance));
}

/// The share of light that a surface reflects (Schlick's approximation): `cosine` is that of the angle in the rarer
/// medium.
inline float reflected_share(float one, float other, float cosine)
{
    const float steep = (one - other) / (one + other);
    return steep * steep + (1 - steep * steep) * std::pow(1 - std::clamp(cosine, 0.0F, 1.0F), 5.0F);
}

/// The light that comes back along a ray of unit direction, after at most `bounces` more surfaces.
inline glm::vec3 glass_light(const glm::vec3& origin, const glm::vec3& direction, int bounces, float weight = 1)
{
    const GlassHit hit = first_glass(origin, direction);
    const float floor = direction.y < 0 ? -origin.y / direction.y : endless;
    if (floor < hit.t) return floor_light(origin + floor * direction, floor);
    if (hit.ball == nullptr || bounces == 0 || weight < 0.01F) return glass_sky(direction);

    const GlassBall& ball = *hit.ball;
    const glm::vec3 point = origin + hit.t * direction;
    const glm::vec3 normal = (point - ball.centre) / ball.radius;
    const float facing = -dot(direction, normal);
    const glm::vec3 mirrored = mirrored_direction(-direction, normal);
    if (ball.inside == no_index)
        return glm::vec3(0.86F, 0.80F, 0.70F) * glass_light(point, mirrored, bounces - 1, 0.8F * weight);

    float share = 1;
    glm::vec3 light(0);
    if (const auto refracted = refracted_direction(-direction, normal, ball.outside, ball.inside)) {
        const float cosine = std::min(std::abs(facing), std::abs(dot(*refracted, normal)));
        share = reflected_share(ball.outside, ball.inside, cosine);
        light = (1 - share) * glass_light(point, *refracted, bounces - 1, (1 - share) * weight);
    }
    if (share * weight > 0.01F) light += share * glass_light(point, mirrored, bounces - 1, share * weight);
    const glm::vec3 absorbed = facing < 0 ? ball.absorbed : glm::vec3(0);
    return light * glm::exp(-hit.t * absorbed);
}

}
