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
    if (!std::isfinite(student)) return {false, false, true, infinity};
    const double distance = std::abs(student - expected);
    if (distance == 0) return {true, true, false, 0};

    const double in_ulps = scale.ulp > 0 ? distance / scale.ulp : infinity;
    const double in_sizes = scale.size > 0 ? distance / scale.size : infinity;
    const auto holds = [](const std::optional<double>& bound, double found, double ratio) {
        return bound && found <= *bound * ratio;
    };
    const bool ulps = holds(tolerance.ulps, in_ulps, 1);
    const bool relative = holds(tolerance.relative, in_sizes, 1);
    const bool absolute = holds(tolerance.absolute, distance, 1);
    const bool right = ulps || relative || absolute;
    const bool clear = !holds(tolerance.ulps, in_ulps, thresholds::clear_ratio) &&
                       !holds(tolerance.relative, in_sizes, thresholds::clear_ratio) &&
                       !holds(tolerance.absolute, distance, thresholds::clear_ratio);
    switch (unit_of(tolerance)) {
        case Unit::ulps: return {right, ulps, clear, in_ulps};
        case Unit::relative: return {right, relative, clear, in_sizes};
        case Unit::absolute: break;
    }
    return {right, absolute, clear, distance};
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
