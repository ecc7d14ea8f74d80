#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>
#include <vector>

namespace umbral::raytracing {

struct ShadowBall {
    glm::vec3 centre;
    float radius;  ///< more than 0
};

struct ShadowTriangle {
    glm::vec3 a, b, c;
};

/// All that can stand in the light's way, both sides of it.
struct ShadowCasters {
    std::vector<ShadowBall> balls;
    std::vector<ShadowTriangle> triangles;
};

/// A point of a surface as a ray tracer finds it. Its coordinates are rounded, so that it may lie a little above the
/// surface or below.
struct ShadedPoint {
    glm::vec3 position;
    glm::vec3 normal;  ///< unit, on the side of the surface that is looked at
    float error;  ///< the surface's own point differs from `position` by at most this in x, as much in y, and in z;
                  ///< half an ulp of the largest coordinate or more
};

/// Does the ray meet a ball, with t strictly between t_min and t_max? Ray and ball are taken as they are: computed in
/// double, of which no rounding shows.
[[nodiscard]] inline bool meets(const ShadowBall& ball, const Ray& ray)
{
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 to_origin = glm::dvec3(ray.origin) - glm::dvec3(ball.centre);
    const double a = dot(direction, direction);
    const double b = dot(to_origin, direction);
    const double c = (length(to_origin) - double{ball.radius}) * (length(to_origin) + double{ball.radius});
    const double d = b * b - a * c;
    if (!(d >= 0)) return false;
    const double q = -(b + std::copysign(std::sqrt(d), b));
    const auto counts = [&](double t) { return t > double{ray.t_min} && t < double{ray.t_max}; };
    return counts(q / a) || counts(c / q);
}

/// The same for a triangle.
[[nodiscard]] inline bool meets(const ShadowTriangle& triangle, const Ray& ray)
{
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 to_a = glm::dvec3(triangle.a) - glm::dvec3(ray.origin);
    const glm::dvec3 ab = glm::dvec3(triangle.b) - glm::dvec3(triangle.a);
    const glm::dvec3 ac = glm::dvec3(triangle.c) - glm::dvec3(triangle.a);
    const glm::dvec3 normal = cross(ab, ac);
    const double slope = dot(direction, normal);
    const double t = dot(to_a, normal) / slope;
    if (!(t > double{ray.t_min} && t < double{ray.t_max})) return false;
    const glm::dvec3 aside = cross(to_a, direction);
    const double u = dot(ac, aside) / slope;
    const double v = -dot(ab, aside) / slope;
    return u >= 0 && v >= 0 && u + v <= 1;
}

/// Is there anything on the ray, with t strictly between t_min and t_max? `ray.direction` need not be unit: t counts in
/// its lengths.
[[nodiscard]] inline bool meets_any(const ShadowCasters& casters, const Ray& ray)
{
    const auto is_met = [&](const auto& caster) { return meets(caster, ray); };
    return std::any_of(casters.balls.begin(), casters.balls.end(), is_met) ||
           std::any_of(casters.triangles.begin(), casters.triangles.end(), is_met);
}

/// Does the light reach the point, V(p, q) = 1? With w = 1 `light` is a place, with w = 0 a direction **towards** the
/// light, of any length, and the light is endlessly far away. No other w occurs.
///
/// The light reaches no point whose surface is turned away from it. Otherwise it does unless there is a caster between:
/// what lies beyond a light at a place is no matter.
/// The surface of the point may itself be among the casters, and must not shade the point: it is a triangle of a convex
/// body that `position` lies on, or a ball, and the normal leads out of it. All other casters are 16 errors or more
/// away from the point, and further from the light than a hundredth of the way from the point to the light. The light
/// is above or below the point's plane by 0.001 of its distance or more.
/// Guarantee of the reference: so it is, from 1e-4 to 1e7 in size and in distance from the world's origin.
/// Course: section D 1G, "sombras arrojadas".
[[nodiscard]] bool sees_light(const ShadedPoint& point, const glm::vec4& light, const ShadowCasters& casters);

}
