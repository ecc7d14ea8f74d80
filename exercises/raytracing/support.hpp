#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/intersect.hpp>
#include <umbral/record/ask.hpp>
#include <vector>

#include "rays.hpp"

/// Rays aimed at spheres so that the answer is known.
namespace umbral::raytracing {

/// One question put to a ray-sphere intersection.
struct BallShot {
    Ray ray;
    Sphere ball;
};

/// Distance between the sphere's centre and the line of the ray, in double: the products of the float inputs are exact,
/// so that for origins up to 1e6 radii away the result is good to 1e-9 radii.
inline double miss_distance(const BallShot& shot)
{
    const glm::dvec3 direction(shot.ray.direction);
    const glm::dvec3 to_origin = glm::dvec3(shot.ray.origin) - glm::dvec3(shot.ball.centre);
    return length(cross(to_origin, direction)) / length(direction);
}

/// How far the ray passes the silhouette, in ulps of its origin's distance from the centre.
inline double silhouette_margin(const BallShot& shot)
{
    const double distance = length(glm::dvec3(shot.ray.origin) - glm::dvec3(shot.ball.centre));
    return std::abs(miss_distance(shot) - double{shot.ball.radius}) / ulp_of(distance);
}

/// A ray of unit direction from a random side, its origin `distance` radii from the centre, that passes the centre at
/// `offset` radii but for the rounding of its direction.
inline BallShot aimed(const Sphere& ball, double distance, double offset, Random& random)
{
    const double radius = ball.radius;
    const glm::dvec3 outwards(random.unit_vector());
    const glm::vec3 origin(glm::dvec3(ball.centre) + distance * radius * outwards);
    const glm::dvec3 to_origin = glm::dvec3(origin) - glm::dvec3(ball.centre);
    const glm::dvec3 axis = normalize(to_origin);
    // The tangent cone is narrower than the silhouette: tilt by the angle whose sine is offset / distance.
    const double sine = offset * radius / length(to_origin);
    const glm::dvec3 direction = -std::sqrt(1 - sine * sine) * axis + sine * perpendicular_to(axis, random);
    return {Ray{origin, glm::vec3(direction)}, ball};
}

inline Sphere random_ball(Random& random)
{
    const glm::vec3 centre = 5.0F * random.in_cube();
    return {centre, random.uniform(0.5F, 2)};
}

/// `count` pairs from origins 2 to 10 radii away; hits keep 1 % of the radius from the silhouette, so that no rounding
/// decides.
inline std::vector<BallShot> random_pairs(Random& random, int count)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < count; ++i) {
        const Sphere ball = random_ball(random);
        const double distance = random.uniform(2, 10);
        const BallShot hit = aimed(ball, distance, 0.99 * std::sqrt(random.uniform_double()), random);
        const BallShot miss = aimed(ball, distance, 1.01 + 0.5 * random.uniform_double(), random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

/// `count` pairs from `distance` radii away: hits uniform over a disc of at most 0.99 radii, misses up to 0.3 radii
/// outside. Both pass the silhouette at `margin` ulps of the distance at least: they are aimed two ulps farther off,
/// and rounding the direction moves them by one.
inline std::vector<BallShot> silhouette_pairs(Random& random, double distance, int count, double margin)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < count; ++i) {
        const Sphere ball{random.in_cube(), random.uniform(0.5F, 2)};
        const double band = (margin + 2) * ulp_of(distance * double{ball.radius}) / double{ball.radius};
        const BallShot hit =
            aimed(ball, distance, std::min(0.99, 1 - band) * std::sqrt(random.uniform_double()), random);
        const BallShot miss = aimed(ball, distance, 1 + band + 0.3 * random.uniform_double(), random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

/// The nearest ball along a ray: its place in the list plus one (0 for none), and the outward normal there.
struct BallHit {
    std::uint32_t id = 0;
    glm::vec3 point{0};
    glm::vec3 normal{0};
};

inline BallHit nearest(Recorder& out, Ray ray, const std::vector<Sphere>& balls)
{
    BallHit hit;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const std::optional<float> t = ask<intersect>(out, ray, balls[i]);
        if (!t || !(*t < ray.t_max)) continue;
        ray.t_max = *t;
        hit.id = static_cast<std::uint32_t>(i + 1);
        hit.point = ray.origin + *t * ray.direction;
        hit.normal = (hit.point - balls[i].centre) / balls[i].radius;
    }
    return hit;
}

}
