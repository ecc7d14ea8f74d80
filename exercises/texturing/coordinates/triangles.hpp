#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

/// Triangles on balls: written down, and random ones round the seam and the axis.
namespace umbral::texturing {

using Corners = std::array<glm::vec3, 3>;

inline constexpr float pi = 3.14159265F;

inline glm::vec3 at_angles(float longitude, float latitude)
{
    return {std::cos(latitude) * std::cos(longitude), std::sin(latitude), std::cos(latitude) * std::sin(longitude)};
}

/// Far from the seam, across it, touching it, and with corners on the axis; the same on a ball of a millionth the size,
/// and with a corner close to the axis.
inline std::vector<Corners> triangles_by_hand()
{
    const std::vector<Corners> large = {
        {{{1, 0, 0}, {1, 0, 1}, {0, 2, 2}}},    {{{-1, 0, 1}, {-1, 0, -1}, {-1, 1, -1}}},
        {{{0, 0, -2}, {-3, 0, 3}, {-1, 0, 1}}}, {{{-1, 0, 0}, {-1, 0, -1}, {0, 1, -1}}},
        {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}},    {{{-1, 0, 1}, {0, -2, 0}, {-1, 0, -1}}},
        {{{0, 3, 0}, {0, -1, 0}, {-1, 0, -1}}}, {{{0, 1, 0}, {0, 2, 0}, {0, -1, 0}}},
        {{{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}}},  {{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}}}};
    std::vector<Corners> triangles = large;
    for (const Corners& corners : large) {
        constexpr float size = 1.0F / (1 << 20);
        triangles.push_back({size * corners[0], size * corners[1], size * corners[2]});
    }
    constexpr float close = 1.0F / 8192;
    triangles.push_back({{{close, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
    triangles.push_back({{{-close, 0, -close}, {-1, 0, 1}, {-1, 0, 0}}});
    return triangles;
}

/// The triangles mirrored and, each by a factor of its own, higher or lower: the seam and the axis stay where they are.
/// As they are unless inputs are to vary.
inline std::vector<Corners> mirrored(Variation& vary, std::vector<Corners> triangles)
{
    if (!vary) return triangles;
    for (Corners& corners : triangles) {
        const float height = vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.5F, 2.0F});
        for (glm::vec3& corner : corners) corner = {corner.x, height * corner.y, 0 - corner.z};
    }
    return triangles;
}

using Shares = std::array<float, 3>;

/// Corners at these shares of the way from one longitude to another.
inline Corners corners_between(Random& random, float from, float to, const Shares& along)
{
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float size = random.uniform(0.5F, 2);
        corners[i] = size * at_angles(from + (to - from) * along[i], random.uniform(-1.5F, 1.5F));
    }
    return corners;
}

/// Of a turn: a hundred roundings of a coordinate in float, and more.
inline float hardly_anything(Random& random) { return random.uniform(1e-5F, 4e-5F); }

/// Corners round a longitude, less than 0.45 turns apart, now and then hardly less than 0.5, in random order.
inline Corners triangle_at(Random& random, float longitude)
{
    const float turns = random.below(6) == 0 ? 0.5F - hardly_anything(random) : random.uniform(0.02F, 0.45F);
    Shares along = {0, 1, random.uniform(0.1F, 0.9F)};
    std::swap(along[2], along[random.below(3)]);
    std::swap(along[1], along[random.below(2)]);
    return corners_between(random, longitude - turns * pi, longitude + turns * pi, along);
}

/// Hardly less than half a turn, one end hardly beyond the seam; every second time the other end has two corners.
inline Corners half_turn_at_seam(Random& random)
{
    const float side = random.below(2) == 0 ? pi : -pi;
    const float end = side * (1 + 2 * hardly_anything(random));
    Shares along = {0, 1, random.below(2) == 0 ? 1.0F : random.uniform(0.1F, 0.9F)};
    std::swap(along[2], along[random.below(3)]);
    return corners_between(random, end, end - side * (1 - 2 * hardly_anything(random)), along);
}

/// Within 0.45 turns about the axis, no corner on it: so no rounding decides, nor does an order of operations.
inline bool is_narrow(const Corners& corners)
{
    float least = 0;
    float most = 0;
    for (const glm::vec3& corner : corners) {
        if (length(glm::vec2(corner.x, corner.z)) < 0.05F) return false;
        const float turns = (std::atan2(corner.z, corner.x) - std::atan2(corners[0].z, corners[0].x)) / (2 * pi);
        least = std::min(least, turns - std::round(turns));
        most = std::max(most, turns - std::round(turns));
    }
    return most - least < 0.45F;
}

inline float zero_of_any_sign(Random& random) { return random.below(2) == 0 ? 0.0F : -0.0F; }

/// North, south, or, one of five times, the origin.
inline glm::vec3 pole(Random& random)
{
    constexpr float sides[] = {1, -1, 1, -1, 0};
    const float height = random.uniform(0.5F, 2) * sides[random.below(5)];
    const float x = zero_of_any_sign(random);
    return {x, height, zero_of_any_sign(random)};
}

/// One of three triangles on a much smaller or larger ball: longitudes do not depend on its size.
inline void change_balls(Random& random, std::vector<Corners>& triangles)
{
    for (Corners& corners : triangles) {
        const float size = random.below(3) == 0 ? std::pow(10.0F, random.uniform(-12, 6)) : 1.0F;
        for (glm::vec3& corner : corners) corner *= size;
    }
}

}
