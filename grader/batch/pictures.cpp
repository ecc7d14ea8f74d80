#include "batch/pictures.hpp"

#include <algorithm>
#include <array>
#include <umbral/core/png.hpp>

#include "batch/related.hpp"
#include "judge/noise.hpp"
#include "report/triptych.hpp"
#include "run/run_text.hpp"

namespace umbral::grader {
namespace {

std::string file_name(const Exercise& exercise, const Check& check)
{
    std::string name = exercise.id + "-" + check.name + ".png";
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '-');
    return name;
}

}

void save_pictures(Workshop& workshop, const Exercise& exercise, const CaseResults& cases, const GradeOptions& options, UnitResult& result)
{
    bool one_saved = false;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        const bool failing = result.checks[i].score < check.points;
        if (!is_picture(check) || check.hidden || !one.trouble().empty() || (!failing && (one_saved || result.verdict != Verdict::ok))) continue;
        const Tensor* student = tensor_of(one.student, check.value);
        const ExpectedSide expected = expected_side(check, one.student, workshop.trusted(exercise, judged_against(check), check.case_name, one.seed));
        const bool noise = check.judge == JudgeKind::noise;
        if (student == nullptr || expected.tensor == nullptr || (noise && is_table(*expected.tensor))) continue;
        try {
            std::filesystem::create_directories(options.artefacts);
            const std::filesystem::path file = options.artefacts / file_name(exercise, check);
            write_png(file,
                      triptych(to_image(*student, check), to_image(*expected.tensor, check), expected.words, noise ? JudgeKind::noise : JudgeKind::image));
            result.checks[i].artefacts["triptych"] = std::filesystem::relative(file, options.relative_to).string();
            one_saved = true;
        } catch (const std::exception& error) {
            result.message += "a picture is missing: " + without_roots(error.what(), std::array{options.relative_to.string()}) + "\n";
        }
    }
}

std::optional<Image> goal_picture(Workshop& workshop, const Exercise& exercise)
{
    // The colour picture says most; a buffer serves where there is none.
    const auto of_kind = [&](JudgeKind kind) {
        return std::find_if(exercise.checks.begin(), exercise.checks.end(), [&](const Check& check) { return check.judge == kind && !check.hidden; });
    };
    auto chosen = of_kind(JudgeKind::image);
    if (chosen == exercise.checks.end()) chosen = of_kind(JudgeKind::buffer);
    if (chosen == exercise.checks.end()) chosen = of_kind(JudgeKind::noise);
    if (chosen == exercise.checks.end()) return std::nullopt;
    const RunOutcome& run = workshop.trusted(exercise, Tenant::reference, chosen->case_name, SeedPlan{}.seed_of(exercise, chosen->case_name));
    const Tensor* tensor = tensor_of(run, chosen->value);
    if (tensor == nullptr || (chosen->judge == JudgeKind::noise && is_table(*tensor))) return std::nullopt;
    return to_image(*tensor, *chosen);
}

bool save_goal(Workshop& workshop, const Exercise& exercise, const std::filesystem::path& file)
{
    const std::optional<Image> goal = goal_picture(workshop, exercise);
    if (goal) write_png(file, *goal);
    return goal.has_value();
}

}
