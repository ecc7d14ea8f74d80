#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "shots.hpp"

/// Rays of few binary digits: whatever decides about them is exact.
namespace umbral::raytracing {

/// Answers that a student can check by hand, the course's among them; behind each hit comes a miss.
inline std::vector<Ray> cylinder_by_hand()
{
    return {
        Ray{{0, 2.1F, 3}, {0, -0.8F, -2}},
        Ray{{0, 2.9F, 3}, {0, -0.8F, -2}},
        Ray{{0, 0.5F, 3}, {0, 0, -1}},
        Ray{{0, 1.5F, 3}, {0, 0, -1}},
        Ray{{4, 0.25F, 0}, {-2, 0, 0}},
        Ray{{4, -0.25F, 0}, {-2, 0, 0}},
        Ray{{0, 0.5F, 0}, {1, 0, 0}},
        Ray{{0, 0.5F, 2}, {1, 0, 0}},
        Ray{{0.5F, 3, 0}, {0.125F, -0.625F, 0}},
        Ray{{0.5F, 3, 0}, {-0.125F, -1, 0}},
        Ray{{-3, 0.5F, 0}, {0.5F, 0, 0}},
        Ray{{-3, 0.5F, 0}, {-0.5F, 0, 0}},
        Ray{{0, -1, -3}, {0, 0.75F, 1}},
        Ray{{0, -1, -3}, {0, 0.125F, 1}},
        Ray{{1.5F, 0.75F, -2}, {-0.5F, 0, 1}},
        Ray{{1.5F, 0.75F, -2}, {0.5F, 0, 1}},
    };
}

inline std::vector<Ray> cone_by_hand()
{
    return {
        Ray{{0, 0.5F, 3}, {0, 0, -1}},      Ray{{0, 1.5F, 3}, {0, 0, -1}},      Ray{{0.5F, 3, 0}, {0, -1, 0}},
        Ray{{0.5F, 3, 0}, {0, 1, 0}},       Ray{{0, 1.5F, 2}, {0, -1, -1}},     Ray{{0, 3.5F, 2}, {0, -1, -1}},
        Ray{{3, 0.25F, 0}, {-2, 0, 0}},     Ray{{3, -0.25F, 0}, {-2, 0, 0}},    Ray{{0, 0.5F, 0}, {0, 0, 1}},
        Ray{{0, 1.75F, 0}, {0, 0, 1}},      Ray{{-0.25F, -1, 0}, {0, 0.5F, 0}}, Ray{{-1.25F, -1, 0}, {0, 0.5F, 0}},
        Ray{{0, 0.75F, -2}, {0, 0, 0.25F}}, Ray{{1, 0.75F, -2}, {0, 0, 0.25F}}, Ray{{2, 2, 0}, {-1, -0.875F, 0}},
        Ray{{2, 4, 0}, {-1, -0.875F, 0}},
    };
}

/// A quarter turn about the y axis, this many times.
inline glm::vec3 turned(glm::vec3 v, std::uint32_t quarters)
{
    for (; quarters > 0; --quarters) v = {v.z, v.y, -v.x};
    return v;
}

inline Ray turned(Ray ray, std::uint32_t quarters)
{
    ray.origin = turned(ray.origin, quarters);
    ray.direction = turned(ray.direction, quarters);
    return ray;
}

/// Rays parallel to the axis within, without and in the surface of the cylinder; of the cone, rays parallel to one of
/// its lines, which meet it once, or only its other half, or outside of (t_min, t_max), and rays that lie in it.
inline std::vector<Ray> parallel(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 60; ++i) {
        const std::uint32_t quarters = random.below(4);
        const float speed = std::ldexp(1.0F, static_cast<int>(random.below(5)) - 2);
        const float height = 0.0625F * static_cast<float>(1 + random.below(15));
        Ray hit;
        Ray miss;
        if (quadric == Quadric::cylinder) {
            const float radii[] = {0.5F, 1, 1.5F, 0};
            const float from = i % 8 < 4 ? 3.0F : -2.0F;
            hit = {{3, height, 0}, {-speed, 0, 0}};
            miss = {{radii[i % 4], from, 0}, {0, from > 0 ? -speed : speed, 0}};
            if (i % 3 == 0) miss.t_min = -endless;
        } else {
            // Down the line from the apex to (-1, 0, 0) or (1, 0, 0), moved up or down by `above`.
            const float above = 2 * height;
            hit = {{2, 3 - above, 0}, {-speed, -speed, 0}};
            hit.origin += glm::vec3(0.25F, 0.25F, 0);
            const float met = (2.25F - height) / speed;
            miss = hit;
            switch (i % 6) {
                case 0: miss.origin += glm::vec3(0, above + 0.125F, 0); break;   // meets the other half
                case 1: miss.origin = {height - 0.5F, 0.5F - height, 0}; break;  // has it behind
                case 2: miss.origin = {2, 3, 0}; break;                          // runs in the surface
                case 3: miss.t_max = 0.5F * (hit.t_max = 2 * met); break;        // meets it where the interval ends
                case 4: miss.t_min = 2 * (hit.t_min = 0.5F * met); break;        // ... or begins
                default:                                                         // it lies behind both
                    hit.origin += 2 * met * hit.direction;
                    miss.origin = hit.origin;
                    hit.t_min = -endless;
            }
        }
        add_pair(rays, turned(hit, quarters), turned(miss, quarters), random);
    }
    return rays;
}

