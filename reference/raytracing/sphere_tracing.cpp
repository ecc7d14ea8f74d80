// Based on: J. C. Hart. Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing of Implicit Surfaces. The
// Visual Computer 12, 1996; and I. Quilez. Distance functions, and Menger fractal (iquilezles.org).

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/sphere_tracing.hpp>

namespace umbral::raytracing::sdf {

float ball_distance(const glm::vec3& p, float radius) { return length(p) - radius; }

float box_distance(const glm::vec3& p, const glm::vec3& half)
{
    // How far beyond the faces, in each coordinate; negative between them.
    const glm::vec3 beyond = abs(p) - half;
    const float outside = length(max(beyond, 0.0F));
    const float inside = std::min(0.0F, std::max({beyond.x, beyond.y, beyond.z}));
    return outside + inside;
}

float torus_distance(const glm::vec3& p, float major, float minor)
{
    const float from_circle = length(glm::vec2(p.x, p.z)) - major;
    return length(glm::vec2(from_circle, p.y)) - minor;
}

float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius)
{
    const glm::vec3 along = b - a;
    const float squared_length = dot(along, along);
    const float part = squared_length > 0 ? std::clamp(dot(p - a, along) / squared_length, 0.0F, 1.0F) : 0.0F;
    return distance(p, a + part * along) - radius;
}

float menger_distance(const glm::vec3& p, int level)
{
    float sponge = box_distance(p, glm::vec3(1));
    float scale = 1;
    for (int k = 1; k <= level; ++k) {
        const float width = 2 / scale;
        const glm::vec3 middle = width * (floor((p + 1.0F) / width) + 0.5F) - 1.0F;
        scale *= 3;
        const glm::vec3 u = abs(scale * (p - middle));
        const float second = std::max(std::min(u.x, u.y), std::min(std::max(u.x, u.y), u.z));
        sponge = std::max(sponge, (1 - second) / scale);
    }
    return sponge;
}

std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                        const TraceLimits& limits)
{
    const float unit = length(ray.direction);
    float t = ray.t_min;
    for (int step = 0; step < limits.max_steps && t < ray.t_max; ++step) {
        const glm::vec3 p = ray.origin + t * ray.direction;
        // Of no bodies the nearest is infinitely far, and the ray at its end.
        float nearest = std::numeric_limits<float>::infinity();
        std::uint32_t object = 0;
        for (std::uint32_t i = 0; i < bodies.size(); ++i) {
            const float d = bodies[i](p);
            if (d < nearest) {
                nearest = d;
                object = i;
            }
        }
        if (std::abs(nearest) <= limits.tolerance) return TracedPoint{t, object};
        t += std::abs(nearest) / unit;
    }
    return std::nullopt;
}

}
