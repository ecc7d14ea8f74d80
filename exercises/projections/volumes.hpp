#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <kit/refusal.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/projections/view_volume.hpp>
#include <umbral/record/variation.hpp>
#include <utility>

/// What the drivers of units about view volumes share.
namespace umbral::projections {

/// A box with sides of 0.2 to 20, its middle within 10 of the origin in each axis; near_plane < far_plane.
inline ViewVolume random_box(Random& random)
{
    glm::vec3 low(0);
    glm::vec3 high(0);
    for (int axis = 0; axis < 3; ++axis) {
        const float middle = random.uniform(-10, 10);
        const float half = random.uniform(0.1F, 10);
        low[axis] = middle - half;
        high[axis] = middle + half;
    }
    return {low.x, high.x, low.y, high.y, low.z, high.z};
}

/// A frustum whose near window has sides of 0.2 to 4 times its distance, its middle up to that far off the axis; the
/// near plane at 0.1 to 5, the far one 1.5 to 1000 times as far.
inline ViewVolume random_frustum(Random& random)
{
    const float near_plane = random.uniform(0.1F, 5);
    const glm::vec2 half(random.uniform(0.1F, 2), random.uniform(0.1F, 2));
    const glm::vec2 middle(random.uniform(-1, 1), random.uniform(-1, 1));
    const glm::vec2 low = near_plane * (middle - half);
    const glm::vec2 high = near_plane * (middle + half);
    const float far_plane = near_plane * 1.5F * std::pow(667.0F, random.uniform());
    return {low.x, high.x, low.y, high.y, near_plane, far_plane};
}

/// The same volume with pairs of opposite sides exchanged: bit 0 of `which` for left and right, bit 1 for bottom and
/// top, bit 2 for near and far.
inline ViewVolume with_sides_exchanged(ViewVolume volume, unsigned which)
{
    if ((which & 1U) != 0) std::swap(volume.left, volume.right);
    if ((which & 2U) != 0) std::swap(volume.bottom, volume.top);
    if ((which & 4U) != 0) std::swap(volume.near_plane, volume.far_plane);
    return volume;
}

/// Another volume, if inputs are to vary: in each axis larger or smaller, the window moved aside. Sides that are zero
/// remain so, and planes stay on their side of the eye, in their order.
inline ViewVolume varied(Variation& vary, ViewVolume volume)
{
    const auto resize = [&](float& low, float& high) {
        const float size = vary.scaled(1.0F, 1.3F);
        const float aside = vary.near(0.0F, 0.2F) * (high - low);
        low = size * low + aside;
        high = size * high + aside;
    };
    resize(volume.left, volume.right);
    resize(volume.bottom, volume.top);
    const float size = vary.scaled(1.0F, 1.3F);
    volume.near_plane *= size;
    volume.far_plane *= size * vary.scaled(1.0F, 1.2F);
    return volume;
}

/// The next float beyond: what is nearest to an equal one.
inline float next_above(float value) { return std::nextafter(value, std::numeric_limits<float>::infinity()); }

}
