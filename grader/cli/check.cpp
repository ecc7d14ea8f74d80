#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "batch/fingerprint.hpp"
#include "batch/grade_class.hpp"
#include "cli/application.hpp"
#include "report/hidden.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> units;
    std::string folder = ".";
    bool json = false;
    bool no_explanation = false;
    unsigned attempt = 0;
};

/// The units to check: those named, or those that the workspace holds.
std::vector<Exercise> units_to_check(const Application& application, const Options& options)
{
    std::vector<Exercise> chosen = application.chosen(options.units);
    if (!options.units.empty()) return chosen;
    std::erase_if(chosen, [&](const Exercise& exercise) { return collect(options.folder, exercise).files.empty(); });
    if (chosen.empty())
        throw UsageError(fmt::format("{} holds no unit's files; `umbral new DIR` makes a workspace, then check there or with --dir DIR",
                                     fs::absolute(options.folder).string()));
    return chosen;
}

void check(Application& application, const Options& options)
{
    if (!fs::is_directory(options.folder)) throw UsageError(fmt::format("{}: expected a workspace folder; there is none", options.folder));
    Workshop workshop(application.tools);
    const std::vector<Exercise> exercises = units_to_check(application, options);
    GradeOptions grading;
    grading.seeds.attempt = options.attempt;
    grading.explain = !options.no_explanation;
    grading.relative_to = fs::absolute(options.folder);
    grading.artefacts = grading.relative_to / "umbral-pictures";
    const SubmissionResult result = without_hidden_values(grade_submission(workshop, exercises, options.folder, grading));
    if (options.json)
        fmt::print("{}\n", to_json(result, fingerprint(workshop, exercises)).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    else
        fmt::print("{}", terminal_report(result, application.style));

    const auto is = [](Verdict verdict) { return [verdict](const UnitResult& unit) { return unit.verdict == verdict; }; };
    if (std::any_of(result.units.begin(), result.units.end(), is(Verdict::grader_fault)))
        application.exit_status = exit_fault;
    else if (!std::all_of(result.units.begin(), result.units.end(), is(Verdict::ok)))
        application.exit_status = exit_not_right;
}

}

void add_check(CLI::App& parser, Application& application)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = parser.add_subcommand("check", "Checks your units against the reference, here and offline");
    command->add_option("UNIT", options->units, "Only these units, as raytracing/sphere or sphere");
    command->add_option("--dir", options->folder, "The workspace")->capture_default_str();
    command->add_option("--attempt", options->attempt, "Another number gives other random inputs")->capture_default_str();
    command->add_flag("--json", options->json, "As JSON (docs/schemas/report.schema.json)");
    command->add_flag("--no-explanation", options->no_explanation, "Only points");
    command->callback([&application, options] { check(application, *options); });
}

}
