#include "unit/pictures.hpp"

#include <array>
#include <umbral/core/png.hpp>

#include "judge/judges.hpp"
#include "judge/picture/to_image.hpp"
#include "report/triptych.hpp"
#include "run/run_text.hpp"
#include "unit/artefacts.hpp"
#include "worker/related.hpp"

namespace umbral::grader {

namespace {

/// Yours, reference and difference of a check's picture in one file; its path in the report. Nothing if there is no
/// picture on both sides. Throws what writing throws.
std::optional<std::string> saved_triptych(Worker& worker, const Exercise& exercise, const Check& check,
                                          const CaseResult& one, const GradeOptions& options)
{
    const Tensor* student = tensor_of(one.student, check.value);
    const ExpectedSide expected =
        expected_side(check, one.student, worker.trusted(exercise, judged_against(check), check.case_name, one.seed));
    if (student == nullptr || expected.tensor == nullptr || !can_be_drawn(check, *expected.tensor)) return std::nullopt;
    make_artefact_folder(options.artefacts);
    const std::filesystem::path file = options.artefacts / artefact_name(exercise, check, ".png");
    // A class has thousands of them.
    write_png(file,
              triptych(to_image(*student, check), to_image(*expected.tensor, check), expected.words,
                       judge_of(check).look == Look::light ? check.judge : image_kind()),
              Packing::fast);
    return std::filesystem::relative(file, options.relative_to).string();
}

}

void save_pictures(Worker& worker, const Exercise& exercise, const CaseResults& cases, const CaseResults& practice,
                   const GradeOptions& options, UnitResult& result)
{
    bool one_saved = false;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        const CaseResults& runs = check.hidden ? practice : cases;
        const auto found = runs.find(check.case_name);
        const bool failing = result.checks[i].score < check.points;
        if (!is_picture(check) || found == runs.end() || !found->second.cause().empty() ||
            (!failing && (one_saved || check.hidden || result.verdict != Verdict::ok)))
            continue;
        try {
            if (auto path = saved_triptych(worker, exercise, check, found->second, options)) {
                result.checks[i].artefacts[check.hidden ? practice_picture : "triptych"] = *std::move(path);
                one_saved = true;
            }
        } catch (const std::exception& error) {
            result.message +=
                "a picture is missing: " + without_roots(error.what(), std::array{options.relative_to.string()}) + "\n";
        }
    }
}

namespace {

/// The case in which the driver of a unit with noise draws its goal picture with more samples than a check should take.
constexpr const char* goal_case = "goal";
/// … for which it may take so many times as long.
constexpr int patience = 10;

/// The picture of a check as its unit's case `case_name` draws it with the reference. None where the check's values are
/// no picture.
std::optional<Image> drawn(Worker& worker, const Exercise& exercise, const Check& check, const std::string& case_name)
{
    const RunOutcome& run =
        worker.trusted(exercise, Answers::reference, case_name, SeedPlan{}.seed_of(exercise, case_name));
    const Tensor* tensor = tensor_of(run, check.value);
    if (tensor == nullptr || !can_be_drawn(check, *tensor)) return std::nullopt;
    return to_image(*tensor, check);
}

std::optional<Image> drawn_without_noise(Worker& worker, const Exercise& exercise, const Check& check)
{
    Exercise patient = exercise;
    patient.limits.wall_seconds *= patience;
    try {
        return drawn(worker, patient, check, goal_case);
    } catch (const std::runtime_error&) {
        return std::nullopt;  // the driver has no such case
    }
}

}

std::optional<Image> goal_picture(Worker& worker, const Exercise& exercise)
{
    // The colour picture says most; a buffer serves where there is none.
    for (const Look look : {Look::colours, Look::values, Look::light})
        for (const Check& check : exercise.checks) {
            if (judge_of(check).look != look || check.hidden) continue;
            std::optional<Image> picture = drawn(worker, exercise, check, check.case_name);
            if (picture && look == Look::light)
                if (std::optional<Image> better = drawn_without_noise(worker, exercise, check)) return better;
            if (picture) return picture;
        }
    return std::nullopt;
}

bool save_goal(Worker& worker, const Exercise& exercise, const std::filesystem::path& file)
{
    const std::optional<Image> goal = goal_picture(worker, exercise);
    if (goal) write_png(file, *goal);
    return goal.has_value();
}

}
