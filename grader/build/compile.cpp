#include "build/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "build/assembler_text.hpp"
#include "build/compiler_files.hpp"
#include "build/compiler_text.hpp"
#include "build/counted.hpp"
#include "build/machine_trouble.hpp"
#include "build/padding_fault.hpp"
#include "build/source_scan.hpp"
#include "build/student_header.hpp"
#include "model/caps.hpp"
#include "model/recording.hpp"
#include "run/confine.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Of the compiler's processes so many may take all the time that each may.
constexpr double most_processes = 4;
/// So many times as long as it computes may it take: a loaded machine is nobody's fault.
constexpr double busy_machine = 4;

/// Why files were not compiled for which no time was left: for the student.
std::string no_time_to_compile()
{
    return fmt::format(
        "not compiled since compiling takes too long: each unit may take {:g} s of processor time, and all units of a "
        "submission together {:g} s more, which are used up\n",
        caps::compile_seconds, caps::shared_compile_seconds);
}

/// Runs the compiler, and counts what it took. One that was stopped for that has taken all that it might, one that
/// waited without end the time for which it was let wait.
ConfinedResult run_compiler(const Toolchain& tools, const ConfinedCommand& command)
{
    using Stopped = ConfinedResult::Stopped;
    ConfinedResult result = run_confined(command);
    double taken = result.cpu_seconds;
    if (result.stopped == Stopped::out_of_processor_time) taken = std::max(taken, command.cpu_seconds);
    if (result.stopped == Stopped::out_of_wall_time) taken = std::max(taken, result.wall_seconds / busy_machine);
    if (tools.budget) tools.budget->take(taken);
    return result;
}

/// The compiler on the student's files, up to what it is to do with them.
ConfinedCommand compiler_command(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                                 const fs::path& work, const std::vector<std::string>& task)
{
    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.directory = work;
    const double left = tools.budget ? tools.budget->left() : std::numeric_limits<double>::infinity();
    command.cpu_seconds = std::min(left, tools.compile_seconds);
    command.all_cpu_seconds = std::min(left, most_processes * tools.compile_seconds);
    command.wall_seconds = busy_machine * command.all_cpu_seconds;
    command.disk_limit = caps::build_folder;
    command.read = compiler_files(tools.compiler);
    // Without it, compilers take the system's.
    const fs::path assembler = tools.programs / "assembler" / "as";
    if (!fs::exists(assembler)) throw std::runtime_error(fmt::format("{} is missing", assembler.string()));
    // Of the unit only the version script: beside it lie the libraries with the answers.
    for (const fs::path& path : {assembler, tools.framework, tools.student_header.parent_path(),
                                 unit_folder(tools, exercise.id) / "exports.map"})
        command.read.push_back(path.string());
    command.arguments = {tools.compiler, "-B" + assembler.parent_path().string()};
    command.arguments.insert(command.arguments.end(), tools.flags.begin(), tools.flags.end());
    if (exercise.counts_work) command.arguments.emplace_back("-fsanitize-coverage=trace-pc");
    for (const std::string& word : {std::string("-fdiagnostics-color=never"), std::string("-fmax-errors=5"),
                                    "-ffile-prefix-map=" + work.string() + "=."})
        command.arguments.push_back(word);
    const std::vector<std::string> headers = read_first(tools, exercise);
    command.arguments.insert(command.arguments.end(), headers.begin(), headers.end());
    command.arguments.insert(command.arguments.end(), task.begin(), task.end());
    // With a folder before it, no name can be taken for an option.
    for (const auto& [name, text] : files)
        if (name.ends_with(".cpp")) command.arguments.push_back("./" + name);
    return command;
}

using Outcome = Compilation::Outcome;
using Stopped = ConfinedResult::Stopped;

/// Is so little time left that no compiler gets anywhere with it?
bool has_no_time(const Toolchain& tools)
{
    constexpr double least = 0.1;
    return tools.budget && tools.budget->left() < least;
}

