#pragma once

#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What became of one mutant.
struct Trial {
    bool killed = false;
    std::string by;  ///< the check that lost points, or how the run ended: "random/t", "crashed in random"
};

/// Grades mutant `number` of a library as a submission is graded, case by case in the order of `cases`, up to the first
/// check that loses points. Throws std::runtime_error for a fault of the grader's.
[[nodiscard]] Trial try_mutant(Worker& worker, const Exercise& exercise, const std::filesystem::path& library,
                               unsigned number, const std::vector<std::string>& cases, unsigned seed);

}
