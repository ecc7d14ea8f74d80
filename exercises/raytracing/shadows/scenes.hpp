#pragma once

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/shadows.hpp>
#include <vector>

#include "../rays.hpp"

/// Points, lights and casters of which it is known by construction whether the light arrives.
namespace umbral::raytracing {

/// One question put to a visibility.
struct LightQuestion {
    ShadedPoint point;
    glm::vec4 light;
    ShadowCasters casters;
};

/// A point of a surface as it is, and as it is rounded. `size` is that of the surface it lies on.
struct SurfaceSite {
    glm::dvec3 point;
    glm::dvec3 normal;
    ShadedPoint rounded;
    ShadowCasters own;
    double size;
};

inline double half_ulp_of(const glm::dvec3& point)
{
    return 0.5 * ulp_of(std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}));
}

/// The point as rounding to float leaves it, with half an ulp as its error; or as deep below the surface as its error
/// allows: that many half ulps, and no coordinate could be a float lower.
inline ShadedPoint rounded_below(const glm::dvec3& point, const glm::dvec3& normal, double half_ulps)
{
    const double half_ulp = half_ulp_of(point);
    if (half_ulps == 0) return {glm::vec3(point), glm::vec3(normal), static_cast<float>(half_ulp)};
    const glm::dvec3 down = -sign(normal);
    const auto furthest = [&](glm::length_t i, double most) {
        const auto rounded = static_cast<float>(point[i] + most * down[i]);
        return std::abs(double{rounded} - point[i]) <= most ? rounded
                                                            : std::nextafter(rounded, static_cast<float>(point[i]));
    };
    ShadedPoint below{glm::vec3(0), glm::vec3(normal), 0};
    double error = half_ulp;
    for (glm::length_t i = 0; i < 3; ++i)
        error = std::max(error, std::abs(double{furthest(i, half_ulps * half_ulp)} - point[i]));
    for (glm::length_t i = 0; i < 3; ++i) below.position[i] = furthest(i, error);
    below.error = std::nextafter(static_cast<float>(error), endless);
    return below;
}

/// A point on a triangle of this size, one of the four of a flat pyramid, or on a ball, anywhere within `place` +-
/// `size`; as deep below the surface as its error allows if `deep`. The place is of floats: of one rounded here, GCC 12
/// goes on with the digits that it had before.
inline SurfaceSite random_site(Random& random, const glm::vec3& place, double size, bool deep)
{
    const glm::dvec3 middle(place);
    SurfaceSite site;
    site.size = size;
    const double half_ulps = deep ? std::exp2(random.uniform(1, 4)) : 0;
    if (random.below(2) == 0) {
        const glm::dvec3 up(random.unit_vector());
        const glm::dvec3 side = perpendicular_to(normalize(up), random);
        const glm::dvec3 front = cross(up, side);
        glm::vec3 base[4];
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 along = i % 2 == 0 ? side : front;
            base[i] = glm::vec3(middle + (i < 2 ? size : -size) * along);
        }
        const glm::vec3 top(middle + 0.3 * size * up);
        for (int i = 0; i < 4; ++i) site.own.triangles.push_back({base[i], base[(i + 1) % 4], top});
        const ShadowTriangle& triangle = site.own.triangles[random.below(4)];
        const double u = 0.05 + 0.45 * random.uniform_double();
        const double v = 0.05 + 0.45 * random.uniform_double();
        const glm::dvec3 a(triangle.a);
        const glm::dvec3 ab = glm::dvec3(triangle.b) - a;
        const glm::dvec3 ac = glm::dvec3(triangle.c) - a;
        site.point = a + u * ab + v * ac;
        site.normal = normalize(cross(ab, ac));
    } else {
        const ShadowBall ball{place, static_cast<float>(size)};
        site.normal = normalize(glm::dvec3(random.unit_vector()));
        site.point = glm::dvec3(ball.centre) + double{ball.radius} * site.normal;
        site.own.balls.push_back(ball);
    }
    site.rounded = rounded_below(site.point, site.normal, half_ulps);
    return site;
}

/// The same, as deep or as rounding leaves it.
inline SurfaceSite random_site(Random& random, const glm::vec3& place, double size)
{
    const bool deep = random.below(2) == 0;
    return random_site(random, place, size, deep);
}

