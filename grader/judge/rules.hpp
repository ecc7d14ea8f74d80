#pragma once

#include "judge/judge.hpp"

namespace umbral::grader {

/// What is wrong with the student's type or shape for this kind of check, as a sentence; nothing if it can be judged.
[[nodiscard]] std::optional<std::string> shape_error(const Check& check, const Tensor& student, const Tensor& expected);

/// The fraction right only, by the quickest way there is.
[[nodiscard]] double fraction_right(const Check& check, const Tensor& student, const Tensor& expected,
                                    const Tensor* margin);

}
