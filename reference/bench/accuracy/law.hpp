#pragma once

#include <span>

#include "measurement.hpp"

namespace umbral::bench {

/// A straight line through points, by least squares.
struct Line {
    double slope = 0;
    double intercept = 0;
    double half_width = 0;  ///< of the slope's 95 % confidence interval (Student's t); infinite for two points
};

/// The line y = intercept + slope x through at least two points of different x. Throws std::invalid_argument otherwise.
[[nodiscard]] Line fit_line(std::span<const double> x, std::span<const double> y);

/// What is expected of a family of settings.
struct Expectation {
    std::string family;
    std::string measure;  ///< empty: the time
    std::string against;
    double order = 0;
    std::string reason;     ///< where the order comes from
    std::string otherwise;  ///< why settings of practical size may stray from it
    bool exponential = false;
};

/// How near a slope must be to the order where its interval is narrower: settings of practical size carry terms of
/// higher order, and so bend the line by some hundredths.
inline constexpr double order_tolerance = 0.1;

/// A slope whose interval is wider than ± this tells nothing (all three are relative to orders above 1).
inline constexpr double widest_interval = 0.4;

/// The expectation beside the results of its family, in all situations, whose amount and error are above 0. With a
/// wider interval than that, or fewer than three points, nothing can be told.
[[nodiscard]] Law law_of(const Knob& knob, const Expectation& expected);

/// "error ~ samples^-0.51 ± 0.03; theory -0.5: as theory says. Because …"
[[nodiscard]] std::string sentence_of(const Knob& knob, const Law& law);

}
