#pragma once

#include <string>

#include "model/exercise.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// The student's run of one case with the inputs of this seed, also past the questions in which it crashed. With
/// `explains`, the question in which it ended is looked for. Throws std::runtime_error for a fault of the grader's.
[[nodiscard]] CaseResult run_case(Worker& worker, const Exercise& exercise, const Built& built, const std::string& name,
                                  std::uint64_t seed, bool explains);

}
