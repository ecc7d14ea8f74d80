#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/application.hpp"
#include "cli/built_work.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/paths.hpp"
#include "cli/replace_process.hpp"
#include "question/log.hpp"
#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct DebugOptions {
    std::string unit;
    std::string case_name;
    std::string folder = ".";
    std::string value;
    std::optional<std::size_t> row;
    bool no_debugger = false;
};

/// The question that led to a row, and its code.
struct AskedRow {
    std::uint32_t question = 0;
    std::string code;
    std::string function;  ///< without its namespaces and class; empty if no single function was called
};

AskedRow question_of_row(const Application& application, const Exercise& exercise, const std::string& case_name,
                         std::uint64_t seed, const DebugOptions& options)
{
    Worker worker(application.tools);
    const auto check = std::ranges::find_if(exercise.checks, [&](const Check& one) {
        return one.case_name == case_name && (options.value.empty() || one.value == options.value);
    });
    if (check == exercise.checks.end())
        throw UsageError(
            fmt::format("case '{}' of {} has no check of a value '{}'", case_name, exercise.id, options.value));
    const Tensor* expected = tensor_of(worker.trusted(exercise, Answers::reference, case_name, seed), check->value);
    const std::size_t rows = expected == nullptr ? 0 : expected->cells();
    const QuestionLog& log = worker.questions(exercise, case_name, seed);
    const auto question = log.question_of(check->value, *options.row, rows);
    if (!question)
        throw UsageError(
            *options.row >= rows
                ? fmt::format("{} has {} rows, counted from 0; there is no row {}", check->name, rows, *options.row)
                : fmt::format("what led to single rows of {} is not known; without --row the whole case "
                              "runs",
                              check->name));
    const QuestionKind* kind = log.kind_of(*question);
    return {*question, worker.code_of(exercise, case_name, seed, {*question})[*question],
            kind == nullptr ? std::string() : kind->function.substr(kind->function.rfind(':') + 1)};
}

/// A command that has gdb show vectors and matrices of GLM's as their numbers: each has three names for each. A gdb
/// without Python says that it has none, and goes on.
constexpr const char* show_vectors_short = R"(python exec("""
import gdb.printing
class Vector:
    def __init__(self, value):
        self.value = value
    def to_string(self):
        size = int(self.value.type.strip_typedefs().template_argument(0))
        return '(' + ', '.join(str(self.value[name]) for name in 'xyzw'[:size]) + ')'
class Matrix:
    def __init__(self, value):
        self.value = value
    def to_string(self):
        size = int(self.value.type.strip_typedefs().template_argument(0))
        return 'columns ' + ' '.join(str(self.value['value'][column]) for column in range(size))
printers = gdb.printing.RegexpCollectionPrettyPrinter('glm')
printers.add_printer('vec', '^glm::vec<', Vector)
printers.add_printer('mat', '^glm::mat<', Matrix)
gdb.printing.register_pretty_printer(None, printers)
"""))";

/// gdb takes a command as one line.
std::string as_one_line(std::string text)
{
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\n");
    return text;
}

/// Where gdb is to stop for a student's function. By its name alone gdb also finds the jump to it in the driver, which
/// comes first and shows nothing; of several files nobody knows which one defines it.
std::string place_of(const std::string& function, const Sources& files)
{
    std::vector<std::string> sources;
    for (const auto& [name, text] : files)
        if (name.ends_with(".cpp")) sources.push_back(name);
    return sources.size() == 1 ? fmt::format("-source {} -function {}", sources.front(), function) : function;
}

void debug(const Application& application, DebugOptions options)
{
    options.folder = workspace_of({&options.unit, 1}, options.folder);
    const Exercise exercise = application.chosen({options.unit}).front();
    const std::vector<std::string> cases = exercise.cases();
    const std::string chosen = options.case_name.empty() ? cases.front() : options.case_name;
    if (std::find(cases.begin(), cases.end(), chosen) == cases.end())
        throw UsageError(fmt::format("{} has no case '{}'; it has: {}", exercise.id, chosen, fmt::join(cases, ", ")));
    // With variables and types, which graded work is built without.
    const BuiltWork work = built_work(application, exercise, options.folder, {"-g2"});

    // The inputs that `umbral check` gives these files.
    SeedPlan seeds;
    seeds.work = work_digest(work.files);
    const std::uint64_t seed = seeds.seed_of(exercise, chosen);
    const std::uint64_t stream = stream_of(exercise, chosen, seed);
    const fs::path own = fs::path(options.folder) / exercise.id;
    std::error_code unknown;
    const fs::path sources = fs::is_directory(own, unknown) ? own : fs::path(options.folder);
    std::optional<AskedRow> asked;
    if (options.row) asked = question_of_row(application, exercise, chosen, seed, options);
    std::vector<std::string> words;
    if (!options.no_debugger) {
        words = {"gdb", "-q"};
        std::vector<std::string> commands = {"set breakpoint pending on", as_one_line(show_vectors_short)};
        // Files may also lie beside those of the topic's other units, or by themselves.
        for (const fs::path& from : {fs::path(options.folder), own.parent_path(), own})
            if (fs::is_directory(from, unknown)) commands.push_back("directory " + fs::absolute(from).string());
        // The first call from there on is the one that was asked.
        if (asked && !asked->function.empty())
            commands.insert(commands.end(),
                            {"break umbral::question_reached", "run", "tbreak " + place_of(asked->function, work.files),
                             "continue", "info args"});
        else if (asked)
            commands.insert(commands.end(), {"break umbral::question_reached", "run"});
        else
            commands.emplace_back("run");
        for (std::string& command : commands) words.insert(words.end(), {"-ex", std::move(command)});
        words.emplace_back("--args");
    }
    words.push_back(have_program(application, exercise.gl ? "umbral-debug-gl" : "umbral-debug").string());
    for (const std::string& word :
         {(unit_folder(application.tools, exercise.id) / "driver.so").string(), work.built.library.string(), chosen,
          std::to_string(stream), fs::absolute(sources).string()})
        words.push_back(word);
    if (asked) {
        words.push_back(std::to_string(asked->question));
        fmt::print("{}\n", asked->code);
        (void)std::fflush(stdout);
    }
    replace_process(std::move(words), "is it installed? --no-debugger does without");
}

}

void add_debug(Command command, Application& application)
{
    auto options = std::make_shared<DebugOptions>();
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("CASE", options->case_name, "Which case; the first if not given");
    command.option("--dir", options->folder, "The workspace").with_default();
    command.option("--row", options->row, "Stop where this row is asked for");
    command.option("--value", options->value, "Of which recorded value; that of the case's first check if not given");
    command.flag("--no-debugger", options->no_debugger, "Run it alone");
    command.runs([&application, options] { debug(application, *options); });
}

}
