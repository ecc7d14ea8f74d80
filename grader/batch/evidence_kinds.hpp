#pragma once

#include "batch/evidence.hpp"
#include "judge/tensor_view.hpp"

namespace umbral::grader {

// How evidence of each kind is made; both tensors are well formed. See evidence_of.

[[nodiscard]] html::Evidence picture_evidence(const Check& check, const Tensor& yours, const Tensor& expected, bool right);
[[nodiscard]] html::Evidence rows_evidence(const Check& check, const Observation& observation);
[[nodiscard]] html::Evidence trace_evidence(const Tensor& yours, const Tensor& expected);
[[nodiscard]] html::Evidence events_evidence(const Check& check, const Observation& observation);
[[nodiscard]] html::Evidence fragments_evidence(const Check& check, const Observation& observation, const CheckResult& result);
[[nodiscard]] html::Evidence cost_evidence(const Check& check, const Tensor& yours, const Tensor& expected);

/// Two numbers with as many digits as it takes to tell them apart, at least six.
struct NumberPair {
    std::string yours;
    std::string expected;
};
[[nodiscard]] NumberPair telling_apart(double yours, double expected);

}
