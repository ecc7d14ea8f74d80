#include "validate/rubric_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbral::grader {

std::string rubric_complaint(std::size_t line, const UnitResult& result)
{
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < result.rubric.size(); ++i) {
        const bool lost = result.rubric[i].score < result.rubric[i].max_score;
        if (i == line && !lost) return fmt::format("line {} of the rubric loses nothing", line + 1);
        if (i != line && lost) others.push_back(i + 1);
    }
    if (others.empty()) return "";
    std::vector<std::string> checks;
    for (const CheckResult& check : result.checks)
        if (check.score < check.max_score) checks.push_back(check.name);
    return fmt::format(
        "is to cost points in line {} of the rubric only, but line {} loses some too; checks that take "
        "points: {}",
        line + 1, fmt::join(others, ", "), fmt::join(checks, ", "));
}

std::vector<Finding> expect_rubric(const Exercise& exercise, const std::vector<KnownSolution>& mistakes, unsigned seed)
{
    std::vector<Finding> findings;
    for (std::size_t line = 0; line < exercise.rubric.size(); ++line) {
        if (std::ranges::find(mistakes, std::optional(line), &KnownSolution::rubric_line) != mistakes.end()) continue;
        findings.push_back({exercise.id, fmt::format("rubric: line {}", line + 1), seed, false, 0, "a mistake",
                            fmt::format("no mistake says 'rubric: {}': a fault in this line must be seen to cost "
                                        "points there, and in no other line",
                                        line + 1)});
    }
    return findings;
}

}
