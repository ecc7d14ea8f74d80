#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measurement.hpp"

namespace umbral::bench {

/// What one setting costs and leaves.
struct Offer {
    double time = 0;   ///< > 0
    double error = 0;  ///< >= 0
};

/// Indices of the offers that no other beats (one that is at least as good in both, and better in one), cheapest first.
/// Of equal ones the first stays; an error that is smaller by less than one percent counts as equal, since measuring
/// twice differs by as much. Offers that are not finite, or whose time is not positive, are never on the front.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Offer> offers);

/// The bend of "the least error for at most this time": of the curve along the Pareto front and then, with the front's
/// last error, on to the dearest offer. It is the place in `front` whose point lies farthest below the chord from the
/// curve's first to its last point, where both axes are logarithms. None if no point lies below the chord.
///
/// Before the knee a doubling of time buys more than the curve does on average, beyond it less. Scaling either axis
/// moves no knee, since it scales all distances to the chord alike. An error of 0 counts as half the smallest error
/// above 0. Based on: V. Satopää, J. Albrecht, D. Irwin, B. Raghavan. Finding a "Kneedle" in a Haystack. 2011.
[[nodiscard]] std::optional<std::size_t> knee_of(std::span<const Offer> offers, std::span<const std::size_t> front);

/// By what factor the error falls when the time doubles, on the straight line between two offers (log-log): 2 halves
/// the error.
[[nodiscard]] double gain_of_doubling(const Offer& cheap, const Offer& dear);

/// The curve of one situation and measure: front, knee, and the sentence that tells them.
[[nodiscard]] Curve curve_of(const Knob& knob, const std::string& situation, const std::string& measure);

/// A number for people: three significant digits, grouped without exponent where that is short ("0.31", "8 170",
/// "2.4e+06").
[[nodiscard]] std::string number_text(double value);

}
