#include "mutants/build_mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

#include "build/compiler_files.hpp"
#include "build/padding_fault.hpp"
#include "build/student_header.hpp"
#include "build/submission.hpp"
#include "model/caps.hpp"
#include "mutants/schemata.hpp"
#include "run/confine.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Options, as of the compiler, in the order of MutantFamily.
constexpr std::array<const char*, 5> families{"", "--slips", "--repairs", "--idle", "--echo"};

class Deadline {
public:
    explicit Deadline(double seconds) : seconds_(seconds) {}

    [[nodiscard]] double left() const
    {
        return seconds_ - std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }

private:
    double seconds_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// Where programs work, and until when.
struct Work {
    const fs::path& folder;
    const Deadline& deadline;
};

/// A program to run in a folder on the source there, with what a compiler of it reads.
ConfinedCommand command_in(const Work& work, const Toolchain& tools)
{
    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.directory = work.folder;
    command.cpu_seconds = 4 * tools.compile_seconds;
    command.wall_seconds = std::clamp(work.deadline.left(), 0.0, 16 * tools.compile_seconds);
    command.output_limit = std::size_t{16} << 20U;
    command.read = compiler_files(tools.compiler);
    command.read.push_back(tools.framework.string());
    return command;
}

std::vector<Mutant> find(const fs::path& finder, MutantFamily family, const std::string& source, const Toolchain& tools,
                         const Exercise& exercise, const Work& work)
{
    // libclang would take the compiler's precompiled form of the header for its own.
    Toolchain own = tools;
    own.student_header = work.folder / tools.student_header.filename();
    write_text(own.student_header, read_text(tools.student_header));
    write_text(work.folder / "source.cpp", source);
    ConfinedCommand command = command_in(work, tools);
    command.read.push_back(finder.string());
    // libclang's own headers, and where it looks for those of the C++ library.
    for (const char* folder :
         {"/usr/lib/gcc", "/usr/include", "/usr/lib/llvm-14", "/usr/lib/llvm-15", "/usr/lib/llvm-16"})
        if (fs::exists(folder)) command.read.emplace_back(folder);
    command.arguments = {finder.string()};
    if (const std::string option = families.at(static_cast<std::size_t>(family)); !option.empty())
        command.arguments.push_back(option);
    command.arguments.emplace_back("source.cpp");
    std::ranges::copy_if(tools.flags, std::back_inserter(command.arguments),
                         [](const std::string& flag) { return flag.starts_with("-std=") || flag.starts_with("-D"); });
    const std::vector<std::string> headers = read_first(own, exercise);
    command.arguments.insert(command.arguments.end(), headers.begin(), headers.end());
    const ConfinedResult result = run_confined(command);
    const nlohmann::json json = nlohmann::json::parse(result.output, nullptr, false);
    if (!json.is_array())
        throw NotMutable(fmt::format("{} ended with status {}: {}", finder.filename().string(), result.exit_status,
                                     one_line(result.output)));
    std::vector<Mutant> mutants;
    for (const auto& one : json)
        mutants.push_back({one.at("number"), static_cast<Mutant::Form>(one.at("form").get<int>()), one.at("begin"),
                           one.at("end"), one.at("line"), one.at("replacement"), one.at("kind"), one.at("change"),
                           one.at("gives_nothing")});
    return mutants;
}

ConfinedResult compile_once(const Toolchain& tools, const Exercise& exercise, const Work& work,
                            const std::vector<std::string>& more)
{
    ConfinedCommand command = command_in(work, tools);
    command.read.push_back(tools.student_header.parent_path().string());
    command.arguments = {tools.compiler};
    command.arguments.insert(command.arguments.end(), tools.flags.begin(), tools.flags.end());
    if (exercise.counts_work) command.arguments.emplace_back("-fsanitize-coverage=trace-pc");
    const std::vector<std::string> headers = read_first(tools, exercise);
    command.arguments.insert(command.arguments.end(), headers.begin(), headers.end());
    for (const std::string& word :
         {std::string("-w"), std::string("-fdiagnostics-color=never"), std::string("-fno-diagnostics-show-caret"),
          std::string("-shared"), std::string("-fuse-ld=mold"), std::string("-Wl,-z,lazy"), std::string("-o"),
          std::string("mutants.so"), std::string("./mutants.cpp")})
        command.arguments.push_back(word);
    command.arguments.insert(command.arguments.end(), more.begin(), more.end());
    return run_confined(command);
}

ConfinedResult compile(const Toolchain& tools, const Exercise& exercise, const std::string& text, const Work& work)
{
    write_text(work.folder / "mutants.cpp", text);
    return compiled_as_written(
        tools, work.folder,
        [&](const Toolchain& with, const std::vector<std::string>& more) {
            return compile_once(with, exercise, work, more);
        },
        [](const ConfinedResult& result) { return result.exit_status == 0; });
}

std::size_t lines_between(const std::string& source, const Mutant& mutant)
{
    const std::string_view text = std::string_view(source).substr(mutant.begin, mutant.end - mutant.begin);
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

/// The numbers of mutants on whose lines a compiler's errors and notes lie. An error on a line of the source itself
/// comes of one of the mutants there.
std::set<unsigned> blamed(const std::string& output, const std::string& source, const std::vector<Mutant>& mutants)
{
    std::set<unsigned> numbers;
    std::set<std::size_t> own_lines;
    std::istringstream stream(output);
    for (std::string line; std::getline(stream, line);) {
        constexpr std::string_view file = "mutants.cpp:";
        const std::size_t at = line.find(file);
        if (at == std::string::npos) continue;
        const std::size_t number = std::strtoull(line.c_str() + at + file.size(), nullptr, 10);
        if (number > first_mutant_line)
            numbers.insert(static_cast<unsigned>(number - first_mutant_line));
        else if (line.find(" error: ") != std::string::npos)
            own_lines.insert(number);
    }
    if (!numbers.empty()) return numbers;
    for (const Mutant& mutant : mutants)
        if (const auto line = own_lines.lower_bound(mutant.line);
            line != own_lines.end() && *line <= mutant.line + lines_between(source, mutant))
            numbers.insert(mutant.number);
    return numbers;
}

}

BuiltMutants build_mutants(const Toolchain& tools, const Exercise& exercise, MutantFamily family,
                           const fs::path& finder, const std::string& source, const fs::path& work, double seconds)
{
    constexpr int most_attempts = 60;
    const Deadline deadline(seconds);
    BuiltMutants built;
    built.mutants = find(finder, family, source, tools, exercise, {work, deadline});
    const std::size_t found = built.mutants.size();
    for (int attempt = 0;; ++attempt) {
        const ConfinedResult result = compile(tools, exercise, with_mutants(source, built.mutants), {work, deadline});
        if (result.exit_status == 0) break;
        if (deadline.left() <= 0)
            throw NotMutable(fmt::format("{}: compiling its {} changes takes longer than {:.0f} seconds", exercise.id,
                                         built.mutants.size(), seconds));
        const std::set<unsigned> wrong = blamed(result.output, source, built.mutants);
        const std::size_t left_out =
            std::erase_if(built.mutants, [&](const Mutant& mutant) { return wrong.contains(mutant.number); });
        if (left_out == 0 || attempt == most_attempts)
            throw NotMutable(fmt::format("{}: the source does not compile with its mutants: {}", exercise.id,
                                         one_line(result.output, 2000)));
    }
    built.not_compiled = found - built.mutants.size();
    built.library = work / "mutants.so";
    return built;
}

}
