#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <kit/varied.hpp>
#include <numeric>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/rotation.hpp>
#include <utility>
#include <vector>

/// What the drivers of transforms share: turns about axes.
namespace umbral::transforms {

/// A number up to three quarters larger or smaller, in quarters, if inputs are to vary: whole numbers and halves are as
/// exact as before.
inline float by_quarters(Variation& vary, float value) { return value + 0.25F * static_cast<float>(vary.near(0, 3)); }

inline glm::vec3 by_quarters(Variation& vary, glm::vec3 vector)
{
    for (int i = 0; i < 3; ++i) vector[i] = by_quarters(vary, vector[i]);
    return vector;
}

/// The numbers from 0 on, in another order if inputs are to vary: what is asked must not follow from its place.
inline std::vector<int> numbers(Variation& vary, int count)
{
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    return in_random_order(vary, std::move(order));
}

/// A turn about a uniform axis of length 0.5 to 2, by less than half a turn to either side.
inline AxisAngle random_turn(Random& random)
{
    const glm::vec3 axis = random.uniform(0.5F, 2) * random.unit_vector();
    return {axis, random.uniform(-3.1F, 3.1F)};
}

inline std::vector<AxisAngle> random_turns(Random& random, std::size_t count)
{
    std::vector<AxisAngle> turns;
    for (std::size_t i = 0; i < count; ++i) turns.push_back(random_turn(random));
    return turns;
}

/// An axis without a component under 0.2, or, if `flat`, one that lies in a plane of coordinates: then an entry of the
/// matrix consists of (1 - cosθ) e_i e_j alone.
inline glm::vec3 clear_axis(bool flat, Random& random)
{
    glm::vec3 axis;
    for (int i = 0; i < 3; ++i) axis[i] = random.uniform(0.2F, 1) * (random.below(2) == 0 ? 1.0F : -1.0F);
    if (flat) axis[static_cast<int>(random.below(3))] = 0;
    return axis;
}

/// `count` turns about axes that are near `axis` and wander round it, each by 0 to `angle` radians.
inline std::vector<AxisAngle> wandering_turns(const glm::vec3& axis, float angle, std::size_t count, Random& random)
{
    std::vector<AxisAngle> turns;
    turns.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 aside = 0.5F * random.in_cube();
        turns.push_back({axis + aside, random.uniform(0, angle)});
    }
    return turns;
}

}
