#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

/// Rays for the drivers of ray tracing, whatever surface they are aimed at.
namespace umbral::raytracing {

inline constexpr float endless = std::numeric_limits<float>::infinity();
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Factors for the end of an interval that lies just beyond an exact root, or just before it: hundreds of times nearer
/// than a hundredth, and a hundred ulp away, so that rounding decides nothing.
inline constexpr float barely_more = 1 + 0x1p-16F;
inline constexpr float barely_less = 1 - 0x1p-16F;

/// The size of a figure whose numbers are small integers times a power of two: exact at any of these sizes, from 1e-6
/// to 4096, so that only tolerances that are lengths tell them apart.
inline float exact_size(Random& random) { return std::ldexp(1.0F, static_cast<int>(random.below(33)) - 20); }

/// What all lengths of a figure are multiplied by if inputs are to vary: t too, if the direction is not. Small whole
/// numbers and halves stay exact.
inline float other_size(Variation& vary) { return vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.25F, 1.5F, 3.0F}); }

/// The ray in a figure so many times as large.
inline Ray sized(Ray ray, float size)
{
    ray.origin *= size;
    ray.t_min *= size;
    ray.t_max *= size;
    return ray;
}

/// Pairs one after the other, each of them turned round or not: which one meets something is not told by its place.
template <class Shot>
std::vector<Shot> in_pairs(Random& random, std::vector<Shot> shots)
{
    for (std::size_t i = 0; i + 1 < shots.size(); i += 2)
        if (random.below(2) == 1) std::swap(shots[i], shots[i + 1]);
    return shots;
}

/// The same if inputs are to vary; else as written.
template <class Shot>
std::vector<Shot> in_pairs(Variation& vary, std::vector<Shot> shots)
{
    Random* const random = vary.random();
    return random != nullptr ? in_pairs(*random, std::move(shots)) : shots;
}

/// The same points of the same line, by a direction that is `length` times as long: t counts in it.
inline Ray counted_in(Ray ray, float length)
{
    ray.direction *= length;
    ray.t_min /= length;
    ray.t_max /= length;
    return ray;
}

/// One unit in the last place (float) of a positive number.
inline double ulp_of(double value)
{
    const auto rounded = static_cast<float>(value);
    return double{std::nextafter(rounded, std::numeric_limits<float>::infinity()) - rounded};
}

/// A unit vector perpendicular to the unit vector `axis`, uniform in the angle round it.
inline glm::dvec3 perpendicular_to(const glm::dvec3& axis, Random& random)
{
    for (;;) {
        const glm::dvec3 side = cross(axis, glm::dvec3(random.unit_vector()));
        if (length(side) > 0.1) return normalize(side);
    }
}

/// The ray of unit direction that arrives at `target` from `distance` along the unit vector `from`, but for the
/// rounding of its origin and direction.
inline Ray aimed_at(const glm::dvec3& target, const glm::dvec3& from, double distance)
{
    const glm::vec3 origin(target + distance * from);
    return Ray{origin, glm::vec3(normalize(target - glm::dvec3(origin)))};
}

/// Adds a question that must hit and one that must miss, in random order.
template <class Shot>
void add_pair(std::vector<Shot>& shots, const Shot& hit, const Shot& miss, Random& random)
{
    const bool swapped = random.below(2) == 1;
    shots.push_back(swapped ? miss : hit);
    shots.push_back(swapped ? hit : miss);
}

/// The ray of unit direction from `eye` through the centre of pixel (x, y) of a square picture `size` pixels wide that
/// shows 2 * `half_width` at distance 1 along -z.
inline Ray pixel_ray(const glm::vec3& eye, float half_width, int size, int x, int y)
{
    const auto centred = [&](int pixel) {
        return half_width * (2 * (static_cast<float>(pixel) + 0.5F) / static_cast<float>(size) - 1);
    };
    return Ray{eye, normalize(glm::vec3(centred(x), -centred(y), -1))};
}

}
