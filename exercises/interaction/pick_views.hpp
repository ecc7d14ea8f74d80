#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/interaction/pick_ray.hpp>
#include <utility>

/// Views and clicks for the units that pick.
namespace umbral::interaction {

inline int random_between(int low, int high, Random& random)
{
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

/// Turned in any way, its eye in a box of side 2 * `reach`.
inline projections::ViewFrame random_pick_frame(Random& random, float reach)
{
    const glm::dvec3 z(random.unit_vector());
    const double angle = 2 * std::numbers::pi * random.uniform_double();
    const glm::vec3 eye = reach * random.in_cube();
    // The coordinate axis most across z makes a frame of any z; a random angle turns it.
    const glm::dvec3 size = abs(z);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = normalize(cross(axis, z));
    const glm::dvec3 turned = std::cos(angle) * x + std::sin(angle) * cross(z, x);
    return {glm::vec3(turned), glm::vec3(cross(z, turned)), glm::vec3(z), eye};
}

/// Off the middle along both axes, neither picture nor pixels square; each eighth mirrored, each eighth endless.
inline PickView random_pick_view(Random& random)
{
    PickView view{random_pick_frame(random, 10), {}, {}};
    const float near_plane = random.uniform(0.1F, 4);
    const float width = near_plane * random.uniform(0.2F, 2);
    const float height = near_plane * random.uniform(0.2F, 2);
    const float left = width * random.uniform(-1.2F, 0.2F);
    const float bottom = height * random.uniform(-1.2F, 0.2F);
    const float depth = random.uniform(1.5F, 200);
    view.frustum = {left, left + width, bottom, bottom + height, near_plane, near_plane * depth};
    if (random.below(8) == 0) std::swap(view.frustum.left, view.frustum.right);
    if (random.below(8) == 0) view.frustum.far_plane = std::numeric_limits<float>::infinity();
    view.picture.x = random_between(40, 900, random);
    view.picture.y = random_between(40, 900, random);
    return view;
}

inline glm::ivec2 random_pixel(const glm::ivec2& picture, Random& random)
{
    const int column = random_between(0, picture.x - 1, random);
    return {column, random_between(0, picture.y - 1, random)};
}

}
