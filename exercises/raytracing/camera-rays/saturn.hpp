#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <umbral/raytracing/camera_rays.hpp>

/// The goal picture: a planet with fine rings before stars, all of it finer than a pixel somewhere.
namespace umbral::raytracing {

inline const glm::vec3 planet_sun = glm::normalize(glm::vec3(-0.8F, 0.36F, 0.62F));

/// How much of the light the rings stop at this distance from the planet's middle, whose radius is 1.
inline float ring_density(float radius)
{
    if (radius < 1.24F || radius > 2.27F) return 0;
    const float grooves = 0.5F + 0.5F * std::sin(95 * radius) * std::sin(41 * radius + 1) * std::cos(13 * radius);
    float density = 0.92F;
    if (radius < 1.52F) density = 0.12F + 0.35F * glm::smoothstep(1.24F, 1.52F, radius);
    if (radius > 1.95F) density = 0.62F;
    if (radius > 1.945F && radius < 2.03F) density = 0.03F;
    if (radius > 2.205F && radius < 2.22F) density = 0.02F;
    return density * (0.55F + 0.45F * grooves);
}

/// The distance at which a ray of unit direction meets a ball, or infinity.
inline float meets_globe(const glm::vec3& origin, const glm::vec3& direction, const glm::vec3& centre, float radius)
{
    const glm::vec3 e = centre - origin;
    const float middle = dot(e, direction);
    const glm::vec3 aside = e - middle * direction;
    const float inside = radius * radius - dot(aside, aside);
    const float t = inside > 0 ? middle - std::sqrt(inside) : -1;
    return t > 1e-3F ? t : std::numeric_limits<float>::infinity();
}

/// One number in [0, 1) for each cell of a grid.
inline float cell_noise(int x, int y, int layer)
{
    auto n = static_cast<std::uint32_t>(x) * 0x8da6b343U + static_cast<std::uint32_t>(y) * 0xd8163841U +
             static_cast<std::uint32_t>(layer) * 0xcb1ab31fU;
    n = (n ^ (n >> 15U)) * 0x2c1b3c6dU;
    n = (n ^ (n >> 12U)) * 0x297a2d39U;
    return static_cast<float>((n ^ (n >> 15U)) >> 8U) * 0x1p-24F;
}

inline glm::vec3 star_light(const glm::vec3& d)
{
    const float band = d.y + 0.55F * d.x + 0.2F;
    glm::vec3 light =
        glm::vec3(0.0018F, 0.0024F, 0.0065F) + glm::vec3(0.016F, 0.011F, 0.026F) * std::exp(-9 * band * band) *
                                                   (0.6F + 0.4F * std::sin(9 * d.x + 4 * std::sin(7 * d.y)));
    const glm::vec2 place = 46.0F * glm::vec2(d.x, d.y) / std::max(0.2F, std::abs(d.z));
    const glm::ivec2 cell(glm::floor(place));
    const float brightness = cell_noise(cell.x, cell.y, 0);
    const glm::vec2 star(cell_noise(cell.x, cell.y, 1), cell_noise(cell.x, cell.y, 2));
    const float away = length(place - glm::vec2(cell) - 0.2F - 0.6F * star);
    if (brightness > 0.8F && away < 0.055F) {
        const float warm = cell_noise(cell.x, cell.y, 3);
        light += 9.0F * std::pow(brightness, 9.0F) *
                 glm::mix(glm::vec3(0.6F, 0.75F, 1.2F), glm::vec3(1.2F, 0.9F, 0.6F), warm);
    }
    return light;
}

inline glm::vec3 globe_light(const glm::vec3& p)
{
    const float key = std::max(0.0F, dot(p, planet_sun));
    const float bands =
        0.5F + 0.28F * std::sin(17 * p.y + 0.6F) + 0.22F * std::sin(39 * p.y + 0.15F * std::sin(5 * p.x));
    const glm::vec3 color = glm::mix(glm::vec3(0.55F, 0.36F, 0.19F), glm::vec3(0.93F, 0.80F, 0.56F), bands);
    float sunlight = 1;
    const float t = -p.y / planet_sun.y;
    if (t > 0) sunlight = 1 - 0.85F * ring_density(length(p + t * planet_sun));
    return color * (1.25F * key * sunlight + 0.006F);
}

/// The light along a ray of unit direction.
inline glm::vec3 saturn_light(const Ray& ray)
{
    const glm::vec3& o = ray.origin;
    const glm::vec3& d = ray.direction;
    const float globe = meets_globe(o, d, glm::vec3(0), 1);
    const glm::vec3 moon_centre(2.15F, 0.62F, 0.9F);
    const float moon = meets_globe(o, d, moon_centre, 0.085F);
    glm::vec3 light(0);
    if (globe < moon)
        light = globe_light(o + globe * d);
    else if (moon < globe)
        light = glm::vec3(0.62F, 0.63F, 0.66F) *
                (1.2F * std::max(0.0F, dot((o + moon * d - moon_centre) / 0.085F, planet_sun)) + 0.006F);
    else
        light = star_light(d);

    const float plane = -o.y / d.y;
    if (!(plane > 0 && plane < std::min(globe, moon))) return light;
    const glm::vec3 p = o + plane * d;
    const float density = ring_density(length(p));
    const bool in_shadow = meets_globe(p, planet_sun, glm::vec3(0), 1) < 100;
    const glm::vec3 ring = glm::mix(glm::vec3(0.60F, 0.47F, 0.33F), glm::vec3(0.95F, 0.86F, 0.70F), density);
    return glm::mix(light, ring * (in_shadow ? 0.012F : 0.95F), density);
}

}
