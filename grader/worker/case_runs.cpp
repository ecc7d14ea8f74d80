#include "worker/case_runs.hpp"

namespace umbral::grader {

CaseRuns::CaseRuns(Worker& worker, const Exercise& exercise, const Built& built, std::string case_name,
                   const CaseResult& seen)
    : worker_(worker), exercise_(exercise), built_(built), case_(std::move(case_name)), seen_(seen)
{
}

const RunOutcome& CaseRuns::plain(std::uint64_t seed)
{
    if (seed == seen_.seed) return seen_.student;
    if (const auto found = plain_.find(seed); found != plain_.end()) return found->second;
    return plain_.emplace(seed, worker_.run_again(exercise_, built_, case_, seed)).first->second;
}

const RunOutcome& CaseRuns::told(std::uint64_t seed)
{
    if (const auto found = told_.find(seed); found != told_.end()) return found->second;
    return told_.emplace(seed, worker_.run_told(exercise_, built_, case_, seed)).first->second;
}

}
