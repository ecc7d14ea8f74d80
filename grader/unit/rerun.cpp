#include "unit/rerun.hpp"

#include <fmt/format.h>

#include <map>

#include "judge/judges.hpp"

namespace umbral::grader {
namespace {

Judgement judged(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one)
{
    Judgement judgement;
    const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
    const Expected expected = expected_of(check, run);
    if (expected.value == nullptr)
        throw std::runtime_error(
            fmt::format("check '{}': the driver recorded nothing called '{}'", check.name, check.value));
    judgement.message = kept_from_judging(check, one, run);
    if (!judgement.message.empty()) return judgement;
    return judge(check, *observed(check, one.student), *expected.value, nullptr, expected.names);
}

}

void rerun_borderline(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                      const GradeOptions& options, UnitResult& result)
{
    CaseResults again;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        CheckResult& before = result.checks[i];
        if (!before.borderline) continue;
        const CaseResult& one = cases.at(check.case_name);
        const auto [fresh, added] = again.try_emplace(check.case_name);
        if (added && !may_run_another(worker.budget(), again, exercise.limits)) {
            fresh->second = not_reached(options.seeds.fresh_seed_of(exercise, check.case_name), one.hidden);
        } else if (added) {
            fresh->second.seed = options.seeds.fresh_seed_of(exercise, check.case_name);
            fresh->second.hidden = one.hidden;
            fresh->second.student = worker.run(exercise, built, check.case_name, fresh->second.seed);
            if (fresh->second.student.verdict == Verdict::grader_fault)
                throw std::runtime_error(fresh->second.student.message);
        }
        const Judgement both = judge_of(check).judge_both(judged(worker, exercise, check, one),
                                                          judged(worker, exercise, check, fresh->second));
        take_judgement(check, both, worker.basis(exercise, check, one.seed).control, before);
        before.seeds.push_back(fresh->second.seed);
    }
}

}
