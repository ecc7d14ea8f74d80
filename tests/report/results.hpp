#pragma once

#include <string>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

inline CheckResult check_result(const std::string& name, Millipoints score, Millipoints max_score, bool hidden = false)
{
    CheckResult check;
    check.name = name;
    check.score = score;
    check.max_score = max_score;
    check.hidden = hidden;
    return check;
}

inline UnitResult unit_result(const std::string& id, Verdict verdict, std::vector<CheckResult> checks)
{
    UnitResult unit;
    unit.id = id;
    unit.verdict = verdict;
    for (const CheckResult& check : checks) {
        unit.score += check.score;
        unit.max_score += check.max_score;
    }
    unit.checks = std::move(checks);
    return unit;
}

inline SubmissionResult submission_result(const std::string& id, std::vector<UnitResult> units)
{
    SubmissionResult submission;
    submission.id = id;
    submission.units = std::move(units);
    add_up(submission);
    return submission;
}

}
