#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <sstream>

#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/built_work.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "model/one_cpp_file.hpp"
#include "mutants/repair_words.hpp"
#include "mutants/try_repairs.hpp"
#include "report/layout.hpp"
#include "report/next_steps.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

struct LocateOptions {
    std::string unit;
    std::string folder = ".";
    bool show = false;
    unsigned attempt = 0;
    unsigned seconds = 60;
    std::size_t jobs = default_jobs();
};

/// So many places are shown.
constexpr std::size_t most_places = 3;

/// The line of a change, with the line before it, and the changed part underlined.
std::string excerpt(const Paint& paint, const std::string& source, const Mutant& change)
{
    const std::size_t line_begin = change.begin == 0 ? 0 : source.rfind('\n', change.begin - 1) + 1;
    const std::size_t line_end = std::min(source.find('\n', change.begin), source.size());
    std::string text;
    if (line_begin > 0) {
        const std::size_t before = line_begin < 2 ? 0 : source.rfind('\n', line_begin - 2) + 1;
        text += fmt::format("{:5} | {}\n", change.line - 1, paint.safe(source.substr(before, line_begin - 1 - before)));
    }
    text += fmt::format("{:5} | {}\n", change.line, paint.safe(source.substr(line_begin, line_end - line_begin)));
    // As wide as what is shown.
    const auto width = [&](std::size_t begin, std::size_t end) {
        return static_cast<std::size_t>(display_width(paint.safe(source.substr(begin, end - begin))));
    };
    const std::size_t length = std::max<std::size_t>(width(change.begin, std::min(change.end, line_end)), 1);
    return text + fmt::format("{:5} | {}{}\n", "", std::string(width(line_begin, change.begin), ' '),
                              paint(Tone::bad, std::string(length, '^')));
}

void print_repair(const Paint& paint, const std::string& file, const std::string& source, const Repair& repair,
                  std::size_t wrong, bool show)
{
    const std::string mends =
        repair.mends.size() == wrong
            ? (wrong == 1 ? std::string("the wrong check") : fmt::format("all {} wrong checks", wrong))
            : fmt::format("{} of {} wrong checks", repair.mends.size(), wrong);
    fmt::print("{}: a small change here makes {} right.\n\n",
               paint.safe(fmt::format("{}:{}", file, repair.change.line)), mends);
    fmt::print("{}\n", excerpt(paint, source, repair.change));
    fmt::print("{}\n", words_of_repair(repair.change));
    if (show) fmt::print("{}\n", paint.safe(fmt::format("The change: {}", repair.change.change)));
    fmt::print("\n");
}

/// Where no place was found: what follows from that, if all `changes` were tried. `debug` is the command that goes on.
void print_no_place(const std::string& debug, const RepairSearch& search, std::size_t changes)
{
    const std::size_t tried = search.tried;
    if (tried == changes && search.out_of_time)
        fmt::print(
            "None of the {} small changes makes the wrong checks right that it was tried on; there was no time to try "
            "all of them on all; --seconds gives more time.\n",
            tried);
    else if (tried < changes)
        fmt::print(
            "None of the {} small changes that there was time for makes a wrong check right and breaks none; --seconds "
            "gives more time.\n",
            tried);
    else
        fmt::print(
            "None of the {} small changes of one place that are tried makes a wrong check right: it takes another one, "
            "or more than one.\n",
            tried);
    fmt::print("`{}` runs a case of it under gdb.\n", debug);
}

void print_search(const Paint& paint, const std::string& debug, const BuiltWork& work, const RepairSearch& search,
                  std::size_t changes, bool show)
{
    const auto& [file, source] = *work.files.begin();
    const std::size_t shown = std::min(search.repairs.size(), most_places);
    for (std::size_t i = 0; i < shown; ++i)
        print_repair(paint, file, source, search.repairs[i], search.wrong.size(), show);
    if (search.repairs.empty()) print_no_place(debug, search, changes);
    if (search.repairs.size() > 1) {
        const bool is_enough = search.repairs.front().mends.size() == search.wrong.size();
        fmt::print("{}; {} places were found.\n",
                   is_enough ? "One of these changes is enough" : "Each of these changes mends the same checks",
                   search.repairs.size());
    }
    if (shown > 0 && !show) fmt::print("--show says which change.\n");
}

/// The student's file with every change that is tried.
BuiltMutants changed_ways(const Toolchain& tools, const Exercise& exercise, const std::filesystem::path& finder,
                          const BuiltWork& work, const std::string& debug, const std::filesystem::path& folder,
                          double seconds)
{
    try {
        return build_mutants(tools, exercise, MutantFamily::repairs, finder, work.files.begin()->second, folder,
                             seconds);
    } catch (const NotMutable& error) {
        throw UsageError(
            fmt::format("no changes of your file can be tried, which is too long or nested too deep for that: "
                        "{}\n`{}` runs a case of it under gdb",
                        error.what(), debug));
    }
}

void locate(Application& application, LocateOptions options)
{
    options.folder = workspace_of({&options.unit, 1}, options.folder);
    const Exercise exercise = application.chosen({options.unit}).front();
    if (!is_one_cpp_file(exercise))
        throw UsageError(fmt::format("{} is not one C++ file: umbral debug runs a case of it", exercise.id));
    const BuiltWork work = built_work(application, exercise, options.folder);
    const std::string debug = fmt::format("umbral debug {}{}", exercise.name, folder_option(options.folder));
    if (equals_stub(work.files, exercise)) {
        fmt::print("{} is the stub as it was: there is nothing to look for yet.\n", exercise.id);
        application.exit_status = exit_not_right;
        return;
    }
    const std::filesystem::path finder = have_finder(application, "locate finds changes");
    const auto began = std::chrono::steady_clock::now();
    const ScratchFolder scratch(application.tools.cache);
    const BuiltMutants built = changed_ways(application.tools, exercise, finder, work, debug, scratch.path(),
                                            static_cast<double>(options.seconds));
    Crew crew(application.tools, options.jobs);
    const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(); };
    const RepairSearch search =
        try_repairs(crew, exercise, built, {static_cast<double>(options.seconds) - passed(), options.attempt});
    if (search.wrong.empty()) {
        fmt::print("Nothing is wrong in {}: there is nothing to look for.\n", exercise.id);
        return;
    }
    application.exit_status = exit_not_right;
    const double seconds = passed();
    const Paint paint(application.style);
    print_search(paint, debug, work, search, built.mutants.size(), options.show);
    fmt::print("{}\n", paint(Tone::quiet, fmt::format("{} of {} changes tried on inputs of two seeds, {:.0f} s",
                                                      search.tried, built.mutants.size(), seconds)));
}

}

void add_locate(Command command, Application& application)
{
    auto options = std::make_shared<LocateOptions>();
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("--dir", options->folder, "The workspace").with_default();
    command.flag("--show", options->show, "Also says which change");
    command.option("--attempt", options->attempt, "The number that `umbral check` had").with_default();
    command.option("--seconds", options->seconds, "Look no longer than this").between(1, 3600).with_default();
    command.option("--jobs", options->jobs, "Changes tried at a time").between(1, most_jobs).with_default();
    command.runs([&application, options] { locate(application, *options); });
}

}
