#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "class/check_submission.hpp"
#include "cli/application.hpp"
#include "cli/check_file.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/paths.hpp"
#include "cli/watch.hpp"
#include "model/one_cpp_file.hpp"
#include "report/html/pages.hpp"
#include "report/next_steps.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    std::vector<std::string> units;
    std::string folder = ".";
    bool json = false;
    bool no_explanation = false;
    bool watch = false;
    bool fresh = false;
    std::size_t jobs = default_jobs();
    std::string html;
    unsigned attempt = 0;
    std::string file;
};

/// The units to check: those named, or those that the workspace holds.
std::vector<Exercise> units_to_check(const Application& application, const CheckOptions& options)
{
    if (!options.units.empty()) return application.chosen(options.units);
    std::vector<Exercise> chosen = application.readable();
    const SubmittedFiles submitted = read_submission(options.folder, chosen, archive_tools(application.tools));
    std::erase_if(chosen, [&](const Exercise& exercise) { return collect(submitted, exercise).nothing(); });
    if (chosen.empty())
        throw UsageError(fmt::format(
            "{} holds no unit's files; `umbral new DIR` makes a workspace, then check there or with --dir DIR",
            fs::absolute(options.folder).string()));
    return chosen;
}

/// For units with something wrong that nothing explains: how its place can be found. Packages cannot.
std::string how_to_locate(const Application& application, const std::vector<Exercise>& exercises,
                          const SubmissionResult& result, const std::string& folder)
{
    std::string text;
    if (!may_have_finder(application)) return text;
    for (const UnitResult& unit : result.units) {
        const auto exercise = std::ranges::find(exercises, unit.id, &Exercise::id);
        const bool wrong = unit.verdict == Verdict::partial || unit.verdict == Verdict::wrong;
        if (wrong && unit.explanations.empty() && exercise != exercises.end() && is_one_cpp_file(*exercise))
            text += fmt::format("`umbral locate {}{}` looks for the line of your file that is wrong.\n", exercise->name,
                                folder_option(folder));
    }
    return text.empty() ? text : "\n" + text;
}

