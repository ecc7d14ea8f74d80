#pragma once

#include <cmath>

/// What oracles compute in: 113 bits of mantissa and 15 of exponent.
namespace umbral {

#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;  // as wide, where there is no __float128 (arm64)
#endif

[[nodiscard]] inline Wide absolute(Wide value) { return value < 0 ? -value : value; }

/// The square root, right but for the last few of 113 bits; 0 of negative numbers, NaN of NaN.
[[nodiscard]] inline Wide square_root(Wide value)
{
    if (value <= 0) return 0;
    // One step of Newton's method doubles the right digits of the estimate, from 64.
    const Wide estimate = std::sqrt(static_cast<long double>(value));
    return (estimate + value / estimate) / 2;
}

}
