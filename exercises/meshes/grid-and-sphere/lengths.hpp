#pragma once

#include <cmath>
#include <umbral/core/random.hpp>

/// Lengths of rows that show what is rounded on the way.
namespace umbral::meshes {

/// Of 64 lengths of a row the one whose reciprocal, as a float, is off the most; all are just below a power of two,
/// where that is most of an ulp. There are others by whose reciprocal one may multiply unpunished.
inline std::uint32_t awkward_length(Random& random)
{
    std::uint32_t best = 1;
    double largest = -1;
    for (int i = 0; i < 64; ++i) {
        const std::uint32_t length = 225'000 + random.below(35'000);
        const double off = std::abs(double{1 / static_cast<float>(length)} * length - 1);
        if (off > largest) largest = off, best = length;
    }
    return best;
}

}
