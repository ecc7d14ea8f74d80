#include "class/submission_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/caps.hpp"
#include "model/digest.hpp"
#include "report/formats.hpp"
#include "store/report_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

bool is_asked_for(const SubmissionPlan& plan, const std::string& unit)
{
    return std::ranges::find(plan.exercises, unit, &Exercise::id) != plan.exercises.end();
}

/// What a report shows of a unit that is not asked for now: a fault where there was one, else what was kept.
std::optional<KeptUnit> shown_before(const fs::path& folder, const std::string& unit)
{
    std::optional<KeptUnit> fault = kept_unit(fault_file(folder, unit));
    return fault ? fault : kept_unit(unit_file(folder, unit));
}

/// Are all reports there, or has somebody deleted one?
bool has_reports(const fs::path& folder, bool with_hidden)
{
    return std::ranges::all_of(submission_files(), [&](const auto& file) {
        return (file.hidden_values && !with_hidden) || fs::exists(folder / file.name);
    });
}

}

bool is_whole(const fs::path& folder, const Exercise& exercise, const UnitResult& unit)
{
    return unit.max_score == exercise.points && std::ranges::all_of(pictures_of(unit), [&](const std::string& path) {
               std::error_code none;
               return fs::exists(folder / path, none);
           });
}

std::string source_of(const SubmissionFolder& submission) { return one_line(submission.folder.filename().string()); }

bool holds_anothers_work(const SubmissionPlan& plan, const SubmissionFolder& submission,
                         const std::vector<SubmissionFolder>& all)
{
    try {
        const std::optional<Mark> mark = read_mark(plan.out.folder_of(submission.id));
        return mark && !mark->source.empty() && mark->source != source_of(submission) &&
               std::ranges::find(all, mark->source, source_of) != all.end();
    } catch (const std::exception&) {  // grading it will meet the same, and tell it
        return false;
    }
}

SubmittedFiles read_files(const SubmissionPlan& plan, const SubmissionFolder& submission)
{
    return read_submission(submission.folder, plan.exercises, archive_tools(plan.tools));
}

void put_in_order(const SubmissionPlan& plan, std::vector<Part>& parts)
{
    const auto place = [&](const Part& part) {
        return std::ranges::find(plan.course, part.unit.result.id, &Exercise::id) - plan.course.begin();
    };
    std::ranges::stable_sort(parts, {}, place);
}

Graded result_of(const SubmissionPlan& plan, const std::string& id, const std::string& shown,
                 const std::vector<Part>& parts)
{
    const std::string here = machine_digest(plan.plan.fingerprint);
    Graded graded;
    graded.result.id = id;
    if (shown != id) graded.result.folder = shown;
    for (const Part& part : parts) {
        graded.result.units.push_back(part.unit.result);
        graded.elsewhere = graded.elsewhere || part.unit.machine != here;
    }
    add_up(graded.result);
    return graded;
}

std::string reports_digest(const SubmissionPlan& plan, const SubmissionResult& result)
{
    Sha256 hash;
    hash.update_field(plan.keys.of_reports());
    hash.update_field(
        to_json(result, plan.plan.fingerprint).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    return hash.finish();
}

void add_units_of_earlier_runs(const SubmissionPlan& plan, const fs::path& folder, std::vector<Part>& parts)
{
    for (const std::string& unit : kept_units(folder)) {
        if (is_asked_for(plan, unit)) continue;
        const fs::path file = kept_unit(fault_file(folder, unit)) ? fault_file(folder, unit) : unit_file(folder, unit);
        std::optional<KeptUnit> kept = kept_unit(file);
        std::optional<UnitSections> sections = kept_sections(file);
        if (!kept || !sections)
            throw std::runtime_error(
                fmt::format("{}: the kept result is damaged; grade {} again", file.string(), unit));
        parts.push_back({*std::move(kept), *std::move(sections)});
    }
}

Graded look_at(const SubmissionPlan& plan, const SubmissionFolder& submission)
{
    Graded nothing;
    nothing.missing = plan.exercises.size();
    try {
        const fs::path folder = plan.out.folder_of(submission.id);
        const std::optional<Mark> mark = read_mark(folder);
        if (!mark) return nothing;
        const SubmittedFiles submitted = read_files(plan, submission);
        std::vector<Part> parts;
        for (const Exercise& exercise : plan.exercises)
            if (auto kept = kept_unit(unit_file(folder, exercise.id));
                kept && is_whole(folder, exercise, kept->result) &&
                kept->key == plan.keys.key(exercise, submission.id, collect(submitted, exercise)))
                parts.push_back({*std::move(kept), {}});
        const std::size_t missing = plan.exercises.size() - parts.size();
        for (const std::string& unit : kept_units(folder))
            if (auto kept = is_asked_for(plan, unit) ? std::nullopt : shown_before(folder, unit))
                parts.push_back({*std::move(kept), {}});
        put_in_order(plan, parts);
        Graded seen = result_of(plan, submission.id, submission.shown, parts);
        seen.missing = missing;
        seen.current = missing == 0 && mark->grading == plan.plan.grading &&
                       mark->reports == reports_digest(plan, seen.result) &&
                       has_reports(folder, plan.plan.instructor_edition);
        return seen;
    } catch (const std::exception&) {  // grading it will meet the same, and tell it
        return nothing;
    }
}

std::optional<Graded> results_of_earlier_run(const SubmissionPlan& plan, const std::string& id)
{
    try {
        const fs::path folder = plan.out.folder_of(id);
        const std::optional<Mark> mark = read_mark(folder);
        if (!mark || mark->reports.empty() || mark->grading != plan.plan.grading) return std::nullopt;
        std::vector<Part> parts;
        for (const std::string& unit : kept_units(folder)) {
            std::optional<KeptUnit> kept = shown_before(folder, unit);
            if (!kept) return std::nullopt;
            parts.push_back({*std::move(kept), {}});
        }
        put_in_order(plan, parts);
        return result_of(plan, id, mark->shown.empty() ? id : mark->shown, parts);
    } catch (const std::exception&) {  // damaged: it has to be graded again
        return std::nullopt;
    }
}

std::set<std::string> pictures_of(const UnitResult& unit)
{
    std::set<std::string> pictures;
    for (const CheckResult& check : unit.checks)
        for (const auto& [what, path] : check.artefacts) pictures.insert(path);
    return pictures;
}

void forget_results(const fs::path& folder)
{
    for (const std::string& unit : kept_units(folder))
        if (const auto kept = kept_unit(unit_file(folder, unit))) remove_pictures(folder, pictures_of(kept->result));
    forget_units(folder);
}

}