/// A hit and a miss in a plane that holds the axis, slanted, which pass a rim by 1e-8 to 1e-5: in `double` their
/// heights there are right, in `float` they are not. Down to the lower rim; of the cylinder also up to the upper one,
/// and from within.
inline std::array<Ray, 2> slanted_to_a_rim(Quadric quadric, Random& random)
{
    const bool is_upper = quadric == Quadric::cylinder && random.below(2) == 0;
    const bool is_within = quadric == Quadric::cylinder && random.below(2) == 0;
    const float speed = std::exp2(random.uniform(-2, 2));
    const float x = is_within ? 0.125F * static_cast<float>(random.below(8)) : 2 + random.uniform(0, 3);
    const double upwards = (is_upper ? 1 : -1) * std::exp2(-random.uniform(0, 4));
    const glm::vec3 direction(-speed, speed * static_cast<float>(upwards), 0);
    // Where the ray would have to begin to meet the rim; half of `aside` or more is left on the cone.
    const double way = double{x} + (is_within ? 1 : -1);
    const double exact = (is_upper ? 1 : 0) - way * double{direction.y} / double{speed};
    const double aside = std::pow(10.0, -7.8 + 2.8 * std::pow(random.uniform_double(), 4));
    const auto rounded = [](double number, float towards) {
        const auto near = static_cast<float>(number);
        const bool is_there = towards < 0 ? double{near} <= number : double{near} >= number;
        return is_there ? near : std::nextafter(near, towards);
    };
    const float below = rounded(exact - aside, -endless);
    const float above = rounded(exact + aside, endless);
    const Ray hit{{x, is_upper ? below : above, 0}, direction};
    const Ray miss{{x, is_upper ? above : below, 0}, direction};
    return {hit, miss};
}

/// Level rays that meet a rim or the apex, or pass just within them, or touch the surface; rays down the axis through
/// the apex; and slanted rays close to a rim. Those that miss pass by a sixteenth or less, down to what `float` tells
/// from 1 and to 1e-8 below 0, or have an interval that ends there.
inline std::vector<Ray> at_the_rims(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 120; ++i) {
        const std::uint32_t quarters = random.below(4);
        const float speed = std::ldexp(1.0F, static_cast<int>(random.below(5)) - 2);
        const float away = 2 + 0.5F * static_cast<float>(random.below(5));
        const int upper_bits = 16 + static_cast<int>(random.below(8));
        const int lower_bits = 16 + static_cast<int>(random.below(11));
        const float beyond_upper = i % 12 < 6 ? 0.0625F : std::ldexp(1.0F, -upper_bits);
        const float beyond_lower = i % 12 < 6 ? 0.0625F : std::ldexp(1.0F, -lower_bits);
        const bool is_within = random.below(2) == 0;
        Ray hit{{away, is_within ? beyond_lower : 0, 0}, {-speed, 0, 0}};
        Ray miss = hit;
        miss.origin.y = -beyond_lower;
        switch (i % 6) {
            case 0: break;
            case 1:
                hit.origin.y = is_within ? 1 - beyond_upper : 1;
                miss.origin.y = 1 + beyond_upper;
                break;
            case 2: {
                hit.origin.y = miss.origin.y = 0.25F * static_cast<float>(random.below(4));
                const float radius = quadric == Quadric::cylinder ? 1 : 1 - hit.origin.y;
                hit.origin.z = random.below(2) == 0 ? radius : -radius;
                miss.origin.z = 1.0625F * hit.origin.z;
                break;
            }
            case 3:
            case 4: {
                const std::array<Ray, 2> pair = slanted_to_a_rim(quadric, random);
                hit = pair[0];
                miss = pair[1];
                break;
            }
            default:
                if (quadric == Quadric::cone) {
                    hit = {{0, 1 + away, 0}, {0, -speed, 0}};
                    if (random.below(2) == 0) hit = {{0, -away, 0}, {0, speed, 0}};
                    miss = hit;
                    const float t = std::abs(hit.origin.y - 1) / speed;
                    miss.t_max = 0.9375F * t;
                } else {
                    hit.origin.y = 1;
                    hit.t_min = miss.t_min = away / speed;
                    miss.origin.y = 1 + beyond_upper;
                }
        }
        add_pair(rays, turned(hit, quarters), turned(miss, quarters), random);
    }
    return rays;
}

/// Points at an end of the interval, which do not count; and rays that begin on the surface. At half its height the
/// level rays have two points, at exactly known t. Half of the directions are of any length.
inline std::vector<Ray> at_the_ends(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    const float radius = quadric == Quadric::cylinder ? 1 : 0.5F;
    for (int i = 0; i < 100; ++i) {
        const std::uint32_t quarters = random.below(4);
        const int most = i / 6 % 2 == 0 ? 2 : 20;
        const float speed = std::ldexp(1.0F, static_cast<int>(random.below(2 * most + 1)) - most);
        const float away = 2 + 0.5F * static_cast<float>(random.below(5));
        const float entry = (away - radius) / speed;
        const float exit = (away + radius) / speed;
        const auto level = [&](float x, float towards, float t_min, float t_max) {
            return turned(Ray{{x, 0.5F, 0}, {towards * speed, 0, 0}, t_min, t_max}, quarters);
        };
        switch (i % 6) {
            case 0: add_pair(rays, level(away, -1, entry, endless), level(away, -1, entry, exit), random); break;
            case 1: add_pair(rays, level(away, -1, 0, barely_more * entry), level(away, -1, 0, entry), random); break;
            case 2:
                add_pair(rays, level(away, -1, entry, barely_more * exit), level(away, -1, exit, endless), random);
                break;
            case 3: add_pair(rays, level(away, 1, -2 * exit, 0), level(away, 1, -entry, endless), random); break;
            case 4: add_pair(rays, level(radius, -1, 0, endless), level(radius, 1, 0, endless), random); break;
            default: add_pair(rays, level(radius, 1, -1, 1), level(radius, 1, -2 * radius / speed, 0), random);
        }
    }
    return rays;
}

}
