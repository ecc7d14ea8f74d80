#pragma once

#include <optional>

#include "explain/asked_answers.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// A wrong value that a student may be shown of a hidden check: the first one with practice inputs (input_seed), and
/// the question that led to it.
struct PracticeExample {
    Difference first;
    std::uint64_t seed = 0;  ///< of its inputs
};

/// Nothing where work that fails the check is right with a few sets of practice inputs, or does not run to its end with
/// them, and of pictures, whose single pixels show nothing. The student's code may be run again.
[[nodiscard]] std::optional<PracticeExample> practice_example(Worker& worker, const AskedCheck& asked);

/// Of each hidden case of which a picture is wrong: the work's run with the first practice inputs with which it is
/// wrong there too. Students are shown it in place of the picture that was graded.
[[nodiscard]] CaseResults practice_pictures(Worker& worker, const Exercise& exercise, const Built& built,
                                            const CaseResults& cases, const UnitResult& result);

}
