#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <umbral/raytracing/sphere_tracing.hpp>
#include <vector>

#include "../rays.hpp"

/// Bodies whose distances the driver knows, so that a ray's question does not depend on the unit's own distances; and
/// rays aimed at them. The distances count how often they are asked.
namespace umbral::raytracing::sdf {

using Bodies = std::vector<DistanceFunction>;

/// Stops a loop that does not end.
class AskedTooOften {
public:
    void count()
    {
        if (++asked_ > 20'000) throw std::length_error("more than 20,000 distances for one ray: does the loop end?");
    }

private:
    int asked_ = 0;
};

inline DistanceFunction counted(DistanceFunction distance)
{
    return [count = std::make_shared<AskedTooOften>(), distance = std::move(distance)](const glm::vec3& p) {
        count->count();
        return distance(p);
    };
}

inline DistanceFunction ball_at(const glm::vec3& centre, float radius)
{
    return counted([=](const glm::vec3& p) {
        return static_cast<float>(glm::distance(glm::dvec3(p), glm::dvec3(centre)) - double{radius});
    });
}

/// All points below a plane.
inline DistanceFunction half_space(const glm::vec3& unit_normal, float height)
{
    return counted([=](const glm::vec3& p) {
        return static_cast<float>(dot(glm::dvec3(unit_normal), glm::dvec3(p)) - double{height});
    });
}

/// All points beyond x; before it the distance is said to be no more than a step.
inline DistanceFunction in_steps(float x, float step)
{
    return counted([=](const glm::vec3& p) { return std::min(step, x - p.x); });
}

/// Near to nothing anywhere.
inline DistanceFunction everywhere(float distance)
{
    return counted([=](const glm::vec3&) { return distance; });
}

/// A question to sphere_trace.
struct TraceShot {
    Ray ray;
    Bodies bodies;
    TraceLimits limits;
};

/// Some balls, two of which overlap.
struct Balls {
    std::vector<glm::vec4> balls;  ///< centre and radius

    [[nodiscard]] Bodies bodies() const
    {
        Bodies bodies;
        for (const glm::vec4& ball : balls) bodies.push_back(ball_at(glm::vec3(ball), ball.w));
        return bodies;
    }
};

inline Balls random_balls(Random& random, int count)
{
    Balls all;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre = 3.0F * random.in_cube();
        all.balls.emplace_back(centre, random.uniform(0.4F, 1));
    }
    if (count > 1) all.balls[1] = all.balls[0] + glm::vec4(0.3F * random.unit_vector(), 0.1F);
    return all;
}

/// How near the ray comes to the silhouette of a ball that it does not clearly meet or miss.
inline bool grazes(const Ray& ray, const Balls& all)
{
    for (const glm::vec4& ball : all.balls) {
        const glm::vec3 to = glm::vec3(ball) - ray.origin;
        const float miss = length(cross(to, ray.direction)) / length(ray.direction);
        if (std::abs(miss / ball.w - 1) < 0.08F) return true;
    }
    return false;
}

/// A ray from outside, three of four towards a ball, that grazes none: the first of forty that does not.
inline Ray clear_ray(const Balls& all, Random& random)
{
    const bool is_aimed = random.below(4) > 0;
    Ray ray;
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 from(random.unit_vector());
        glm::dvec3 target(3.0F * random.in_cube());
        if (is_aimed) {
            const glm::vec4 ball = all.balls[random.below(static_cast<std::uint32_t>(all.balls.size()))];
            const double aside = 0.85 * double{ball.w} * random.uniform_double();
            target = glm::dvec3(ball) + aside * perpendicular_to(from, random);
        }
        ray = aimed_at(target, from, random.uniform(12, 16));
        if (!grazes(ray, all)) break;
    }
    return ray;
}

using Walk = std::tuple<Ray, Balls>;

/// The ray begins outside, and neither a silhouette nor t_max decides; of two balls one is clearly met first.
inline bool is_clear(const Walk& walk)
{
    const auto& [ray, all] = walk;
    const float unit = length(ray.direction);
    if (!(unit > 0.25F && unit < 4) || grazes(ray, all)) return false;
    float first = ray.t_max;
    float second = ray.t_max + 1;
    for (const glm::vec4& ball : all.balls) {
        const glm::vec3 to = glm::vec3(ball) - ray.origin - ray.t_min * ray.direction;
        if (ball.w < 0.2F || ball.w > 2 || length(to) < ball.w + 0.1F) return false;
        const float middle = dot(to, ray.direction) / unit;
        const float miss = length(cross(to, ray.direction)) / unit;
        if (middle < 0 || miss > ball.w) continue;
        const float t = ray.t_min + (middle - std::sqrt(ball.w * ball.w - miss * miss)) / unit;
        if (std::abs(t - ray.t_max) < 0.1F) return false;
        second = std::min(second, std::max(t, first));
        first = std::min(first, t);
    }
    return second - first > 0.05F;
}

}
