#include "report/curve_places.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::grader {
namespace {

constexpr double gap_of_zero = 0.2;  ///< below the least error, if one is 0

/// Logarithms of positive values from 0 to 1, round their middle if they span less than `least` decades.
class Logarithms {
public:
    Logarithms(const std::vector<double>& values, double least)
    {
        for (const double value : values) {
            if (!(value > 0)) continue;
            low_ = any_ ? std::min(low_, std::log10(value)) : std::log10(value);
            high_ = any_ ? std::max(high_, std::log10(value)) : std::log10(value);
            any_ = true;
        }
        const double missing = std::max(0.0, least - (high_ - low_)) / 2;
        low_ -= missing;
        high_ += missing;
    }
    [[nodiscard]] double at(double value) const { return (std::log10(value) - low_) / (high_ - low_); }

private:
    bool any_ = false;
    double low_ = 0;
    double high_ = 0;
};

}

std::vector<CurvePlace> curve_places(const UnitCurve& curve)
{
    std::vector<CurvePoint> points = curve.others;
    points.push_back(curve.yours);
    std::vector<double> times;
    std::vector<double> errors;
    for (const CurvePoint& point : points) {
        times.push_back(point.seconds);
        errors.push_back(point.error);
    }
    const Logarithms time(times, std::log10(2.0));
    const Logarithms error(errors, 1);
    const double foot = std::ranges::count(errors, 0.0) > 0 ? gap_of_zero : 0;
    std::vector<CurvePlace> places;
    for (const CurvePoint& point : points)
        places.push_back({time.at(point.seconds), point.error > 0 ? foot + (1 - foot) * error.at(point.error) : 0});
    return places;
}

std::vector<std::size_t> curve_front(const UnitCurve& curve)
{
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < curve.others.size(); ++i)
        if (front.empty() || curve.others[i].error < curve.others[front.back()].error) front.push_back(i);
    return front;
}

}
