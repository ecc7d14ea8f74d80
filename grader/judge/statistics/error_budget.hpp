#pragma once

namespace umbral::grader {

/// Checks of noise in all units of a course, among which the chance to fail correct work is shared out. A fixed number,
/// more than a course has: the same work gets the same verdict whether it is graded alone or with others, and a budget
/// for 100 instead of 10 costs half a standard deviation.
inline constexpr int most_noise_checks = 100;

// The family-wise error budget of noise checks; pure arithmetic. docs/architecture.md derives it.

/// Level of each of `tests` tests so that all together accuse what is right with chance `alpha`: 1 - (1 -
/// alpha)^(1/tests). Exact if they are independent, an upper bound for two-sided normal ones whatever ties them
/// together. Based on: Z. Sidak. Rectangular Confidence Regions for the Means of Multivariate Normal Distributions.
/// 1967.
[[nodiscard]] double sidak(double alpha, double tests);

/// Its inverse: the chance that the smallest of `tests` p-values is at most `smallest`.
[[nodiscard]] double sidak_probability(double smallest, double tests);

/// The level of one noise check: its share of thresholds::submission_alpha.
[[nodiscard]] double check_alpha();

/// The p-value of a test in two stages: a first one that ends it unless first < borderline, and a second one with a
/// fresh seed.
///
/// first if first >= b, else c (1 + ln(b / c)) with c = first * second: the chance under uniform p-values that the
/// first is below b and the product at most c. Uniform itself, therefore, and comparable with any level. With b = 1 it
/// is Fisher's combination of two. Based on: R. A. Fisher. Statistical Methods for Research Workers. 1925; P. Bauer, K.
/// Koehne. Evaluation of Experiments with Adaptive Interim Analyses. 1994.
[[nodiscard]] double two_stage_probability(double first, double second, double borderline);

/// What a first p-value decides about a noise check.
enum class FirstRun { right, borderline, wrong };

/// Right from `noise_borderline` up; wrong if no second run could save it, as two_stage_probability(first, 1) is below
/// check_alpha().
[[nodiscard]] FirstRun after_first_run(double first);

}
