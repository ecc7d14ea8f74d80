#include "report/curve_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbral::grader {
namespace {

/// How many times a is b, or b is a; two errors of 0 are alike, and one is as far from any other as can be.
double factor_between(double a, double b)
{
    if (a == b) return 1;
    if (a <= 0 || b <= 0) return HUGE_VAL;
    return std::max(a / b, b / a);
}

std::string named(const CurvePoint& point)
{
    const bool of_ours = point.name == "reference" || point.name == "oracle";
    return of_ours ? "the " + point.name : "“" + point.name + "”";
}

/// "0.4 times", "12 times", "3e+05 times".
std::string times_text(double factor)
{
    if (factor >= 1e5 || factor < 1e-3) return fmt::format("{:.0e} times", factor);
    return factor < 9.95 ? fmt::format("{:.2g} times", factor) : fmt::format("{:.0f} times", factor);
}

std::string time_beside(const CurvePoint& yours, const CurvePoint& other)
{
    return times_text(yours.seconds / other.seconds) + " its time";
}

/// What is said of the error beside another's, as the end of a sentence.
std::string error_beside(const CurvePoint& yours, const CurvePoint& other)
{
    if (yours.error == 0) return "without an error where it has one";
    if (other.error == 0) return "with an error where it has none";
    return "with " + times_text(yours.error / other.error) + " its error";
}

}

std::string curve_sentence(const UnitCurve& curve)
{
    const CurvePoint& yours = curve.yours;
    const auto error = [&](const CurvePoint& one) { return factor_between(yours.error, one.error); };
    const auto time = [&](const CurvePoint& one) { return factor_between(yours.seconds, one.seconds); };
    const CurvePoint* as_accurate = nullptr;
    const CurvePoint* as_fast = nullptr;
    for (const CurvePoint& one : curve.others) {
        if (error(one) < same_error && time(one) < same_time)
            return fmt::format("As accurate as {}, in the same time.", named(one));
        if (error(one) < same_error && (as_accurate == nullptr || error(one) < error(*as_accurate))) as_accurate = &one;
        if (time(one) < same_time && (as_fast == nullptr || time(one) < time(*as_fast))) as_fast = &one;
    }
    if (as_accurate != nullptr && as_fast != nullptr)
        return fmt::format("As accurate as {}, in the time of {}.", named(*as_accurate), named(*as_fast));
    if (as_accurate != nullptr)
        return fmt::format("As accurate as {}, in {}.", named(*as_accurate), time_beside(yours, *as_accurate));
    if (as_fast != nullptr)
        return fmt::format("In the time of {}, {}.", named(*as_fast), error_beside(yours, *as_fast));
    const auto reference = std::ranges::find(curve.others, "reference", &CurvePoint::name);
    const CurvePoint& beside = reference == curve.others.end() ? curve.others.front() : *reference;
    return fmt::format("Beside {}: in {}, {}.", named(beside), time_beside(yours, beside), error_beside(yours, beside));
}

std::string curve_error_text(const UnitCurve& curve, double error)
{
    if (error == 0) return "none";
    return fmt::format("{:.3g}{}{}", error, curve.unit.empty() ? "" : " ", curve.unit);
}

std::string curve_time_text(double seconds)
{
    return seconds < 0.9995 ? fmt::format("{:.3g} ms", 1000 * seconds) : fmt::format("{:.3g} s", seconds);
}

}
