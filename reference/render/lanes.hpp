#pragma once

#include <cstdint>
#include <cstring>

/// Four pixels of a row at once, by the compiler's vectors: SSE2 and NEON have registers of just this size.
namespace umbral::render {

inline constexpr int lane_count = 4;

using IntLanes = std::int32_t __attribute__((vector_size(16)));  ///< as a mask: -1 is yes, 0 is no
using FloatLanes = float __attribute__((vector_size(16)));

inline constexpr IntLanes lane_numbers = {0, 1, 2, 3};

template <class Lanes, class Cell>
inline Lanes load(const Cell* from)
{
    static_assert(sizeof(Cell) * lane_count == sizeof(Lanes));
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// Where the mask is yes; the other cells are read and written back, so four of them must be there.
template <class Lanes, class Cell>
inline void store(Cell* to, const IntLanes mask, const Lanes lanes)
{
    const auto old = load<IntLanes>(to);
    IntLanes bits;
    std::memcpy(&bits, &lanes, sizeof bits);
    const IntLanes mixed = (bits & mask) | (old & ~mask);
    std::memcpy(to, &mixed, sizeof mixed);
}

inline bool any(const IntLanes mask)
{
    std::uint64_t words[2];
    std::memcpy(words, &mask, sizeof mask);
    return (words[0] | words[1]) != 0;
}

/// How far four pixels are from the first one of their row.
struct Distances {
    using Pair = double __attribute__((vector_size(16)));

    Pair low = {0, 1}, high = {2, 3};
    FloatLanes all = {0, 1, 2, 3};

    void next()
    {
        low += 4.0;
        high += 4.0;
        all += 4.0F;
    }
};

/// first + step * distance, in double, each rounded once.
inline FloatLanes affine(double first, double step, const Distances& distances)
{
    using HalfLanes = float __attribute__((vector_size(8)));
    const auto low = __builtin_convertvector(first + step * distances.low, HalfLanes);
    const auto high = __builtin_convertvector(first + step * distances.high, HalfLanes);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}

}
