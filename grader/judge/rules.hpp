#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

// The rules behind judge(). Both tensors are well formed and of one type when they are called; of one shape too, but for the kinds of
// which has_free_rows is true: their numbers of rows may differ.

[[nodiscard]] Judgement judge_numbers(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

/// Rows of 9 or 16 components, column-major. Relative bounds and ulps count against the largest entry of the expected column (of the whole
/// matrix where that column is zero): a translation of a million does not excuse the rotation beside it, and an entry that is zero by
/// cancellation may keep the rounding of its neighbours.
[[nodiscard]] Judgement judge_matrices(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

/// Cells are equal exactly, or within the tolerance if one is given. The background is the most frequent cell of the expected border; the
/// fraction is of the cells where either side differs from it, so that a mostly empty buffer hides nothing. `with_classes` says where the wrong
/// cells lie, whose values they hold and what rule they follow, and draws the first bad place.
[[nodiscard]] Judgement judge_buffer(const Check& check, const Tensor& student, const Tensor& expected, bool with_classes);

/// The combined rule of image_rule.hpp; `with_metrics` adds SSIM, PSNR, RMSE and Lab differences, which do not decide.
[[nodiscard]] Judgement judge_image(const Check& check, const Tensor& student, const Tensor& expected, bool with_metrics);

/// Rows [primitive, x, y, attributes...], matched by their place. The fraction is matched / (expected + extra + duplicated); what lies
/// one pixel aside with its whole primitive is in the wrong place, and neither missing nor extra. Without a tolerance attributes are
/// equal or wrong. `with_sketch` draws the first bad place.
[[nodiscard]] Judgement judge_fragments(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names, bool with_sketch);

/// Rows [code, numbers...], aligned in order so that what is lost or too much costs itself only: 2 matches / (yours + expected).
[[nodiscard]] Judgement judge_events(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names);

/// Calls of OpenGL, counted by the check's rules against the expected ones; the fraction of the rules that hold. Worth nothing if nothing
/// is drawn where the expected trace draws.
[[nodiscard]] Judgement judge_trace(const Check& check, const Tensor& student, const Tensor& expected);

/// Rows (size, blocks): the exponent with which the student's count grows. Right up to check.growth + 0.15, falling to 0 at + 0.6; worth
/// nothing where next to no work was done, since a function that returns at once grows with nothing.
[[nodiscard]] Judgement judge_cost(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names);

/// The mean of Monte Carlo estimates, by the test of stochastic.hpp: pictures of bytes (sRGB) or floats (light), and tables whose rows are
/// replicates and whose components are quantities. Right if noise explains the worst deviation with at least check_alpha(); else the
/// credit falls with the share of the light in the wrong place.
[[nodiscard]] Judgement judge_noise(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names);

/// Does this kind compare tables whose numbers of rows may differ?
[[nodiscard]] bool has_free_rows(JudgeKind kind);

/// What is wrong with the student's type or shape for this kind of check, as a sentence; nothing if it can be judged.
[[nodiscard]] std::optional<std::string> shape_error(const Check& check, const Tensor& student, const Tensor& expected);

/// The fraction right only, by the quickest way there is.
[[nodiscard]] double fraction_right(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

}
