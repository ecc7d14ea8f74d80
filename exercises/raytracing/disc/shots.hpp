#pragma once

#include <cmath>
#include <optional>
#include <umbral/raytracing/disc.hpp>
#include <vector>

#include "../rays.hpp"

/// Rays aimed at discs so that the answer is known.
namespace umbral::raytracing {

/// One question put to a ray-disc intersection.
struct DiscShot {
    Ray ray;
    Disc disc;
};

/// How far inside the rim the line of the ray meets the plane, in radii; negative outside. In double, where the
/// products of floats are exact.
inline double depth_inside_rim(const DiscShot& shot)
{
    const glm::dvec3 normal(shot.disc.normal);
    const glm::dvec3 direction(shot.ray.direction);
    const glm::dvec3 to_origin = glm::dvec3(shot.ray.origin) - glm::dvec3(shot.disc.centre);
    const glm::dvec3 from_centre = to_origin - dot(to_origin, normal) / dot(direction, normal) * direction;
    return 1 - length(from_centre) / double{shot.disc.radius};
}

/// A disc with its centre in a cube, its normal of any direction and of length 1, or of any from 1/16 to 16.
inline Disc random_disc(Random& random)
{
    const glm::vec3 centre = 5.0F * random.in_cube();
    // One in six faces at right angles to an axis.
    glm::vec3 normal = random.unit_vector();
    if (random.below(6) == 0) {
        normal[static_cast<int>(random.below(3))] = 0;
        normal = normalize(normal);
    }
    const float length = std::exp2(random.uniform(-4, 4));
    return {centre, random.below(2) == 0 ? normal : length * normal, random.uniform(0.5F, 2)};
}

/// A ray of unit direction that meets the disc's plane `offset` radii from the centre, in a random direction from
/// there, with this sine of its angle with the plane, from `distance` radii away. Which side it comes from is random
/// too.
inline DiscShot aimed(const Disc& disc, double offset, double sine, double distance, Random& random)
{
    const glm::dvec3 normal = normalize(glm::dvec3(disc.normal));
    const double radius = disc.radius;
    const glm::dvec3 target = glm::dvec3(disc.centre) + offset * radius * perpendicular_to(normal, random);
    const double side = random.below(2) == 0 ? sine : -sine;
    const glm::dvec3 from = side * normal + std::sqrt(1 - sine * sine) * perpendicular_to(normal, random);
    return {aimed_at(target, from, distance * radius), disc};
}

/// The offset in radii of a place uniform in the disc, at most `most`.
inline double offset_inside(double most, Random& random) { return most * std::sqrt(random.uniform_double()); }

/// `count` pairs from 2 to 10 radii away, with sines of 0.2 or more; all keep 1 % of the radius from the rim.
inline std::vector<DiscShot> random_pairs(Random& random, int count)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < count; ++i) {
        const Disc disc = random_disc(random);
        const double sine = random.uniform(0.2F, 1);
        const double distance = random.uniform(2, 10);
        const DiscShot hit = aimed(disc, offset_inside(0.99, random), sine, distance, random);
        const DiscShot miss = aimed(disc, 1.01 + 0.5 * random.uniform_double(), sine, distance, random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

/// `count` pairs of rays that run nearly in the plane, with sines from 1e-4 to 1e-2, and keep a fifth of the radius
/// from the rim.
inline std::vector<DiscShot> grazing_pairs(Random& random, int count)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < count; ++i) {
        const Disc disc = random_disc(random);
        const double sine = std::pow(10.0, -2.0 - 2 * random.uniform_double());
        const double distance = random.uniform(2, 4);
        const DiscShot hit = aimed(disc, offset_inside(0.8, random), sine, distance, random);
        const DiscShot miss = aimed(disc, 1.2 + 0.5 * random.uniform_double(), sine, distance, random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

/// `count` pairs on discs as far from the world's origin as `away`, from 2 to 10 radii before them. They pass the rim
/// at 0.02 % to 2 % of the radius: there the world's coordinates are too coarse for `away` of 1e4 or more, and
/// distances from the centre are not.
inline std::vector<DiscShot> remote_pairs(Random& random, float away, int count)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < count; ++i) {
        Disc disc = random_disc(random);
        disc.centre = away * random.unit_vector();
        const double sine = random.uniform(0.3F, 1);
        const double distance = random.uniform(2, 10);
        const double depth = 0.02 * std::pow(10.0, -2 * random.uniform_double());
        const DiscShot hit = aimed(disc, 1 - depth, sine, distance, random);
        const DiscShot miss = aimed(disc, 1 + depth, sine, distance, random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

}
