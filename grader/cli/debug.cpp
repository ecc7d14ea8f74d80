#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "batch/grade_unit.hpp"
#include "build/builder.hpp"
#include "cli/application.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/paths.hpp"
#include "cli/replace_process.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string unit;
    std::string case_name;
    std::string folder = ".";
    bool no_debugger = false;
};

void debug(const Application& application, const Options& options)
{
    const Exercise exercise = application.chosen({options.unit}).front();
    const std::vector<std::string> cases = exercise.cases();
    const std::string chosen = options.case_name.empty() ? cases.front() : options.case_name;
    if (std::find(cases.begin(), cases.end(), chosen) == cases.end())
        throw UsageError(fmt::format("{} has no case '{}'; it has: {}", exercise.id, chosen, fmt::join(cases, ", ")));
    expect_folder(options.folder, "a workspace");
    const Handed handed =
        collect(read_submission(options.folder, {&exercise, 1}, archive_tools(application.tools)), exercise);
    if (!handed.refused.empty()) throw UsageError(fmt::format("not read in {}: {}", options.folder, handed.refused));
    if (!handed.missing.empty())
        throw UsageError(fmt::format("not found in {}: {}", options.folder, fmt::join(handed.missing, ", ")));
    have_built(application, {&exercise, 1});
    const Built built = build(application.tools, exercise, handed.files);
    if (built.verdict != Verdict::ok) throw UsageError(fmt::format("{}:\n{}", in_words(built.verdict), built.message));

    // The inputs that `umbral check` gives these files.
    SeedPlan seeds;
    seeds.work = work_digest(handed.files);
    const std::uint64_t stream = stream_of(exercise, chosen, seeds.seed_of(exercise, chosen));
    const fs::path own = fs::path(options.folder) / exercise.id;
    const fs::path sources = fs::is_directory(own) ? own : fs::path(options.folder);
    std::vector<std::string> words;
    if (!options.no_debugger)
        words = {
            "gdb", "-q",  "-ex",   "set breakpoint pending on", "-ex", "directory " + fs::absolute(sources).string(),
            "-ex", "run", "--args"};
    words.push_back((application.tools.programs / (exercise.gl ? "umbral-debug-gl" : "umbral-debug")).string());
    for (const std::string& word :
         {(unit_folder(application.tools, exercise.id) / "driver.so").string(), built.library.string(), chosen,
          std::to_string(stream), fs::absolute(sources).string()})
        words.push_back(word);
    replace_process(std::move(words), "is it installed? --no-debugger does without");
}

}

void add_debug(Command parser, Application& application)
{
    auto options = std::make_shared<Options>();
    const Command command =
        parser.command("debug", "Runs one case under gdb: an ordinary program, without sandbox and limits");
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("CASE", options->case_name, "Which case; the first if not given");
    command.option("--dir", options->folder, "The workspace").with_default();
    command.flag("--no-debugger", options->no_debugger, "Run it alone");
    command.runs([&application, options] { debug(application, *options); });
}

}
