#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

/// Eight numbers at once, by the compiler's vectors: one register of AVX, two of SSE2 or NEON.
namespace umbral::raytrace {

inline constexpr int lane_count = 8;

using FloatLanes = float __attribute__((vector_size(32)));
using IntLanes = std::int32_t __attribute__((vector_size(32)));  ///< as a mask: -1 is yes, 0 is no

/// All eight the same. (Lanes go by reference: without AVX they have no registers to be passed in.)
inline void fill(FloatLanes& lanes, float value)
{
    lanes = FloatLanes{value, value, value, value, value, value, value, value};
}

/// One bit for each lane that is yes, the first one in the lowest bit.
inline unsigned bits_of(const IntLanes& mask)
{
#ifdef __AVX__
    using Floats = float __attribute__((vector_size(32)));
    Floats signs;
    std::memcpy(&signs, &mask, sizeof signs);
    return static_cast<unsigned>(__builtin_ia32_movmskps256(signs));
#else
    unsigned bits = 0;
    for (int i = 0; i < lane_count; ++i) bits |= (static_cast<unsigned>(mask[i]) & 1U) << static_cast<unsigned>(i);
    return bits;
#endif
}

}
