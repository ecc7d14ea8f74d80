#pragma once

#include <cstddef>
#include <string>

#include "judge/picture.hpp"

namespace umbral::grader {

/// How likely two Monte Carlo pictures have the same expectation.
struct StochasticRule {
    bool agree = false;
    double probability = 1;  ///< that chance alone gives a tile at least as far off as the worst, over all tests
    double worst_z = 0;      ///< of the worst tile, in standard deviations; positive where yours is brighter
    int x = 0;               ///< left, top and size of that tile
    int y = 0;
    int width = 0;
    int height = 0;
    int channel = 0;        ///< 0 red (or grey), 1 green, 2 blue
    double yours = 0;       ///< its mean in light (0 .. 1, linear) …
    double expected = 0;    ///< … and the expected one
    std::size_t tests = 0;  ///< tiles times channels, of all sizes

    /// "the light is 3 % too high in the tile …": one line, empty if they agree.
    [[nodiscard]] std::string message() const;
};

/// Chance of a false alarm for a pair of right pictures.
inline constexpr double stochastic_alpha = 1e-4;

/// Compares two noisy pictures of one size whose pixels are independent estimates of the same light.
///
/// In tiles of 16 x 16 and of 64 x 64 pixels, and in the whole picture, the mean difference over its standard error is Student's t; the
/// error is estimated within the tile from the differences of its pixels, so that what both pictures show cancels and only noise is left.
/// A local mistake shows in a small tile, a wrong factor everywhere in the large ones. Sidak's correction over all tiles and channels
/// keeps the chance of a false alarm at `stochastic_alpha` in all.
///
/// Values are decoded from sRGB first: light is what averages. Both pictures should have about as many samples, since clipped highlights
/// lie lower the more noise there is; half a percent of the light and what rounding to 8 bits can do are allowed for. A filter that spreads
/// samples over neighbouring pixels makes them depend on each other: then the test is too strict.
/// Based on: K. Subr, J. Arvo. Statistical Hypothesis Testing for Assessing Monte Carlo Estimators. Pacific Graphics 2007;
/// Z. Sidak. Rectangular Confidence Regions for the Means of Multivariate Normal Distributions. 1967.
[[nodiscard]] StochasticRule apply_stochastic_rule(const Picture& yours, const Picture& expected);

}
