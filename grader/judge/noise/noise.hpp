#pragma once

#include "judge/judge.hpp"
#include "judge/statistics/error_budget.hpp"
#include "judge/statistics/stochastic.hpp"

#include <umbral/core/grid.hpp>

namespace umbral::grader {

/// Is this a table of estimates (one column, a row for each replicate), and not a picture?
[[nodiscard]] bool is_table(const Tensor& tensor);

/// The judgement of a borderline check from its run with the case's seed and the one with a fresh seed: by
/// two_stage_probability, and where that is wrong, by the mean of what both found misplaced. A second run that could
/// not be judged decides by itself.
[[nodiscard]] Judgement judge_both(const Judgement& first, const Judgement& second);

/// How far the mean of each tile of 16 x 16 pixels lies from the expected one, in levels of 255 of the check's range:
/// what a map of single pixels would drown in noise. A tile that differs at all has at least level 1. Both tensors are
/// pictures of one shape.
[[nodiscard]] Grid<std::uint8_t> noise_map(const Check& check, const Tensor& student, const Tensor& expected);

/// The values of a tensor of bytes or floats that `noise` can judge. Throws std::invalid_argument if it is none.
[[nodiscard]] Estimates estimates_of(const Check& check, const Tensor& tensor);

}