/// By what the clock says, or by the compiler's word about a process of its own.
bool ran_out_of_processor_time(const Toolchain& tools, const ConfinedResult& result)
{
    return result.stopped == Stopped::out_of_processor_time ||
           tells_of_processor_time(result.output, fs::path(tools.compiler).filename().string());
}

/// Was the compiler given less than it may take at most, which is all that is left?
bool was_given_the_rest(const Toolchain& tools, const ConfinedCommand& command)
{
    return command.cpu_seconds < tools.compile_seconds;
}

/// Why the compiler was stopped for the time that it took.
std::string out_of_time(const Toolchain& tools, const ConfinedCommand& command)
{
    return was_given_the_rest(tools, command) || has_no_time(tools)
               ? no_time_to_compile()
               : fmt::format("the compiler was stopped after {:g} s\n", tools.compile_seconds);
}

/// Looks through the files as the compiler sees them. Built only says that nothing is in the way. Files that cannot be
/// preprocessed are unexplained: compiling says what is wrong with them.
Compilation look_through(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work)
{
    ConfinedCommand command = compiler_command(tools, exercise, files, work, {"-E", "-fpch-preprocess", "-w"});
    command.output_limit = caps::preprocessed;
    command.stop_at_limit = true;
    const ConfinedResult result = run_compiler(tools, command);
    // What the files say stands in the output: only the clock is believed.
    if (result.stopped == Stopped::out_of_processor_time)
        return {Outcome::too_expensive, {}, out_of_time(tools, command)};
    if (result.stopped == Stopped::too_much_output)
        return {Outcome::refused_by_compiler, {}, "your files include more text than the compiler is given"};
    if (result.exit_status != 0)
        return {Outcome::unexplained, {}, "your files cannot be looked through before they are compiled"};
    // What no compiler takes might hide what one does take.
    if (auto unclosed = find_unclosed(result.output)) return {Outcome::refused_by_compiler, {}, *std::move(unclosed)};
    if (auto assembler = find_assembler(result.output, tools.student_header.string() + ".gch"))
        return {Outcome::not_allowed, {}, *std::move(assembler)};
    return {Outcome::built, {}, ""};
}

bool takes_too_much_disk(const ConfinedResult& result)
{
    return result.stopped == Stopped::too_much_disk || outgrew_the_file_limit(result.output);
}

/// The line in which umbral-as refuses assembler, without the name of the program; nothing if there is none.
std::string refused_assembler(const std::string& output)
{
    const std::size_t place = ("\n" + output).find("\n" + std::string(assembler_refused));
    if (place == std::string::npos) return {};
    const std::size_t begin = output.find(": ", place) + 2;
    return printable(output.substr(begin, output.find('\n', begin) - begin), caps::message);
}

std::string diagnostics_of(const Toolchain& tools, const ConfinedCommand& command, const ConfinedResult& result)
{
    if (ran_out_of_processor_time(tools, result) || result.stopped == Stopped::out_of_wall_time)
        return out_of_time(tools, command);
    if (takes_too_much_disk(result))
        return fmt::format("compiling your files takes more than {} MiB on the disk\n", caps::build_folder >> 20U);
    std::string text = first_errors(result.output, 24);
    if (text.empty()) text = first_errors(": error:\n" + result.output, 24).substr(9);
    return printable(text, caps::message);
}

Outcome outcome_of(const Toolchain& tools, const ConfinedResult& result, const Sources& files)
{
    if (ran_out_of_processor_time(tools, result) || takes_too_much_disk(result)) return Outcome::too_expensive;
    // What the machine lacks may also show as an error in a student's line.
    const bool is_theirs = linker_refuses_files(result.output) ||
                           (!mentions_machine_trouble(result.output) && blames_own_file(result.output, files));
    return result.stopped == Stopped::no && is_theirs ? Outcome::refused_by_compiler : Outcome::unexplained;
}

