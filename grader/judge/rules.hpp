#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

// The rules behind judge(). Both tensors are well formed and of one shape and type when they are called.

[[nodiscard]] Judgement judge_numbers(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

/// Rows of 9 or 16 components, column-major. Relative bounds and ulps count against the largest entry of the expected column (of the whole
/// matrix where that column is zero): a translation of a million does not excuse the rotation beside it, and an entry that is zero by
/// cancellation may keep the rounding of its neighbours.
[[nodiscard]] Judgement judge_matrices(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

/// Cells are equal exactly, or within the tolerance if one is given. The background is the most frequent cell of the expected border; the
/// fraction is of the cells where either side differs from it, so that a mostly empty buffer hides nothing.
[[nodiscard]] Judgement judge_buffer(const Check& check, const Tensor& student, const Tensor& expected);

/// The combined rule of image_rule.hpp; `with_metrics` adds SSIM, PSNR, RMSE and Lab differences, which do not decide.
[[nodiscard]] Judgement judge_image(const Check& check, const Tensor& student, const Tensor& expected, bool with_metrics);

/// The fraction right only, by the quickest way there is.
[[nodiscard]] double fraction_right(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin);

}
