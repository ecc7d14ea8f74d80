// alternative: computes in double, with recursion for the sponge and for the ray
#include <umbral/raytracing/sphere_tracing.hpp>

namespace umbral::raytracing::sdf {
namespace {

using V = glm::dvec3;

double box(V p, V half)
{
    const V q = glm::abs(p) - half;
    const double inside = glm::min(glm::max(q.x, glm::max(q.y, q.z)), 0.0);
    return glm::length(glm::max(q, V(0))) + inside;
}

// The depth in the tunnels of this cell, whose half width is `half`, or of those within it.
double tunnels(V p, double half, int levels)
{
    if (levels == 0) return -1e9;
    const V from = glm::abs(p);
    const double largest = glm::max(from.x, glm::max(from.y, from.z));
    const double smallest = glm::min(from.x, glm::min(from.y, from.z));
    const double w = from.x + from.y + from.z - largest - smallest;
    const double third = half / 3;
    V inner;
    for (int i = 0; i < 3; ++i) inner[i] = p[i] - 2 * third * std::floor((p[i] + half) / (2 * third)) + half - third;
    return std::max(third - w, tunnels(inner, third, levels - 1));
}

std::optional<TracedPoint> go(const Ray& ray, double t, std::span<const DistanceFunction> bodies, double tolerance,
                              int steps)
{
    if (steps == 0 || t >= double(ray.t_max)) return std::nullopt;
    const glm::vec3 p(V(ray.origin) + t * V(ray.direction));
    double least = 1e300;
    std::uint32_t which = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
        if (const double d = bodies[i](p); d < least) {
            least = d;
            which = i;
        }
    if (std::abs(least) <= tolerance) return TracedPoint{static_cast<float>(t), which};
    return go(ray, t + std::abs(least) / glm::length(V(ray.direction)), bodies, tolerance, steps - 1);
}

}

float ball_distance(const glm::vec3& p, float radius) { return static_cast<float>(glm::length(V(p)) - double(radius)); }

float box_distance(const glm::vec3& p, const glm::vec3& half) { return static_cast<float>(box(V(p), V(half))); }

float torus_distance(const glm::vec3& p, float major, float minor)
{
    return static_cast<float>(std::hypot(std::hypot(double(p.x), double(p.z)) - double(major), double(p.y)) -
                              double(minor));
}

float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius)
{
    const V ab = V(b) - V(a);
    double s = glm::dot(V(p) - V(a), ab) / glm::dot(ab, ab);
    if (!(s > 0)) s = 0;
    if (s > 1) s = 1;
    return static_cast<float>(glm::length(V(p) - V(a) - s * ab) - double(radius));
}

float menger_distance(const glm::vec3& p, int level)
{
    V q(p);
    for (int i = 0; i < 3; ++i) q[i] -= 2 * std::floor((q[i] + 1) / 2);
    return static_cast<float>(std::max(box(V(p), V(1)), tunnels(q, 1, level)));
}

std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                        const TraceLimits& limits)
{
    if (bodies.empty()) return std::nullopt;
    return go(ray, ray.t_min, bodies, limits.tolerance, std::max(0, limits.max_steps));
}

}
