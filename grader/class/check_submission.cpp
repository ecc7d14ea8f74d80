#include "class/check_submission.hpp"

#include <algorithm>
#include <memory>
#include <system_error>

#include "build/build_cache.hpp"
#include "model/digest.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "store/kept_unit.hpp"
#include "store/report_folder.hpp"
#include "unit/grade_unit.hpp"
#include "worker/fingerprint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Results take some kilobytes a unit, pages some hundred.
constexpr std::uintmax_t most_kept = std::uintmax_t{128} << 20U;

/// Of 46 units, the runs of references and oracles take 41 MiB; those of mistakes come as they are needed.
constexpr std::uintmax_t most_runs = std::uintmax_t{512} << 20U;

/// Where the last results of a workspace lie.
fs::path kept_folder(const Toolchain& tools, const fs::path& workspace)
{
    return entry_of(checks_folder(tools.cache), sha256_hex(workspace.string()));
}

bool has_its_pictures(const UnitResult& unit, const fs::path& workspace)
{
    for (const CheckResult& check : unit.checks)
        for (const auto& [what, path] : check.artefacts)
            if (!fs::exists(workspace / path)) return false;
    return true;
}

/// Part of what decides a result that UnitKeys does not know: a page has more than a result.
std::string key_of(const UnitKeys& keys, const Exercise& exercise, const Handed& handed, const CheckPlan& plan)
{
    return keys.key(exercise, plan.pages ? "check with a page" : "check", handed);
}

/// A unit as it was checked last, if it would come out the same.
struct Last {
    KeptUnit unit;
    std::string section;
};
std::optional<Last> last_check(const fs::path& file, const std::string& key, const CheckPlan& plan,
                               const fs::path& workspace)
{
    if (plan.fresh) return std::nullopt;
    std::optional<KeptUnit> unit = kept_unit(file);
    if (!unit || unit->key != key || !has_its_pictures(unit->result, workspace)) return std::nullopt;
    if (!plan.pages) return Last{*std::move(unit), ""};
    std::optional<UnitSections> sections = kept_sections(file);
    if (!sections) return std::nullopt;
    return Last{*std::move(unit), std::move(sections->student)};
}

/// Keeping is for speed alone: a cache that cannot be written costs nobody a check.
void try_to_keep(const fs::path& file, const KeptUnit& unit, const std::string& section)
try {
    fs::create_directories(file.parent_path());
    if (unit.key.empty())
        fs::remove(file);
    else
        keep_unit(file, unit, {section, ""});
} catch (const std::exception&) {
    std::error_code ignored;
    fs::remove(file, ignored);
}

/// What a unit became, and its section of the page.
struct CheckedUnit {
    UnitResult result;
    std::string section;
    bool kept = false;
};

CheckedUnit check_unit(Worker& worker, const Exercise& exercise, const Handed& handed, const CheckPlan& plan,
                       const fs::path& workspace, const SubmissionBudgets& budgets)
{
    GradeOptions options;
    options.budgets = budgets;
    options.seeds.attempt = plan.attempt;
    options.explain = plan.explain;
    options.relative_to = workspace;
    options.artefacts = workspace / "umbral-pictures";
    if (!plan.pages) return {grade_unit(worker, exercise, handed, options), ""};
    auto [result, detail] = grade_with_evidence(worker, exercise, handed, options);
    std::string section = html::section_html(result, detail, html::Edition::student);
    return {std::move(result), std::move(section)};
}

/// The keys of what is kept of checks made on this machine.
std::shared_ptr<const UnitKeys> keys_of_checks(Crew& crew, const std::vector<Exercise>& exercises,
                                               const CheckPlan& plan, const Fingerprint& machine)
{
    KeyPlan key_plan{machine, {}, plan.explain, false};
    key_plan.grading.attempt = plan.attempt;
    return std::make_shared<const UnitKeys>(crew.first().tools(), exercises, key_plan);
}

}

void keep_runs_as_checks_do(Crew& crew, const std::vector<Exercise>& exercises)
{
    crew.keep_runs(keys_of_checks(crew, exercises, {}, fingerprint(crew.first(), exercises)));
}

Checked check_submission(Crew& crew, const std::vector<Exercise>& exercises, const CheckPlan& plan)
{
    const fs::path workspace = fs::absolute(plan.folder).lexically_normal();
    const Toolchain& tools = crew.first().tools();
    Checked checked;
    checked.fingerprint = fingerprint(crew.first(), exercises);
    const auto keys = keys_of_checks(crew, exercises, plan, checked.fingerprint);
    const SubmittedFiles submitted = read_submission(plan.folder, exercises, archive_tools(tools));
    const fs::path folder = kept_folder(tools, workspace);
    if (!plan.fresh) crew.keep_runs(keys);

    std::vector<CheckedUnit> parts(exercises.size());
    const SubmissionBudgets budgets = budgets_of_a_submission();
    crew.share_out(exercises.size(), [&](Worker& worker, std::size_t i) {
        const Exercise& exercise = exercises[i];
        const Handed handed = collect(submitted, exercise);
        const std::string key = key_of(*keys, exercise, handed, plan);
        const fs::path file = unit_file(folder, exercise.id);
        if (std::optional<Last> last = last_check(file, key, plan, workspace)) {
            parts[i] = {std::move(last->unit.result), std::move(last->section), true};
            return;
        }
        parts[i] = check_unit(worker, exercise, handed, plan, workspace, budgets);
        const UnitResult& result = parts[i].result;
        mark_used(entry_of(runs_folder(tools.cache), keys->of_unit(exercise)));
        const bool lasting = result.settled && result.verdict != Verdict::grader_fault;
        try_to_keep(file, {lasting ? key : "", machine_digest(checked.fingerprint), result}, parts[i].section);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        checked.kept += parts[i].kept ? 1 : 0;
        checked.result.units.push_back(std::move(parts[i].result));
        if (plan.pages) checked.sections.push_back(std::move(parts[i].section));
    }
    mark_used(folder);
    if (checked.kept < parts.size()) {
        prune_entries(checks_folder(tools.cache), most_kept);
        prune_entries(runs_folder(tools.cache), most_runs);
    }
    add_up(checked.result);
    checked.result = without_hidden_values(std::move(checked.result));
    return checked;
}

}
