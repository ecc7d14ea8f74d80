#pragma once

#include <string>
#include <thread>
#include <vector>

#include "worker/known_solutions.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Known mistakes that are about to be run in a case, one after the other: where there may be a second worker
/// (Worker::second), it begins with the last of them meanwhile, and what it has run need not be run again. Ends that
/// work when it goes.
class MistakesAhead {
public:
    /// All others must live as long.
    MistakesAhead(Worker& worker, const Exercise& exercise, const std::string& case_name, std::uint64_t seed,
                  std::vector<const KnownSolution*> mistakes);

private:
    std::jthread ahead_;
};

}