/// The library that the compiler makes of the files that lie in `work` by this task.
Compilation library_of(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work,
                       const std::string& library_name, const std::vector<std::string>& task)
{
    if (has_no_time(tools)) return {Outcome::too_expensive, {}, no_time_to_compile()};
    const ConfinedCommand command = compiler_command(tools, exercise, files, work, task);
    ConfinedResult result = run_compiler(tools, command);
    // On a busy machine less may be counted of a process than it was stopped for.
    if (tools.budget && was_given_the_rest(tools, command) && ran_out_of_processor_time(tools, result))
        tools.budget->take(tools.budget->left());
    if (result.exit_status == confinement_failed)
        throw std::runtime_error("the compiler cannot be run: " + result.output);
    const fs::path library = work / library_name;
    Compilation compilation;
    result.output =
        without_folders(std::move(result.output), {work, tools.framework, tools.student_header.parent_path()});
    if (result.exit_status != 0 || !fs::is_regular_file(fs::symlink_status(library))) {
        // Of the tools' words this one is about the files alone.
        if (std::string refused = refused_assembler(result.output); !refused.empty())
            return {Outcome::not_allowed, {}, std::move(refused)};
        compilation.outcome = outcome_of(tools, result, files);
        compilation.lacks_machine = tools_are_in_trouble(result.output);
        compilation.diagnostics = diagnostics_of(tools, command, result);
    } else if (fs::file_size(library) > caps::library) {
        compilation.outcome = Outcome::refused_by_compiler;
        compilation.diagnostics =
            fmt::format("your files compile to {} bytes; at most {} are taken", fs::file_size(library), caps::library);
    } else {
        compilation = {Outcome::built, library, printable(warnings_of(result.output), caps::message)};
    }
    return compilation;
}

/// Looks through the files, and has the compiler make a library of them by this task.
Compilation checked_library_of(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                               const fs::path& work, const std::string& library_name, std::vector<std::string> task)
{
    for (const auto& [name, text] : files) write_text(work / name, text);
    if (has_no_time(tools)) return {Outcome::too_expensive, {}, no_time_to_compile()};
    const Compilation looked = look_through(tools, exercise, files, work);
    if (looked.outcome != Outcome::built && looked.outcome != Outcome::unexplained) return looked;
    for (const std::string& word :
         {std::string("-shared"), std::string("-fuse-ld=mold"), std::string("-Wl,--no-threads"),
          std::string("-Wl,--no-fork"), std::string("-Wl,-z,lazy"), std::string("-o"), library_name})
        task.push_back(word);
    const auto make = [&](const Toolchain& with, const std::vector<std::string>& more) {
        // A library that lies there would tell the files that they are compiled once more.
        fs::remove(work / library_name);
        std::vector<std::string> all = task;
        all.insert(all.end(), more.begin(), more.end());
        return library_of(with, exercise, files, work, library_name, all);
    };
    Compilation compilation =
        compiled_as_written(tools, work, make, [](const Compilation& one) { return one.outcome == Outcome::built; });
    // Nothing is run that was not looked through.
    if (looked.outcome == Outcome::unexplained && compilation.outcome == Outcome::built) {
        compilation.outcome = looked.outcome;
        compilation.library.reset();
    }
    return compilation;
}

}

Compilation compile(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work,
                    UnusedCode unused, Diagnostics diagnostics)
{
    const std::string script = (unit_folder(tools, exercise.id) / "exports.map").string();
    std::vector<std::string> task{"-Wl,--version-script=" + script};
    if (diagnostics == Diagnostics::json) task.emplace_back("-fdiagnostics-format=json");
    if (unused == UnusedCode::left_out)
        task.insert(task.begin(), {"-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections"});
    if (exercise.counts_work)
        for (const std::string_view name : counted_calls) task.push_back(fmt::format("-Wl,--wrap={}", name));
    return checked_library_of(tools, exercise, files, work, "student.so", std::move(task));
}

Compilation compile_driver(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work)
{
    Exercise uncounted = exercise;
    uncounted.counts_work = false;
    return checked_library_of(tools, uncounted, files, work, "driver.so", {"-Wl,-Bsymbolic"});
}

}
