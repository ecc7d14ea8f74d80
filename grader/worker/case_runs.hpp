#pragma once

#include <map>

#include "build/submission.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What a student's build did in one case with the inputs of this seed and that. Each run is made once, when first
/// asked for; references stay valid as long as this lives.
class CaseRuns {
public:
    /// `seen` is the run that was graded.
    CaseRuns(Worker& worker, const Exercise& exercise, const Built& built, std::string case_name,
             const CaseResult& seen);

    [[nodiscard]] const RunOutcome& plain(std::uint64_t seed);

    [[nodiscard]] const Built& built() const noexcept { return built_; }

    /// A run that also says which of its rows each question led to (Worker::run_told).
    [[nodiscard]] const RunOutcome& told(std::uint64_t seed);

private:
    Worker& worker_;
    const Exercise& exercise_;
    const Built& built_;
    std::string case_;
    const CaseResult& seen_;
    std::map<std::uint64_t, RunOutcome> plain_;
    std::map<std::uint64_t, RunOutcome> told_;
};

}
