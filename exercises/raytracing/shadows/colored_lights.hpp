#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <umbral/raytracing/shadows.hpp>

#include "../cast.hpp"
#include "../rays.hpp"

/// The goal picture: a spiral of white balls round a white obelisk, under a red, a green and a blue lamp. Where one
/// lamp is hidden the floor shows the colour of the other two.
namespace umbral::raytracing {

inline constexpr std::array<glm::vec4, 3> colored_lamps = {
    glm::vec4(-5.0F, 7.4F, 4.2F, 1), {5.6F, 7.0F, 3.4F, 1}, {-0.4F, 7.8F, -6.2F, 1}};
inline constexpr std::array<glm::vec3, 3> lamp_colors = {
    glm::vec3(1.0F, 0.05F, 0.06F), {0.05F, 0.80F, 0.08F}, {0.10F, 0.16F, 1.20F}};

inline ShadowCasters spiral_of_balls()
{
    ShadowCasters casters;
    constexpr int balls = 30;
    for (int i = 0; i < balls; ++i) {
        const float share = static_cast<float>(i) / (balls - 1);
        const float angle = 13.2F * share + 0.4F;
        const float away = 2.35F - 1.75F * share;
        const float radius = 0.27F - 0.15F * share;
        casters.balls.push_back({{away * std::cos(angle), radius + 2.45F * share, away * std::sin(angle)}, radius});
    }
    casters.balls.push_back({{0, 2.78F, 0}, 0.3F});
    const glm::vec3 top(0, 2.5F, 0);
    const glm::vec3 base[] = {{0.42F, 0, 0}, {0, 0, -0.42F}, {-0.42F, 0, 0}, {0, 0, 0.42F}};
    for (int i = 0; i < 4; ++i) casters.triangles.push_back({base[i], base[(i + 1) % 4], top});
    const glm::vec3 corners[] = {{-40, 0, 40}, {40, 0, 40}, {40, 0, -40}, {-40, 0, -40}};
    casters.triangles.push_back({corners[0], corners[1], corners[2]});
    casters.triangles.push_back({corners[0], corners[2], corners[3]});
    return casters;
}

/// What a ray of unit direction meets first: the driver's own search. The error is that of a point computed in float.
struct WhitePoint {
    ShadedPoint shaded;
    bool is_met = false;
};

inline WhitePoint nearest_white(const Ray& ray, const ShadowCasters& casters)
{
    WhitePoint nearest;
    float first = endless;
    glm::vec3 normal(0);
    for (const ShadowBall& ball : casters.balls) {
        const glm::vec3 e = ball.centre - ray.origin;
        const float middle = dot(e, ray.direction);
        const glm::vec3 aside = e - middle * ray.direction;
        const float inside = ball.radius * ball.radius - dot(aside, aside);
        if (inside < 0) continue;
        const float t = middle - std::sqrt(inside);
        if (t < 1e-3F || t >= first) continue;
        first = t;
        normal = (ray.origin + t * ray.direction - ball.centre) / ball.radius;
    }
    for (const ShadowTriangle& triangle : casters.triangles) {
        const glm::vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const float t = dot(triangle.a - ray.origin, n) / dot(ray.direction, n);
        if (!(t > 1e-3F && t < first)) continue;
        if (!meets(triangle, Ray{ray.origin, ray.direction, 0.5F * t, 2 * t})) continue;
        first = t;
        normal = n;
    }
    if (first == endless) return nearest;
    nearest.is_met = true;
    nearest.shaded.position = ray.origin + first * ray.direction;
    nearest.shaded.normal = normalize(normal);
    nearest.shaded.error = 1e-6F * std::max(1.0F, first);
    return nearest;
}

/// The light that comes back along a ray: that of the lamps that are seen, and a little from everywhere.
inline glm::vec3 lamp_light(const Ray& ray, const ShadowCasters& casters)
{
    const WhitePoint point = nearest_white(ray, casters);
    if (!point.is_met) return glm::vec3(0.004F, 0.004F, 0.008F);
    const glm::vec3& position = point.shaded.position;
    const glm::vec3& normal = point.shaded.normal;
    glm::vec3 light = 0.03F * glm::vec3(0.8F, 0.85F, 1) * (1.2F + normal.y);
    for (std::size_t i = 0; i < colored_lamps.size(); ++i) {
        if (!sees_light(point.shaded, colored_lamps[i], casters)) continue;
        const glm::vec3 towards = glm::vec3(colored_lamps[i]) - position;
        const float distance = length(towards);
        const float facing = std::max(0.0F, dot(normal, towards)) / distance;
        const float glance = std::max(0.0F, dot(glm::reflect(ray.direction, normal), towards)) / distance;
        const float gloss = normal.y > 0.999F ? 0.0F : 0.5F * std::pow(glance, 60.0F);
        light += lamp_colors[i] * (facing + gloss) * 70.0F / (distance * distance);
    }
    const float away = length(glm::vec2(position.x, position.z)) / 7.5F;
    return light * std::exp(-away * away);
}

}