/// One pass over some units, printed. Says how it went by an exit status.
int check_once(Application& application, Crew& crew, const std::vector<Exercise>& exercises,
               const CheckOptions& options)
{
    const Checked checked = check_submission(
        crew, exercises,
        {options.folder, options.attempt, !options.no_explanation, !options.html.empty(), options.fresh});
    SubmissionResult result = checked.result;
    if (!options.html.empty()) {
        result.id = fs::absolute(options.folder).lexically_normal().filename().string();
        html::ReportOptions page;
        page.titles = english_titles(exercises);
        write_output(options.html, html::report_from_sections(result, checked.fingerprint, checked.sections, page));
    }
    // While watching, a line is a document, so that a program can read them one by one.
    const int indentation = options.watch ? -1 : 2;
    if (options.json) {
        fmt::print("{}\n", to_json(result, checked.fingerprint)
                               .dump(indentation, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        TerminalStyle style = application.style;
        style.folder = options.folder;
        fmt::print("{}{}", terminal_report(result, style),
                   how_to_locate(application, exercises, result, options.folder));
        if (checked.kept > 0 && !options.watch)
            fmt::print("\n{} of {} unit{} unchanged since the last check, and not run again (--fresh runs all).\n",
                       checked.kept, exercises.size(), exercises.size() == 1 ? "" : "s");
    }

    const auto is = [](Verdict verdict) {
        return [verdict](const UnitResult& unit) { return unit.verdict == verdict; };
    };
    if (std::any_of(result.units.begin(), result.units.end(), is(Verdict::grader_fault))) return exit_fault;
    return std::all_of(result.units.begin(), result.units.end(), is(Verdict::ok)) ? exit_ok : exit_not_right;
}

/// What the student has written for each unit, by the unit's id.
std::map<std::string, Sources> texts_of_units(const std::vector<Exercise>& exercises, const fs::path& folder)
{
    std::map<std::string, Sources> texts;
    const SubmittedFiles submitted = read_submission(folder, exercises);
    for (const Exercise& exercise : exercises) texts[exercise.id] = collect(submitted, exercise).files;
    return texts;
}

/// Builds what the units are graded with: known mistakes, which explain what is wrong, only of those that hold more
/// than the stub, for a workspace holds a hundred others.
void build_for(const Application& application, const std::vector<Exercise>& exercises,
               const std::map<std::string, Sources>& texts)
{
    std::vector<Exercise> untouched;
    std::vector<Exercise> begun;
    for (const Exercise& exercise : exercises)
        (equals_stub(texts.at(exercise.id), exercise) ? untouched : begun).push_back(exercise);
    have_built(application, begun);
    have_built(application, untouched, UnitParts::answers);
}

std::vector<fs::path> folders_of(const std::vector<Exercise>& exercises, const fs::path& root)
{
    std::vector<fs::path> folders{root};
    for (const Exercise& exercise : exercises)
        folders.insert(folders.end(), {root / exercise.topic, root / exercise.topic / exercise.name});
    return folders;
}

/// Checks again what is saved, until the program is stopped. The spawners stay warm and the reference's runs are
/// remembered, so that little more than the compiler's time lies between a save and its verdict.
[[noreturn]] void watch(Application& application, Crew& crew, const std::vector<Exercise>& exercises,
                        const CheckOptions& options)
{
    constexpr std::chrono::milliseconds quiet{15};
    FolderWatch saves;
    saves.watch(folders_of(exercises, options.folder));
    // A save during the first pass is seen too: watching began before the texts are read.
    std::map<std::string, Sources> known = texts_of_units(exercises, options.folder);
    (void)check_once(application, crew, exercises, options);
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
        build_for(application, changed, known);
        if (!options.json && isatty(STDOUT_FILENO) != 0) fmt::print("\x1b[2J\x1b[H");
        (void)check_once(application, crew, changed, options);
        say(fmt::format("{:.2f} s after the save. Watching; Ctrl+C ends.",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - saved).count()));
    }
}

void check(Application& application, CheckOptions options)
{
    options.folder = workspace_of(options.units, options.folder);
    expect_folder(options.folder, "a workspace");
    if (!options.file.empty()) {
        if (options.units.size() != 1 || options.watch || options.json || !options.html.empty())
            throw UsageError("--file goes with one UNIT, and without --watch, --json and --html");
        application.exit_status =
            check_file(application, application.chosen(options.units).front(), options.folder, options.file);
        return;
    }
    expect_writable(options.html);
    const std::vector<Exercise> exercises = units_to_check(application, options);
    build_for(application, exercises, texts_of_units(exercises, options.folder));
    Crew crew(application.tools, options.jobs);
    if (options.watch) watch(application, crew, exercises, options);
    application.exit_status = check_once(application, crew, exercises, options);
}

}

void add_check(Command command, Application& application)
{
    auto options = std::make_shared<CheckOptions>();
    command.option("UNIT", options->units, "Only these units, as raytracing/sphere or sphere");
    command.option("--dir", options->folder, "The workspace").with_default();
    command.option("--file", options->file,
                   "Instead of the checks: what your code and the reference make of this file, for a unit that reads "
                   "files");
    command.option("--attempt", options->attempt, "Another number gives other random inputs").with_default();
    command.flag("--json", options->json, "As JSON (docs/schemas/report.schema.json)");
    command.option("--html", options->html,
                   "Also writes the report as one page that opens in any browser, without a network");
    command.flag("--watch", options->watch,
                 "Checks again whatever you save, until you press Ctrl+C; with --json, one line a check");
    command.flag("--fresh", options->fresh, "Run everything again, also what has not changed since the last check");
    command.option("--jobs", options->jobs, "Units at a time").between(1, most_jobs).with_default();
    command.flag("--no-explanation", options->no_explanation, "Only points");
    command.runs([&application, options] { check(application, *options); });
}

}
