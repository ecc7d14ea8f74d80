#pragma once

#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>
#include <vector>

#include "../rays.hpp"

/// Rays that cross the endless cylinder, or the endless cone with both its halves, in two places that are known.
namespace umbral::raytracing {

enum class Quadric { cylinder, cone };

/// A place of an endless surface: `angle` about the y axis from +x, `height` its y.
struct SurfacePlace {
    double angle;
    double height;
};

inline glm::dvec3 position(Quadric quadric, const SurfacePlace& place)
{
    const double radius = quadric == Quadric::cylinder ? 1 : std::abs(1 - place.height);
    return {radius * std::cos(place.angle), place.height, radius * std::sin(place.angle)};
}

/// A height where there is a surface, 2 % from the rims and a tenth from the apex.
inline double height_on(Quadric quadric, Random& random)
{
    return quadric == Quadric::cylinder ? 0.02 + 0.96 * random.uniform_double() : 0.02 + 0.88 * random.uniform_double();
}

/// A height where there is none: above, where the cone has its other half, or below.
inline double height_off(Quadric quadric, Random& random)
{
    const double beyond = (quadric == Quadric::cylinder ? 0.02 : 0.1) + 2 * random.uniform_double();
    return random.below(2) == 0 ? 1 + beyond : -beyond;
}

/// Two places of an endless surface, not nearly on one of its lines: between them a straight line runs through the air.
struct Chord {
    glm::dvec3 entry;
    glm::dvec3 exit;
};

inline Chord chord(Quadric quadric, double entry_height, double exit_height, Random& random)
{
    constexpr double pi = 3.14159265358979323846;
    const bool halves_differ = quadric == Quadric::cone && (entry_height > 1) != (exit_height > 1);
    // A line of the cone goes on in the other half on the opposite side.
    const double opposite = halves_differ ? 0 : pi;
    const double turn = opposite + (pi - 0.6) * (2 * random.uniform_double() - 1);
    const double angle = 2 * pi * random.uniform_double();
    return {position(quadric, {angle, entry_height}), position(quadric, {angle + turn, exit_height})};
}

/// The ray of unit direction along a chord that begins at entry + `share` (exit - entry), but for rounding.
inline Ray along(const Chord& chord, double share)
{
    const glm::dvec3 way = chord.exit - chord.entry;
    return Ray{glm::vec3(chord.entry + share * way), glm::vec3(normalize(way))};
}

/// A ray that crosses the surface outside: it passes the apex or the axis at a side, and is nearly horizontal.
inline Ray beside(Quadric quadric, Random& random)
{
    const double height = -0.5 + 2 * random.uniform_double();
    const double room = quadric == Quadric::cylinder ? 1 : 1.05 * std::abs(1 - height);
    const double away = room + 0.05 + 0.5 * random.uniform_double();
    const double angle = 6.283185307179586 * random.uniform_double();
    const glm::dvec3 outwards(std::cos(angle), 0, std::sin(angle));
    const double slope = 0.2 * (2 * random.uniform_double() - 1);
    const glm::dvec3 way = normalize(glm::dvec3(-outwards.z, slope, outwards.x));
    const glm::dvec3 nearest = away * outwards + glm::dvec3(0, height, 0);
    return Ray{glm::vec3(nearest - (1 + 5 * random.uniform_double()) * way), glm::vec3(way)};
}

/// `count` pairs of all kinds: onto the outside, through an open end onto the inside, from within; and past both ends,
/// through both ends, beside the surface, away from it.
inline std::vector<Ray> random_pairs(Quadric quadric, Random& random, int count)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const double on = height_on(quadric, random);
        const double other = random.below(2) == 0 ? height_on(quadric, random) : height_off(quadric, random);
        const Chord first = chord(quadric, on, other, random);
        const Chord second = chord(quadric, height_off(quadric, random), on, random);
        const Chord none = chord(quadric, height_off(quadric, random), height_off(quadric, random), random);
        const double before = -0.3 - 2 * random.uniform_double();
        const double within = 0.2 + 0.6 * random.uniform_double();
        const Ray hits[] = {along(first, before), along(second, before), along(second, within)};
        const Ray misses[] = {along(none, before), along(none, within), beside(quadric, random),
                              along(first, 1.3 + random.uniform_double())};
        add_pair(rays, hits[i % 3], misses[i % 4], random);
    }
    return rays;
}

