#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// The judge of colour pictures: for what compares pictures without a manifest.
[[nodiscard]] inline JudgeKind image_kind() { return {"image"}; }

/// The combined rule of image_rule.hpp; `with_metrics` adds SSIM, PSNR, RMSE and Lab differences, which do not decide.
[[nodiscard]] Judgement judge_image(const Check& check, const Tensor& student, const Tensor& expected,
                                    bool with_metrics);

}
