#include "build/compile.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "model/recording.hpp"
#include "run/confine.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

ConfinedCommand command_for(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work)
{
    const fs::path unit = unit_folder(tools, exercise.id);
    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.directory = work;
    command.cpu_seconds = tools.compile_seconds;
    command.wall_seconds = 4 * tools.compile_seconds;
    // Of the unit only the version script: beside it lie the libraries with the answers.
    command.read = {tools.framework, tools.student_header.parent_path(), unit / "exports.map"};
    command.arguments = {tools.compiler};
    command.arguments.insert(command.arguments.end(), tools.flags.begin(), tools.flags.end());
    if (exercise.counts_cost()) command.arguments.emplace_back("-fsanitize-coverage=trace-pc");
    for (const std::string& word :
         {std::string("-fdiagnostics-color=never"), std::string("-fmax-errors=5"), "-I" + tools.framework.string(), "-ffile-prefix-map=" + work.string() + "=.",
          std::string("-include"), tools.student_header.string(), std::string("-shared"), std::string("-fuse-ld=mold"), std::string("-Wl,-z,lazy"),
          "-Wl,--version-script=" + (unit / "exports.map").string(), std::string("-o"), std::string("student.so")})
        command.arguments.push_back(word);
    for (const auto& [name, text] : files)
        if (name.ends_with(".cpp")) command.arguments.push_back(name);
    return command;
}

/// Diagnostics name the student's files as written and headers as they are included, not where things lie on this machine.
std::string without_our_paths(std::string text, const Toolchain& tools, const fs::path& work)
{
    for (const fs::path& folder : {work, tools.framework, tools.student_header.parent_path()}) {
        const std::string prefix = folder.string() + "/";
        for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) text.erase(at, prefix.size());
    }
    return text;
}

}

std::string first_errors(std::string_view output, std::size_t lines)
{
    std::string kept;
    std::istringstream stream{std::string(output)};
    std::size_t count = 0;
    bool relevant = false;
    for (std::string line; std::getline(stream, line);) {
        // A message begins a block ("sphere.cpp:3:5: error: …"); source lines and notes follow it.
        if (line.find(": error:") != std::string::npos || line.find("undefined reference") != std::string::npos ||
            line.find("duplicate symbol") != std::string::npos)
            relevant = true;
        else if (line.find(": warning:") != std::string::npos)
            relevant = false;
        if (!relevant) continue;
        if (++count > lines) return kept + "…\n";
        kept += line + '\n';
    }
    return kept;
}

Compilation compile(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& work)
{
    for (const auto& [name, text] : files) {
        std::ofstream stream(work / name, std::ios::binary);
        stream << text;
        if (!stream.flush()) throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", (work / name).string()));
    }
    const ConfinedCommand command = command_for(tools, exercise, files, work);
    const ConfinedResult result = run_confined(command);
    if (result.exit_status == confinement_failed) throw std::runtime_error("the compiler cannot be run: " + result.output);
    Compilation compilation;
    const fs::path library = work / "student.so";
    if (result.exit_status == 0 && fs::is_regular_file(fs::symlink_status(library))) {
        compilation.library = library;
        return compilation;
    }
    const std::string output = without_our_paths(result.output, tools, work);
    compilation.diagnostics = first_errors(output, 24);
    compilation.out_of_time = result.timed_out;
    if (result.timed_out) compilation.diagnostics = fmt::format("the compiler was stopped after {:g} s\n", tools.compile_seconds);
    if (compilation.diagnostics.empty()) compilation.diagnostics = first_errors(": error:\n" + output, 24).substr(9);
    compilation.diagnostics = printable(compilation.diagnostics, 8192);
    return compilation;
}

}
