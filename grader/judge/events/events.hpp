#pragma once

#include <map>
#include <string>
#include <string_view>

#include "judge/evidence/evidence.hpp"
#include "judge/explain/explain.hpp"
#include "judge/rows/alignment.hpp"
#include "judge/rows/tensor_view.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// Names of event codes from lines such as "3 zoom"; other lines are passed over.
[[nodiscard]] std::map<double, std::string> event_names(std::string_view lines);

/// Wrong as a mistake is: sequences that differ by at most a twentieth of what parts them from the expected one.
[[nodiscard]] Resemblance same_events(const FailingCheck& failing, const Tensor& mistake);

/// What a page shows of events; nothing if they are right.
[[nodiscard]] Evidence events_evidence(const Check& check, const Observation& observation, bool right);

/// The events of two tables aligned: equal codes, and numbers within the check's tolerance (none: equal). Where `a` is
/// far longer than `b`, its end is left out, so that the time is bounded by what was expected.
[[nodiscard]] Alignment align_events(const Check& check, const TensorView& a, const TensorView& b);

}
