#pragma once

#include <vector>

namespace umbral::bench {

/// A logarithmic axis between two pixels.
class LogAxis {
public:
    /// From the smallest to the largest of `values` (those that are positive and finite), widened to at least a factor
    /// of two. Pixels run from `first` to `last`; `pad_first` and `pad_last` pixels at the ends hold no value.
    LogAxis(const std::vector<double>& values, double first, double last, double pad_first, double pad_last);

    /// The pixel of a positive value.
    [[nodiscard]] double at(double value) const;

    struct Tick {
        double value;
        bool labelled;
    };
    /// Decades, and between them 2 and 5 (labelled if there are under two decades); none far from all values.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double least_;  ///< logarithms of the smallest and the largest value
    double most_;
    double low_;   ///< logarithm at pixel `first_`
    double high_;  ///< logarithm at pixel `last_`
    double first_;
    double last_;
};

}
