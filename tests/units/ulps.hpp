#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbral::tests {

/// |got - exact| in units in the last place of `exact` (that of the power of two below it); infinity if `got` is not
/// finite.
inline double ulps_between(float got, float exact)
{
    if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
    const double unit = std::ldexp(1.0, std::max(std::ilogb(exact), -126) - 23);
    return std::abs(double{got} - double{exact}) / (exact == 0 ? std::ldexp(1.0, -149) : unit);
}

}
