#pragma once

#include <optional>

#include "judge/judge.hpp"

namespace umbral::grader {

/// How much a recording has in common with the reference's, at a glance: 0 for what knows nothing, 1 for the same.
///
/// The correlation of their values (each component about its own mean; pictures within the check's range), times the
/// share of the cells that have a finite value on both sides among those that have one on either; for fragments the
/// share of the places in either that are in both. Constants get 0 and noise about 0, while another gamma, a missing
/// lamp or a wrong factor still get most: what it measures is knowledge, not correctness. Nothing if the reference
/// holds too little to tell (all cells equal, or fewer than 32 values). Both tensors are well formed, and of the shape
/// that the check needs.
[[nodiscard]] std::optional<double> likeness(const Check& check, const Tensor& student, const Tensor& reference);

}
