#include "axis.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::bench {

LogAxis::LogAxis(const std::vector<double>& values, double first, double last, double pad_first, double pad_last)
    : least_(0), most_(0), low_(0), high_(0), first_(first), last_(last)
{
    double low = INFINITY;
    double high = -INFINITY;
    for (const double value : values) {
        if (!(value > 0) || !std::isfinite(value)) continue;
        low = std::min(low, std::log10(value));
        high = std::max(high, std::log10(value));
    }
    if (low > high) low = high = 0;
    if (const double missing = std::log10(2.0) - (high - low); missing > 0) {
        low -= missing / 2;
        high += missing / 2;
    }
    const double pixels = std::abs(last - first);
    const double per_pixel = (high - low) / (pixels - pad_first - pad_last);
    least_ = low;
    most_ = high;
    low_ = low - pad_first * per_pixel;
    high_ = high + pad_last * per_pixel;
}

double LogAxis::at(double value) const
{
    return first_ + (std::log10(value) - low_) / (high_ - low_) * (last_ - first_);
}

std::vector<LogAxis::Tick> LogAxis::ticks() const
{
    std::vector<Tick> found;
    const bool few = most_ - least_ < 2;
    const double margin = 40 * (high_ - low_) / std::abs(last_ - first_);  // pixels
    for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::ceil(high_)); ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, decade);
            const double logarithm = std::log10(value);
            if (logarithm >= std::max(low_, least_ - margin) && logarithm <= std::min(high_, most_ + margin))
                found.push_back({value, few || digit == 1});
        }
    }
    return found;
}

}
