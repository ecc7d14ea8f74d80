#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "batch/fingerprint.hpp"
#include "batch/grade_class.hpp"
#include "cli/application.hpp"
#include "cli/paths.hpp"
#include "cli/watch.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> units;
    std::string folder = ".";
    bool json = false;
    bool no_explanation = false;
    bool watch = false;
    std::string html;
    unsigned attempt = 0;
};

/// The units to check: those named, or those that the workspace holds.
std::vector<Exercise> units_to_check(const Application& application, const Options& options)
{
    if (!options.units.empty()) return application.chosen(options.units);
    std::vector<Exercise> chosen = application.readable();
    const SubmittedFiles submitted = read_submission(options.folder, archive_tools(application.tools));
    std::erase_if(chosen, [&](const Exercise& exercise) { return collect(submitted, exercise).nothing(); });
    if (chosen.empty())
        throw UsageError(fmt::format("{} holds no unit's files; `umbral new DIR` makes a workspace, then check there or with --dir DIR",
                                     fs::absolute(options.folder).string()));
    return chosen;
}

/// One pass over some units, printed. Says how it went by an exit status.
int check_once(Application& application, Workshop& workshop, const std::vector<Exercise>& exercises, const Options& options)
{
    GradeOptions grading;
    grading.seeds.attempt = options.attempt;
    grading.explain = !options.no_explanation;
    grading.relative_to = fs::absolute(options.folder);
    grading.artefacts = grading.relative_to / "umbral-pictures";
    html::Gallery gallery;
    if (!options.html.empty()) grading.gallery = &gallery;
    SubmissionResult result = without_hidden_values(grade_submission(workshop, exercises, options.folder, grading));
    if (!options.html.empty()) {
        result.id = fs::absolute(options.folder).lexically_normal().filename().string();
        write_output(options.html, html::report_html(result, fingerprint(workshop, exercises), gallery));
    }
    // While watching, a line is a document, so that a program can read them one by one.
    const int indentation = options.watch ? -1 : 2;
    if (options.json)
        fmt::print("{}\n", to_json(result, fingerprint(workshop, exercises)).dump(indentation, ' ', false, nlohmann::json::error_handler_t::replace));
    else
        fmt::print("{}", terminal_report(result, application.style));

    const auto is = [](Verdict verdict) { return [verdict](const UnitResult& unit) { return unit.verdict == verdict; }; };
    if (std::any_of(result.units.begin(), result.units.end(), is(Verdict::grader_fault))) return exit_fault;
    return std::all_of(result.units.begin(), result.units.end(), is(Verdict::ok)) ? exit_ok : exit_not_right;
}

/// What the student has written for each unit, by the unit's id.
std::map<std::string, Sources> texts_of_units(const std::vector<Exercise>& exercises, const fs::path& folder)
{
    std::map<std::string, Sources> texts;
    const SubmittedFiles submitted = read_submission(folder);
    for (const Exercise& exercise : exercises) texts[exercise.id] = collect(submitted, exercise).files;
    return texts;
}

std::vector<fs::path> folders_of(const std::vector<Exercise>& exercises, const fs::path& root)
{
    std::vector<fs::path> folders{root};
    for (const Exercise& exercise : exercises) folders.insert(folders.end(), {root / exercise.topic, root / exercise.topic / exercise.name});
    return folders;
}

/// Checks again what is saved, until the program is stopped. The spawners stay warm and the reference's runs are remembered, so that
/// little more than the compiler's time lies between a save and its verdict.
[[noreturn]] void watch(Application& application, Workshop& workshop, const std::vector<Exercise>& exercises, const Options& options)
{
    constexpr std::chrono::milliseconds quiet{15};
    FolderWatch saves;
    saves.watch(folders_of(exercises, options.folder));
    // A save during the first pass is seen too: watching began before the texts are read.
    std::map<std::string, Sources> known = texts_of_units(exercises, options.folder);
    (void)check_once(application, workshop, exercises, options);
    const auto say = [&](const std::string& text) {
        if (!options.json) fmt::print("\n  {}\n", text);
        (void)std::fflush(stdout);
    };
    say("Watching: save a file to check it again; Ctrl+C ends.");
    while (true) {
        const auto saved = saves.wait(quiet);
        saves.watch(folders_of(exercises, options.folder));
        std::map<std::string, Sources> now = texts_of_units(exercises, options.folder);
        std::vector<Exercise> changed;
        for (const Exercise& exercise : exercises)
            if (now.at(exercise.id) != known.at(exercise.id)) changed.push_back(exercise);
        known = std::move(now);
        if (changed.empty()) continue;
        if (!options.json && isatty(STDOUT_FILENO) != 0) fmt::print("\x1b[2J\x1b[H");
        (void)check_once(application, workshop, changed, options);
        say(fmt::format("{:.2f} s after the save. Watching; Ctrl+C ends.", std::chrono::duration<double>(std::chrono::steady_clock::now() - saved).count()));
    }
}

void check(Application& application, const Options& options)
{
    expect_folder(options.folder, "a workspace");
    expect_writable(options.html);
    const std::vector<Exercise> exercises = units_to_check(application, options);
    Workshop workshop(application.tools);
    if (options.watch) watch(application, workshop, exercises, options);
    application.exit_status = check_once(application, workshop, exercises, options);
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
    command->add_option("--html", options->html, "Also writes the report as one page that opens in any browser, without a network");
    command->add_flag("--watch", options->watch, "Checks again whatever you save, until you press Ctrl+C; with --json, one line a check");
    command->add_flag("--no-explanation", options->no_explanation, "Only points");
    command->callback([&application, options] { check(application, *options); });
}

}
