#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

/// Profiles to turn about the y axis: points (x, y), x the distance from the axis, going up with the outside on the
/// right. A point that stands twice is a crease.
namespace umbral::profiles {

using Profile = std::vector<glm::vec2>;

/// Goes on from its last point to `c` along a parabola that `b` pulls at.
inline void curve_to(Profile& profile, glm::vec2 b, glm::vec2 c, int steps)
{
    const glm::vec2 a = profile.back();
    for (int k = 1; k <= steps; ++k) {
        const float u = static_cast<float>(k) / static_cast<float>(steps);
        profile.push_back((1 - u) * (1 - u) * a + 2 * u * (1 - u) * b + u * u * c);
    }
}

/// A pawn, 1.9 high, from its foot up.
inline Profile pawn()
{
    Profile profile{{0, 0}, {0.62F, 0}, {0.62F, 0}, {0.62F, 0.12F}, {0.62F, 0.12F}};
    curve_to(profile, {0.60F, 0.34F}, {0.36F, 0.38F}, 8);
    profile.push_back(profile.back());
    curve_to(profile, {0.16F, 0.70F}, {0.17F, 1.12F}, 12);
    profile.push_back(profile.back());
    curve_to(profile, {0.36F, 1.14F}, {0.36F, 1.20F}, 5);
    curve_to(profile, {0.36F, 1.26F}, {0.15F, 1.27F}, 5);
    profile.push_back(profile.back());
    for (int k = 1; k <= 16; ++k) {
        const double angle = -1.09 + (1.5707963267948966 + 1.09) * k / 16;
        profile.emplace_back(k == 16 ? 0.0 : 0.34 * std::cos(angle), 1.56 + 0.34 * std::sin(angle));
    }
    return profile;
}

/// The side of a can, 1.8 high and 1.24 wide, drawn in at both ends.
inline Profile can_side()
{
    Profile profile{{0.52F, 0.08F}};
    curve_to(profile, {0.62F, 0.12F}, {0.62F, 0.24F}, 6);
    for (int k = 1; k <= 6; ++k) profile.emplace_back(0.62F, 0.24F + 0.2F * static_cast<float>(k));
    curve_to(profile, {0.62F, 1.60F}, {0.54F, 1.72F}, 8);
    profile.emplace_back(0.53F, 1.78F);
    return profile;
}

/// What closes it below: vaulted inwards, with a rim to stand on.
inline Profile can_bottom()
{
    Profile profile{{0, 0.16F}};
    curve_to(profile, {0.32F, 0.15F}, {0.44F, 0.02F}, 10);
    curve_to(profile, {0.46F, -0.005F}, {0.48F, 0.015F}, 4);
    curve_to(profile, {0.50F, 0.04F}, {0.52F, 0.08F}, 4);
    return profile;
}

/// What closes it above: a beaded rim, and a lid let into it with a groove and a ring.
inline Profile can_top()
{
    Profile profile{{0.53F, 1.78F}};
    curve_to(profile, {0.57F, 1.79F}, {0.565F, 1.82F}, 4);
    curve_to(profile, {0.555F, 1.85F}, {0.525F, 1.835F}, 5);
    curve_to(profile, {0.51F, 1.80F}, {0.495F, 1.75F}, 4);
    curve_to(profile, {0.48F, 1.725F}, {0.455F, 1.755F}, 5);
    profile.push_back(profile.back());
    profile.emplace_back(0.33F, 1.765F);
    profile.push_back(profile.back());
    curve_to(profile, {0.315F, 1.79F}, {0.29F, 1.772F}, 5);
    profile.push_back(profile.back());
    profile.emplace_back(0.12F, 1.772F);
    profile.emplace_back(0, 1.772F);
    return profile;
}

}
