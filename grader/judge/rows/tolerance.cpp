#include "judge/rows/tolerance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "judge/explain/thresholds.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {

bool has_bound(const Tolerance& tolerance) { return tolerance.absolute || tolerance.relative || tolerance.ulps; }

Unit unit_of(const Tolerance& tolerance)
{
    return tolerance.ulps ? Unit::ulps : tolerance.relative ? Unit::relative : Unit::absolute;
}

Check with_wide_bounds(Check check)
{
    Tolerance& tolerance = check.tolerance;
    for (std::optional<double>* const bound : {&tolerance.absolute, &tolerance.relative, &tolerance.ulps})
        if (*bound) **bound *= thresholds::clear_ratio;
    return check;
}

double float_ulp(double value)
{
    constexpr float largest = std::numeric_limits<float>::max();
    const auto size = static_cast<float>(std::min(std::abs(value), double{largest}));
    if (size >= largest) return double{largest} - double{std::nextafter(largest, 0.0F)};
    return double{std::nextafter(size, largest)} - double{size};
}

Deviation deviation(const Tolerance& tolerance, double student, double expected, const Scale& scale)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!std::isfinite(student)) return {false, false, infinity};
    const double distance = std::abs(student - expected);
    if (distance == 0) return {true, true, 0};

    const double in_ulps = scale.ulp > 0 ? distance / scale.ulp : infinity;
    const double in_sizes = scale.size > 0 ? distance / scale.size : infinity;
    const bool ulps = tolerance.ulps && in_ulps <= *tolerance.ulps;
    const bool relative = tolerance.relative && in_sizes <= *tolerance.relative;
    const bool absolute = tolerance.absolute && distance <= *tolerance.absolute;
    const bool right = ulps || relative || absolute;
    switch (unit_of(tolerance)) {
        case Unit::ulps: return {right, ulps, in_ulps};
        case Unit::relative: return {right, relative, in_sizes};
        case Unit::absolute: break;
    }
    return {right, absolute, distance};
}

std::string error_text(Unit unit, double error)
{
    if (unit == Unit::ulps && error >= no_rounding) return "far more than rounding";
    // Its size matters, and not its last digit, also where it is a whole number.
    const std::string size = std::isnan(error) ? number_text(error) : fmt::format("{:.{}g}", error, usual_digits);
    switch (unit) {
        case Unit::ulps: return size + " ulp";
        case Unit::relative: return "relative error " + size;
        case Unit::absolute: break;
    }
    return "error " + size;
}

}
