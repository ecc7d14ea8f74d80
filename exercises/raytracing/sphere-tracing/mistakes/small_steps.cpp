// mistake: goes on by small steps of one length, whatever the distance
// credit: 40..80
// hint: Where nothing is near the ray may go far: by the distance itself. With steps of one length it passes what is
// thin, and max_steps are used up soon.
#include <umbral/raytracing/sphere_tracing.hpp>

namespace umbral::raytracing::sdf {

float ball_distance(const glm::vec3& p, float radius) { return glm::length(p) - radius; }

float box_distance(const glm::vec3& p, const glm::vec3& half)
{
    const glm::vec3 beyond = glm::abs(p) - half;
    return glm::length(glm::max(beyond, 0.0F)) + std::min(0.0F, std::max({beyond.x, beyond.y, beyond.z}));
}

float torus_distance(const glm::vec3& p, float major, float minor)
{
    const float from_circle = std::hypot(p.x, p.z) - major;
    return std::hypot(from_circle, p.y) - minor;
}

float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius)
{
    if (a == b) return glm::distance(p, a) - radius;
    const float part = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0F, 1.0F);
    return glm::distance(p, glm::mix(a, b, part)) - radius;
}

float menger_distance(const glm::vec3& p, int level)
{
    float sponge = box_distance(p, glm::vec3(1));
    float scale = 1;
    for (int k = 1; k <= level; ++k) {
        const float width = 2 / scale;
        const glm::vec3 middle = width * (glm::floor((p + 1.0F) / width) + 0.5F) - 1.0F;
        scale *= 3;
        const glm::vec3 u = glm::abs(scale * (p - middle));
        const float second = u.x + u.y + u.z - std::min({u.x, u.y, u.z}) - std::max({u.x, u.y, u.z});
        sponge = std::max(sponge, (1 - second) / scale);
    }
    return sponge;
}

std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                        const TraceLimits& limits)
{
    const float step = 0.05F / glm::length(ray.direction);
    float t = ray.t_min;
    for (int i = 0; i < limits.max_steps && t < ray.t_max; ++i) {
        for (std::uint32_t object = 0; object < bodies.size(); ++object)
            if (bodies[object](ray.origin + t * ray.direction) <= limits.tolerance) return TracedPoint{t, object};
        t += step;
    }
    return std::nullopt;
}

}
