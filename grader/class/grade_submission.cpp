#include "class/grade_submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "class/submission_parts.hpp"
#include "model/faults.hpp"
#include "report/formats.hpp"
#include "report/html/pages.hpp"
#include "report/paint.hpp"
#include "store/kept_unit.hpp"
#include "store/report_folder.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

UnitResult fault_of(const Exercise& exercise, const std::string& what)
{
    UnitResult result;
    result.id = exercise.id;
    result.digest = exercise.digest;
    result.verdict = Verdict::grader_fault;
    result.message = std::string(fault_preface) + what;
    return result;
}

Part grade_part(Worker& worker, const SubmissionPlan& plan, const Exercise& exercise, const Handed& handed,
                const std::string& student, const fs::path& folder, const SubmissionBudgets& budgets)
{
    GradeOptions options;
    options.budgets = budgets;
    options.seeds.secret = plan.secret;
    options.seeds.course = plan.plan.grading.course;
    options.seeds.student = student;
    options.seeds.attempt = plan.plan.grading.attempt;
    options.other_inputs = true;
    options.explain = plan.plan.explain;
    options.show_hidden = plan.plan.instructor_edition;
    options.relative_to = folder;
    options.artefacts = folder / "pictures";
    auto [result, detail] = grade_with_evidence(worker, exercise, handed, options);
    Part part;
    part.unit.machine = machine_digest(plan.plan.fingerprint);
    part.unit.result = std::move(result);
    part.sections.student = html::section_html(part.unit.result, detail, html::Edition::student);
    if (plan.plan.instructor_edition)
        part.sections.instructor = html::section_html(part.unit.result, detail, html::Edition::instructor);
    return part;
}

/// Keeps what was found of a unit: a fault, and what may come out otherwise, only to be shown, anything else for as
/// long as its key holds.
void keep(const fs::path& folder, const Exercise& exercise, const std::string& key, Part& part)
{
    const std::string& id = exercise.id;
    if (part.unit.result.verdict == Verdict::grader_fault) {
        part.unit.result.unscored = exercise.points;
        keep_unit(fault_file(folder, id), part.unit, part.sections);
        return;
    }
    if (part.unit.result.settled) part.unit.key = key;
    keep_unit(unit_file(folder, id), part.unit, part.sections);
    fs::remove(fault_file(folder, id));
}

std::string change(const std::optional<KeptUnit>& before, const UnitResult& now)
{
    if (!before || now.verdict == Verdict::grader_fault ||
        (before->result.score == now.score && before->result.max_score == now.max_score))
        return "";
    return fmt::format("{}: {} of {} before, {} of {} now", now.id, points_text(before->result.score),
                       points_text(before->result.max_score), points_text(now.score), points_text(now.max_score));
}

void write_reports(const SubmissionPlan& plan, const fs::path& folder, const SubmissionResult& result,
                   const std::vector<Part>& parts)
{
    const auto titles = english_titles(plan.course);
    SubmissionReport report{result, plan.plan.fingerprint, titles, plan.plan.instructor_edition};
    for (const Part& part : parts) {
        report.student_sections.push_back(part.sections.student);
        // A unit of an earlier run may lack this edition: the student's says less, and nothing wrong.
        report.instructor_sections.push_back(part.sections.instructor.empty() ? part.sections.student
                                                                              : part.sections.instructor);
    }
    write_reports(folder, report);
}

}

Graded grade_submission(Crew& crew, const SubmissionPlan& plan, const SubmissionFolder& submission,
                        const std::function<void()>& graded)
{
    const fs::path folder = plan.out.folder_of(submission.id);
    Mark mark = open_report_folder(folder, submission.id);
    if (mark.grading != plan.plan.grading) forget_results(folder);
    mark.grading = plan.plan.grading;
    mark.shown = submission.shown == submission.id ? "" : submission.shown;
    mark.source = source_of(submission);
    mark.reports.clear();
    set_mark(folder, mark);
    tidy_temporaries(folder);

    std::optional<SubmittedFiles> submitted;
    std::string trouble;
    try {
        submitted = read_files(plan, submission);
    } catch (const std::exception& error) {
        trouble = error.what();
    }
    std::vector<Part> parts(plan.exercises.size());
    std::vector<std::string> changes(parts.size());
    const SubmissionBudgets budgets = budgets_of_a_submission();
    std::mutex mutex;
    std::set<std::string> old_pictures;
    crew.share_out(parts.size(), [&](Worker& worker, std::size_t i) {
        const Exercise& exercise = plan.exercises[i];
        const Handed handed = submitted ? collect(*submitted, exercise) : Handed{};
        const std::string key = submitted ? plan.keys.key(exercise, submission.id, handed) : "";
        std::optional<KeptUnit> before = kept_unit(unit_file(folder, exercise.id));
        if (before) {
            const std::lock_guard lock(mutex);
            old_pictures.merge(pictures_of(before->result));
        }
        if (before && submitted && before->key == key && is_whole(folder, exercise, before->result))
            if (auto sections = kept_sections(unit_file(folder, exercise.id))) {
                fs::remove(fault_file(folder, exercise.id));
                parts[i] = {*std::move(before), *std::move(sections)};
                return;
            }
        Part& part = parts[i];
        if (submitted) {
            part = grade_part(worker, plan, exercise, handed, submission.id, folder, budgets);
        } else {
            part.unit.machine = machine_digest(plan.plan.fingerprint);
            part.unit.result = fault_of(exercise, trouble);
            part.sections.student = html::section_html(part.unit.result, {}, html::Edition::student);
        }
        keep(folder, exercise, key, part);
        changes[i] = change(before, part.unit.result);
        const std::lock_guard lock(mutex);
        graded();
    });
    std::erase(changes, "");
    add_units_of_earlier_runs(plan, folder, parts);
    put_in_order(plan, parts);

    Graded done = result_of(plan, submission.id, submission.shown, parts);
    done.changed = std::move(changes);
    write_reports(plan, folder, done.result, parts);
    mark.reports = reports_digest(plan, done.result);
    set_mark(folder, mark);
    for (const UnitResult& unit : done.result.units)
        for (const std::string& picture : pictures_of(unit)) old_pictures.erase(picture);
    remove_pictures(folder, old_pictures);
    done.current = true;
    return done;
}

}
