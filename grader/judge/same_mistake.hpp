#pragma once

#include "judge/explain.hpp"

namespace umbral::grader {

/// resemblance() for the kinds whose numbers of rows may differ; both tensors fit row_shape_error, and `expected` can be judged.
/// Fragments: the same fragments at 95 % of the places where either deviates. Events: their sequences differ by at most a twentieth of
/// what parts them from the expected one. Traces: the same counts. Costs: exponents within 0.2.
[[nodiscard]] Resemblance same_deviations(const FailingCheck& failing, const Tensor& mistake);

}