/// A unit direction whose angle with the surface has this sine; below it if that is negative.
inline glm::dvec3 direction_above(const SurfaceSite& site, double sine, Random& random)
{
    return sine * site.normal + std::sqrt(1 - sine * sine) * perpendicular_to(site.normal, random);
}

/// A light in this direction: a lamp up to 6 sizes away, or a sun whose direction has any length; one sun in eight
/// has one whose square is no float. `reach` becomes the lamp's distance, or a length for what is put in the sun's way.
inline glm::vec4 random_light(const SurfaceSite& site, const glm::dvec3& towards, bool is_sun, double& reach,
                              Random& random)
{
    reach = site.size * (2 + 4 * random.uniform_double());
    if (is_sun) {
        const float beyond_squares = (random.below(2) == 0 ? 1.0F : -1.0F) * random.uniform(75, 80);
        return {std::exp2(random.below(8) == 0 ? beyond_squares : random.uniform(-24, 8)) * glm::vec3(towards), 0};
    }
    // Half of the lamps are nearer than the body is large, where that is far beside the point's error.
    const double nearest = std::max(0.125, 1e4 * double{site.rounded.error} / site.size);
    if (nearest < 1) reach = site.size * nearest * std::pow(6 / nearest, random.uniform_double());
    return {glm::vec3(site.point + reach * towards), 1};
}

/// A ball with its centre this far along a direction from the site, and as far aside of the line as `aside` radii.
inline ShadowBall ball_beside(const SurfaceSite& site, const glm::dvec3& towards, double distance, double radius,
                              double aside, Random& random)
{
    const glm::dvec3 centre = site.point + distance * towards + aside * radius * perpendicular_to(towards, random);
    return {glm::vec3(centre), static_cast<float>(radius)};
}

/// A triangle that a direction from the site crosses this far away, in its middle.
inline ShadowTriangle triangle_across(const SurfaceSite& site, const glm::dvec3& towards, double distance,
                                      double radius, Random& random)
{
    const glm::dvec3 middle = site.point + distance * towards;
    const glm::dvec3 side = perpendicular_to(towards, random);
    const glm::dvec3 other = cross(towards, side);
    const glm::dvec3 tilt = 0.2 * towards;
    return {glm::vec3(middle + radius * (side + tilt)), glm::vec3(middle + radius * (-0.5 * side + 0.8 * other)),
            glm::vec3(middle - radius * (0.5 * side + 0.9 * other + tilt))};
}

/// A large ball whose surface a direction from the site crosses once on the way, this far away: the point lies within
/// it, or what lies `beyond` does, that far behind the surface.
inline ShadowBall ball_round_one_end(const SurfaceSite& site, const glm::dvec3& towards, double distance, double beyond,
                                     bool round_the_point, Random& random)
{
    const double radius = (round_the_point ? distance : beyond) * (1.2 + random.uniform_double());
    const double cosine = 0.85 + 0.15 * random.uniform_double();
    const glm::dvec3 inward = (round_the_point ? -cosine : cosine) * towards +
                              std::sqrt(1 - cosine * cosine) * perpendicular_to(towards, random);
    return {glm::vec3(site.point + distance * towards + radius * inward), static_cast<float>(radius)};
}

/// What part of the way to the light lies before a triangle on it. Before lamps every second one is near to the end.
inline double way_to_triangle(bool is_sun, Random& random)
{
    const double anywhere = 0.3 + 0.5 * random.uniform_double();
    const double near_the_end = 1 - 0.1 * std::pow(10.0, -0.7 * random.uniform_double());
    return is_sun || random.below(2) == 0 ? anywhere : near_the_end;
}