/// `count` pairs that enter where there is no surface: through an open end, or through the cone's other half. Of each
/// pair one comes out through the surface, and the other where there is none again.
inline std::vector<Ray> open_pairs(Quadric quadric, Random& random, int count)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const double off = height_off(quadric, random);
        const double before = -0.3 - random.uniform_double();
        const Chord hit = chord(quadric, off, height_on(quadric, random), random);
        const Chord miss = chord(quadric, off, height_off(quadric, random), random);
        add_pair(rays, along(hit, before), along(miss, before), random);
    }
    return rays;
}

/// `count` pairs from `distance` away. The hits are aimed at heights from 0.3 to 0.7, upright enough, and the misses
/// past both ends or beside.
inline std::vector<Ray> far_pairs(Quadric quadric, Random& random, double distance, int count)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Chord first = chord(quadric, 0.3 + 0.4 * random.uniform_double(), height_off(quadric, random), random);
        const Chord second = chord(quadric, height_off(quadric, random), 0.3 + 0.4 * random.uniform_double(), random);
        const Chord& hit = i % 2 == 0 ? first : second;
        const Chord none = chord(quadric, 1.2 + random.uniform_double(), 1.5 + random.uniform_double(), random);
        add_pair(rays, aimed_at(i % 2 == 0 ? hit.entry : hit.exit, normalize(hit.entry - hit.exit), distance),
                 aimed_at(none.exit, normalize(none.entry - none.exit), distance), random);
    }
    return rays;
}

/// `count` pairs that hardly dip into the endless surface, from 1 to 1,000 away: as little as rounding the ray leaves
/// certain, a sine of 0.003 to 0.3 of its angle with the surface. The misses do so above or below.
inline std::vector<Ray> glancing_pairs(Quadric quadric, Random& random, int count)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const double distance = std::pow(10.0, 3 * random.uniform_double());
        const double turn = 2e-3 * std::sqrt(10 * distance) * (1 + 2 * random.uniform_double());
        const double angle = 6.283185307179586 * random.uniform_double();
        const double slope = 0.5 * (2 * random.uniform_double() - 1);
        const auto glancing = [&](double height) {
            const glm::dvec3 entry = position(quadric, {angle, height});
            const glm::dvec3 exit = position(quadric, {angle + (i % 2 == 0 ? turn : -turn), height + turn * slope});
            return aimed_at(entry, normalize(entry - exit), distance);
        };
        const double on = 0.1 + 0.4 * random.uniform_double();
        add_pair(rays, glancing(on), glancing(i % 4 < 2 ? 1.5 + on : -0.5 - on), random);
    }
    return rays;
}

/// `count` pairs that run nearly parallel to the axis of the cylinder, or to a line of the cone, so that the
/// coefficient of t² is small beside the direction's square: under 1e-6, or from 2e-3 down to what rounding leaves. A
/// third of the directions have lengths from 1e-6 to 1e6. The misses turn back and leave through the open end, or
/// beside the apex.
inline std::vector<Ray> nearly_parallel_pairs(Quadric quadric, Random& random, int count)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * random.uniform_double();
        const glm::dvec3 side(std::cos(angle), 0, std::sin(angle));
        const double lean = std::pow(10.0, -3 - 3 * random.uniform_double());
        const bool is_cone = quadric == Quadric::cone;
        // Down a line of the cone, or down the axis and a little outwards.
        const glm::dvec3 way = is_cone ? glm::dvec3(side.x, i % 2 == 0 ? lean - 1 : -lean - 1, side.z)
                                       : glm::dvec3(lean * side.x, -1, lean * side.z);
        const glm::dvec3 target =
            position(quadric, {angle + (is_cone ? 1 + random.uniform_double() : 0.0), height_on(quadric, random)});
        const double back = 0.3 + random.uniform_double();
        const float speed = i % 3 == 0 ? std::ldexp(1.0F, static_cast<int>(random.below(41)) - 20) : 1.0F;
        const Ray hit{glm::vec3(target - back * way), speed * glm::vec3(way)};
        Ray miss = hit;
        miss.direction = -miss.direction;
        if (!is_cone) miss.origin *= glm::vec3(0.5F, 1, 0.5F);
        add_pair(rays, hit, miss, random);
    }
    return rays;
}

}
