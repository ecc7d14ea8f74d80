#include "validate/question_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "judge/judges.hpp"
#include "question/log.hpp"

namespace umbral::grader {

std::vector<Finding> expect_questions(Worker& worker, const Exercise& exercise, const SeedPlan& seeds, unsigned seed)
{
    std::vector<Finding> findings;
    for (const std::string& name : exercise.cases()) {
        const RunOutcome told =
            worker.inquire(exercise, Answers::reference, name, seeds.seed_of(exercise, name), {.questions = true});
        const QuestionLog log = read_questions(told.recording.tensors);
        std::set<std::string> without;
        for (const Check& check : exercise.checks) {
            const auto rows = log.rows.find(check.value);
            if (check.case_name == name && rows != log.rows.end() && judge_of(check).plain_values &&
                std::ranges::find(rows->second, 0U) != rows->second.end())
                without.insert("'" + check.value + "'");
        }
        if (without.empty() && told.verdict == Verdict::ok) continue;
        findings.push_back({exercise.id, "questions: " + name, seed, false, 0, "one a row",
                            told.verdict == Verdict::ok
                                ? fmt::format("rows of {} have none: the driver must ask() before it records them",
                                              fmt::join(without, ", "))
                                : told.message});
    }
    return findings;
}

}