/// A pair: a point with an open way to the light, past two balls, and the same with a caster on it: a small ball, a
/// triangle, or a large ball round the point or round the light. What stood in the way stands beside it, beyond the
/// lamp or below the point where there is light, or is a ball round all of it. In the way of a sun it may be a mountain
/// far away.
inline void add_light_pair(std::vector<LightQuestion>& questions, const SurfaceSite& site, double sine, int kind,
                           Random& random)
{
    const bool is_sun = kind % 3 == 0;
    const glm::dvec3 towards = direction_above(site, sine, random);
    double reach = 0;
    LightQuestion lit{site.rounded, random_light(site, towards, is_sun, reach, random), site.own};
    const double larger = is_sun && site.size < 1e3 ? std::exp2(random.uniform(0, 14)) : 1;
    const double nearer = is_sun ? 1 : std::min(1.0, 0.5 * reach / site.size);  // small things before a near lamp
    reach *= larger;
    for (int i = 0; i < 2; ++i)
        lit.casters.balls.push_back(ball_beside(site, towards, reach * (0.3 + 0.4 * random.uniform_double()),
                                                larger * nearer * site.size * 0.3, 1.2 + random.uniform_double(),
                                                random));
    LightQuestion dark = lit;
    const double radius = larger * nearer * site.size * (0.05 + 0.1 * random.uniform_double());
    const double distance = reach * (0.3 + 0.5 * random.uniform_double());
    const int form = kind % 5;
    if (form == 0)
        dark.casters.balls.push_back(
            ball_beside(site, towards, distance, radius, 0.8 * random.uniform_double(), random));
    else if (form % 2 == 0)
        dark.casters.balls.push_back(ball_round_one_end(site, towards, distance, reach - distance, form == 2, random));
    else
        dark.casters.triangles.push_back(
            triangle_across(site, towards, reach * way_to_triangle(is_sun, random), radius, random));
    if (!is_sun && form == 4)
        lit.casters.balls.push_back({glm::vec3(site.point + 0.5 * reach * towards), static_cast<float>(reach)});
    if (!is_sun && kind % 4 < 2)
        lit.casters.balls.push_back(ball_beside(site, towards, 1.05 * reach + radius, radius, 0, random));
    else
        lit.casters.triangles.push_back(triangle_across(site, towards, -distance - site.size, radius, random));
    add_pair(questions, lit, dark, random);
}

/// `count` pairs of points on surfaces of this size, that far from the world's origin.
inline std::vector<LightQuestion> light_pairs(Random& random, double size, double away, int count)
{
    std::vector<LightQuestion> questions;
    for (int i = 0; i < count; ++i) {
        const SurfaceSite site = random_site(random, static_cast<float>(away) * random.unit_vector(), size);
        add_light_pair(questions, site, 0.15 + 0.8 * random.uniform_double(), i, random);
    }
    return questions;
}

/// `count` pairs of a point with nothing in the way, and one with a ball close above it, or a triangle that is parallel
/// to its surface: 16 to 60 errors away, and half of them as near as their rounding allows. Light is steep.
inline std::vector<LightQuestion> contact_pairs(Random& random, double size, double away, int count)
{
    std::vector<LightQuestion> questions;
    for (int i = 0; i < count; ++i) {
        const SurfaceSite site = random_site(random, static_cast<float>(away) * random.unit_vector(), size, true);
        const double sine = 0.9 + 0.09 * random.uniform_double();
        const glm::dvec3 towards = direction_above(site, sine, random);
        double reach = 0;
        const LightQuestion lit{site.rounded, random_light(site, towards, i % 2 == 0, reach, random), site.own};
        LightQuestion dark = lit;
        const double error = site.rounded.error;
        const double nearest = 16 + 4 * half_ulp_of(site.point) / error;
        const double errors = random.below(2) == 0 ? nearest : nearest + 40 * random.uniform_double();
        if (random.below(2) == 0) {
            const double radius = size * (0.05 + 0.25 * random.uniform_double());
            dark.casters.balls.push_back(ball_beside(site, towards, radius + error * errors, radius, 0, random));
            add_pair(questions, lit, dark, random);
            continue;
        }
        const glm::dvec3 middle = site.point + error * errors / sine * towards;
        const glm::dvec3 side = 0.1 * size * perpendicular_to(site.normal, random);
        const glm::dvec3 other = cross(site.normal, side);
        dark.casters.triangles.push_back({glm::vec3(middle + side), glm::vec3(middle - 0.5 * side + 0.8 * other),
                                          glm::vec3(middle - 0.5 * side - 0.9 * other)});
        add_pair(questions, lit, dark, random);
    }
    return questions;
}

}
