#pragma once

#include <functional>
#include <utility>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader::test {

/// How a case was answered.
using Answer = std::function<RunOutcome(const std::string& case_name, std::uint64_t seed)>;

/// A submission whose cases were answered as given, judged.
inline std::pair<UnitResult, CaseResults> hand_in(Worker& worker, const Exercise& exercise, const Answer& answer)
{
    CaseResults cases;
    for (const std::string& name : exercise.cases()) {
        CaseResult one;
        one.seed = SeedPlan{}.seed_of(exercise, name);
        one.student = answer(name, one.seed);
        cases.emplace(name, std::move(one));
    }
    UnitResult result;
    for (const Check& check : exercise.checks) {
        const CaseResult& one = cases.at(check.case_name);
        const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
        const RunOutcome& reference = worker.trusted(exercise, Answers::reference, check.case_name, one.seed);
        result.checks.push_back(judge_check(check, one, expected, reference));
        result.score += result.checks.back().score;
        result.max_score += check.points;
    }
    return {result, std::move(cases)};
}

}
