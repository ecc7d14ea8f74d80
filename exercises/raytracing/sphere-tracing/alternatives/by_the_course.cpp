// alternative: as the course writes it, with a point that moves; bodies folded into a corner, cells by sorting
#include <umbral/raytracing/sphere_tracing.hpp>
#include <vector>

namespace umbral::raytracing::sdf {

float ball_distance(const glm::vec3& p, float radius) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - radius; }

float box_distance(const glm::vec3& p, const glm::vec3& half)
{
    float sum = 0;
    float least = std::numeric_limits<float>::infinity();
    bool within = true;
    for (int i = 0; i < 3; ++i) {
        const float excess = std::fabs(p[i]) - half[i];
        if (excess > 0) {
            within = false;
            sum += excess * excess;
        } else {
            least = std::min(least, -excess);
        }
    }
    return within ? -least : std::sqrt(sum);
}

float torus_distance(const glm::vec3& p, float major, float minor)
{
    // To the nearest point of the circle.
    const glm::vec3 flat(p.x, 0, p.z);
    if (flat == glm::vec3(0)) return std::sqrt(p.y * p.y + major * major) - minor;
    return glm::distance(p, major * glm::normalize(flat)) - minor;
}

float capsule_distance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float radius)
{
    const glm::vec3 ab = b - a;
    const float before = glm::dot(p - a, ab);
    if (before <= 0) return glm::length(p - a) - radius;
    if (glm::dot(p - b, ab) >= 0) return glm::length(p - b) - radius;
    return glm::length(glm::cross(p - a, ab)) / glm::length(ab) - radius;
}

float menger_distance(const glm::vec3& p, int level)
{
    float m = box_distance(p, {1, 1, 1});
    // Within the cell, from -1 to 1.
    glm::vec3 q = p;
    float size = 1;
    for (int k = 0; k < level; ++k) {
        float u[3];
        for (int i = 0; i < 3; ++i) {
            float inside = std::fmod(q[i] + 1, 2.0F);
            if (inside < 0) inside += 2;
            q[i] = 3 * (inside - 1);
            u[i] = std::fabs(q[i]);
            // The next cells are a third as wide, and the middle one is centred here.
        }
        std::sort(u, u + 3);
        size /= 3;
        m = std::max(m, size * (1 - u[1]));
    }
    return m;
}

std::optional<TracedPoint> sphere_trace(const Ray& ray, std::span<const DistanceFunction> bodies,
                                        const TraceLimits& limits)
{
    if (bodies.empty() || limits.max_steps <= 0) return {};
    const glm::vec3 v = glm::normalize(ray.direction);
    glm::vec3 p = ray.origin + ray.t_min * ray.direction;
    float gone = 0;
    float d = 0;
    int looked_at = 0;
    std::vector<float> all(bodies.size());
    do {
        p += std::fabs(d) * v;
        gone += std::fabs(d);
        if (ray.t_min + gone / glm::length(ray.direction) >= ray.t_max) return {};
        for (std::size_t i = 0; i < bodies.size(); ++i) all[i] = bodies[i](p);
        d = *std::min_element(all.begin(), all.end());
        ++looked_at;
    } while (std::fabs(d) > limits.tolerance && looked_at < limits.max_steps);
    if (std::fabs(d) > limits.tolerance) return {};
    const auto object = std::min_element(all.begin(), all.end()) - all.begin();
    return TracedPoint{ray.t_min + gone / glm::length(ray.direction), static_cast<std::uint32_t>(object)};
}

}
