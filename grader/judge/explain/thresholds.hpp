#pragma once

#include <cstddef>

/// Every threshold of the judges that no manifest declares, with where it comes from.
///
/// Those of the image rule were set on half of the scenes of `umbral bench judge`, so that harmless pictures stay below
/// half of each (of (e) and (f) a third); docs/judging.md holds the table for the other half.
namespace umbral::grader::thresholds {

// Rows of numbers and matrices, and events. Eight times a tolerance, which has room for every right way to round, is
// another value.
constexpr double clear_ratio = 8.0;
/// The share of a check that a clearly wrong row costs at least.
constexpr double clear_cost = 0.2;

// (a) Edges: largest of the two one-way 3x3 minimum differences. Based on: the fuzzy compare of the Khronos conformance
// suite, with the larger direction instead of the smaller, or a missing thin line would pass.
constexpr int edge_levels = 10;
constexpr double edge_share = 0.0015;

// (b) Colour in the smooth interior, where no edge can excuse a difference. 5 levels: filament's gate for renders on
// one machine.
constexpr int interior_levels = 5;
constexpr double interior_share = 0.005;
/// A pixel is smooth if no channel of the expected 3x3 neighbourhood spans more: a unit step of a shading gradient is
/// far below this, a silhouette far above.
constexpr int smooth_span = 16;
/// Where less than this share of the content is smooth (a wireframe), the content's area is the base: one stray pixel
/// is not all.
constexpr double smooth_floor = 0.25;

// (c) Mean bias over the content: a wrong light moves everything a little. Cutting off instead of rounding moves it by
// half a level.
constexpr double bias_share = 0.012;
constexpr double bias_levels = 1.2;

// (d) Shift: another alignment is better only if it leaves less than this share of the difference; re-owned edge pixels
// reach 0.95.
constexpr double shift_gain = 0.8;
/// Below this mean difference (levels, over the content) no shift is looked for: it would be fitted to rounding.
constexpr double shift_minimum = 0.25;
/// Ratio charged for one pixel of shift, which (a) forgives by design: two thirds of the credit remain.
constexpr double shift_ratio = 4.5;

// (e) Holes and cracks: so many of the pixels of (a) in one window of 16 x 16 are no accident.
constexpr double cluster_pixels = 7;

// (f) A surface's mean level in one window of 16 x 16, of its smooth pixels only.
constexpr double window_levels = 2.2;
constexpr double window_share = 0.012;
/// A mean of fewer pixels says little.
constexpr int window_pixels = 48;
// (g) Displacement of the edges by a part of a pixel: another sampling point displaces them by half a pixel.
constexpr double displacement = 0.25;

/// Ratio charged at most for (e), (f) and (g): three quarters of the credit remain.
constexpr double window_ratio = 3.0;

/// A pixel belongs to the content if a channel differs by more from the background. Two levels: a dithered or
/// re-rounded background stays background; errors in what is left out are at most 4 levels, below every other
/// threshold.
constexpr int background_levels = 2;

/// Worst ratio of a measure to its threshold at which a picture is worth nothing. Credit falls with the logarithm of
/// the ratio, as errors spread over decades: ten times the threshold is worth one half. 100: 15 % of edges or half of
/// the interior wrong.
constexpr double zero_ratio = 100.0;

/// Side of the window that worst_region looks for.
constexpr int worst_window = 32;

// Growth of counted work. Sizes a factor of 16 apart and n log n make an exponent of 1.12: what admits n admits n log
// n, and nothing near n^2.
constexpr double growth_full = 0.15;  ///< above the declared exponent: still all right
constexpr double growth_zero = 0.6;   ///< worth nothing
/// Share of the reference's work, and count, below which a function cannot have done its task: it returned at once.
constexpr double least_work = 0.02;
constexpr double least_blocks = 4;
/// Processor time, seen from outside, in milliseconds. A run that takes this much more than the reference's has its
/// count weighed against it …
constexpr double outside_ratio_unmeasured = 1.5;
constexpr double outside_unmeasured = 2;
/// … where so much is noise: the least of three runs of the same work differs by a third of it …
constexpr double outside_noise = 0.5;
/// … and loses only if its work takes this many times the reference's, beside growing too fast …
constexpr double outside_ratio = 3;
/// … or if so much passes before anything is counted.
constexpr double outside_ratio_before = 4;
constexpr double outside_before = 20;
/// Exponents of a student and of a mistake that did the same.
constexpr double same_growth = 0.2;

/// An explanation must raise a failing check to this (or make it right) …
constexpr double explained = 0.9;
/// … from at most this share of it.
constexpr double unexplained_share = 0.5;
/// Share of an error that undoing may leave, by rounding, without speaking against the transform.
constexpr double rounding_left = 1e-3;
/// Share of the rows in which a mistake must deviate as the student did.
constexpr double mistake_share = 0.95;
/// Confidence of explanations (confidence.hpp): judgement, which `umbral bench explanations` measures.
constexpr double least_sure = 0.6;        ///< below it nothing is said: a wrong explanation is worse than none
constexpr double very_sure = 0.9;         ///< from here on "very likely", below it "probably"
constexpr double equally_sure = 0.02;     ///< two that differ by less match equally well
constexpr double bits_scale = 4;          ///< as many bits halve what is left of the doubt
constexpr double most_pattern_bits = 12;  ///< from which rows deviate, of one check
constexpr double most_value_bits = 48;    ///< from the values in them, of one check
constexpr std::size_t most_explanations = 3;

// Monte Carlo. Chance that correct work fails any noise check of a submission: a course of 100 students with 10
// submissions each meets such a failure once in ten such courses.
constexpr double submission_alpha = 1e-4;
/// Below this probability a noise check is borderline, and judged on two runs: 1 of 100 correct ones costs a second
/// run.
constexpr double noise_borderline = 0.01;
/// Share of the light in the wrong place at which a wrong picture is worth all and nothing; linear in its logarithm
/// between. Twice the light (a missing cosine, a solid angle for a hemisphere) knows nothing of the integral; 1 % is a
/// slip in an offset.
constexpr double noise_full = 0.01;
constexpr double noise_zero = 0.5;
/// … and the most that a proven bias is worth, however small.
constexpr double noise_most = 0.9;
/// Rows of a table of estimates below which nothing can be proven: the largest deviation of n rows is the root of n.
constexpr int noise_rows = 64;

}
