#include "model/rubric.hpp"

namespace umbral::grader {

std::vector<RubricScore> by_rubric(const Exercise& exercise, std::span<const CheckResult> checks)
{
    std::vector<RubricScore> lines;
    for (const RubricLine& line : exercise.rubric) lines.push_back({line.words, 0, line.points});
    if (lines.empty()) return lines;
    for (std::size_t i = 0; i < checks.size(); ++i)
        lines.at(exercise.checks.at(i).rubric_line).score += checks[i].score;
    return lines;
}

}
