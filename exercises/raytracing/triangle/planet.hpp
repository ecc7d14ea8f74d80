#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../cast.hpp"
#include "shots.hpp"

/// The goal picture: a small planet of facets, whose edges glow where a barycentric coordinate is near 0.
namespace umbral::raytracing {

/// The unit's function, one of several called intersect.
inline constexpr std::optional<TriangleHit> (*intersect_triangle)(const Ray&, const Triangle&) = intersect;

/// The nearest triangle along a ray of unit direction: its place in the list plus one (0 for none), and the hit.
struct NearestTriangle {
    std::uint32_t id = 0;
    TriangleHit hit{};
};

/// `meets(ray, triangle)` is the unit's function, or the question what it answers. The driver's own test of a ball
/// round each triangle spares most questions.
template <class Meets>
NearestTriangle nearest(Meets meets, Ray ray, const std::vector<Triangle>& triangles)
{
    const auto passes = [&](const glm::vec3& centre, float reach) {
        const glm::vec3 aside = cross(centre - ray.origin, ray.direction);
        return dot(aside, aside) < reach * reach;
    };
    NearestTriangle found;
    if (!passes(glm::vec3(0), 1.2F)) return found;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& triangle = triangles[i];
        if (!passes((triangle.v0 + triangle.v1 + triangle.v2) / 3.0F, 0.3F)) continue;
        const std::optional<TriangleHit> hit = meets(ray, triangle);
        if (!hit || !(hit->t < ray.t_max)) continue;
        ray.t_max = hit->t;
        found = {static_cast<std::uint32_t>(i + 1), *hit};
    }
    return found;
}

constexpr Camera planet_camera{{0.5F, 0.9F, 4.6F}, {0, 0, 0}, 0.31F};

/// A glow behind the planet.
inline glm::vec3 space(const glm::vec3& direction)
{
    const float across = length(cross(direction, normalize(planet_camera.eye)));
    return glm::mix(glm::vec3(0.05F, 0.08F, 0.24F), glm::vec3(0.003F, 0.004F, 0.012F),
                    glm::smoothstep(0.16F, 0.4F, across));
}

/// The light that comes back along a ray.
inline glm::vec3 planet_light(const Ray& ray, const std::vector<Triangle>& triangles)
{
    const NearestTriangle found = nearest(intersect_triangle, ray, triangles);
    if (found.id == 0) return space(ray.direction);
    const Triangle& triangle = triangles[found.id - 1];
    glm::vec3 normal = normalize(cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0));
    if (dot(normal, ray.direction) > 0) normal = -normal;
    const glm::vec3 sun = normalize(glm::vec3(-0.75F, 0.7F, 0.6F));
    const float key = std::max(0.0F, dot(normal, sun));
    const float height = length((triangle.v0 + triangle.v1 + triangle.v2) / 3.0F);
    const float land = glm::smoothstep(0.9F, 1.1F, height);
    const glm::vec3 color(srgb_decoded(glm::dvec3(rainbow(0.58F - 0.46F * land, 0.75F, 0.95F))));
    const float glance = std::pow(std::max(0.0F, dot(glm::reflect(ray.direction, normal), sun)), 12.0F);
    const auto [t, a, b] = found.hit;
    const float to_edge = std::min({a, b, 1 - a - b});
    const float glow = 1 - glm::smoothstep(0.0F, 0.045F, to_edge);
    return color * (0.05F + 0.9F * key) + 0.25F * glance + glow * (0.06F + 0.5F * key) * glm::vec3(1, 0.93F, 0.8F);
}

}
