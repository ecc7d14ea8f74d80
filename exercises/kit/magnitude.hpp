#pragma once

#include <cmath>
#include <cstdint>
#include <umbral/core/random.hpp>

/// Lengths counted in other units: what is right for a scene must be right for the same scene in millimetres or miles.
namespace umbral {

/// A power of two from 2^low to 2^high, one time in three 1. Numbers multiplied by it, and what comes of them divided
/// by it, are the same to the last bit: tolerances stay as they are. Tolerances in a solution that are lengths are not.
inline float random_unit(Random& random, int low, int high)
{
    if (random.below(3) == 0) return 1;
    return std::exp2(
        static_cast<float>(low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)))));
}

}
