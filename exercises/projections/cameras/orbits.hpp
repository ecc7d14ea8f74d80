#pragma once

#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>

/// Places of orbital cameras.
namespace umbral::projections {

/// Where an orbital camera stands.
struct Orbit {
    float a_degrees;
    float b_degrees;
    float distance;
};

/// Another place, if inputs are to vary: above and below the target it is turned about the vertical only.
inline Orbit varied(Variation& vary, Orbit orbit)
{
    orbit.a_degrees = vary.near(orbit.a_degrees, 20.0F);
    if (std::abs(orbit.b_degrees) != 90) orbit.b_degrees = vary.near(orbit.b_degrees, 8.0F);
    orbit.distance = vary.scaled(orbit.distance, 1.2F);
    return orbit;
}

/// Any direction; of three distances one is tiny or immense.
inline Orbit random_orbit(Random& random)
{
    const float a = random.uniform(-360, 360);
    const float b = random.uniform(-180, 180);
    const float usual = std::pow(10.0F, random.uniform(-3, 5));
    return {a, b, random.below(3) == 0 ? std::pow(10.0F, random.uniform(-36, 38)) : usual};
}

}
