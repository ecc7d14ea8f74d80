#include <algorithm>
#include <utility>

#include "report/hidden.hpp"

namespace umbral::grader {
namespace {

std::map<std::string, std::string> of_practice(std::map<std::string, std::string> artefacts)
{
    std::erase_if(artefacts, [](const auto& one) { return one.first != practice_picture; });
    return artefacts;
}

}

SubmissionResult without_hidden_values(SubmissionResult submission)
{
    for (UnitResult& unit : submission.units) {
        std::erase_if(unit.explanations, &Explanation::hidden);
        for (CheckResult& check : unit.checks)
            if (check.hidden)
                check = {.name = std::move(check.name),
                         .kind = check.kind,
                         .hard = check.hard,
                         .hidden = true,
                         .unjudged = check.unjudged,
                         .score = check.score,
                         .max_score = check.max_score,
                         .error = {},
                         .reference_error = {},
                         .message = {},
                         .about = std::move(check.about),
                         .headline = {},
                         .metrics = {},
                         .first_difference = {},
                         .common = {},
                         .common_tells = {},
                         .depends = std::move(check.depends),
                         .code_place = std::move(check.code_place),
                         .practice = std::move(check.practice),
                         .practice_example = std::move(check.practice_example),
                         .held_back = check.held_back,
                         .simplest = {},
                         .sketch = {},
                         .artefacts = of_practice(std::move(check.artefacts)),
                         .seeds = {}};
    }
    return submission;
}

bool all_right(const UnitResult& unit)
{
    return unit.verdict == Verdict::ok && !unit.checks.empty() && unit.score >= unit.max_score &&
           std::ranges::all_of(unit.checks, [](const CheckResult& check) { return check.score >= check.max_score; });
}

Verdict shown_verdict(const UnitResult& unit)
{
    return unit.verdict == Verdict::ok && !all_right(unit) ? Verdict::partial : unit.verdict;
}

}
