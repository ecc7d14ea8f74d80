#pragma once

#include <memory>
#include <string>

#include "judge/relation.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

/// What a run recorded for a check that has a relation.
[[nodiscard]] RelatedTensors related_tensors(const Check& check, const RunOutcome& run);

/// What a report holds up against the student's value: what was expected or, of a relation, what follows from the
/// student's own other value. Null where there is neither.
struct ExpectedSide {
    std::shared_ptr<const Tensor> tensor;
    std::string words;  ///< "reference", "your 'upright'"
};
[[nodiscard]] ExpectedSide expected_side(const Check& check, const RunOutcome& student, const RunOutcome& expected);

/// A check with a relation as one without: why the relation fails is seen in that of its values that is wrong. Its own
/// value unless that is right by the reference and the one it follows from is not.
[[nodiscard]] Check against_reference(const Check& check, const RunOutcome& student, const RunOutcome& expected);

}
