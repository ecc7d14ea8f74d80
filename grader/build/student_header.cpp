#include "build/student_header.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "build/compiler_files.hpp"
#include "model/caps.hpp"
#include "model/recording.hpp"
#include "run/confine.hpp"
#include "run/descriptor.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* made = "umbral_student.hpp.new";
constexpr const char* dependencies = "dependencies.txt";

fs::path precompiled(const Toolchain& tools) { return tools.student_header.string() + ".gch"; }
fs::path stamp(const Toolchain& tools) { return tools.student_header.parent_path() / "made-from.txt"; }

/// Size and time of a file's last change, in one line with its name. A package manager sets times back, so it is
/// equality that counts.
std::string state_of(const fs::path& file)
{
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    if (missing) return fmt::format("missing {}\n", file.string());
    return fmt::format("{} {} {}\n", size, fs::last_write_time(file).time_since_epoch().count(), file.string());
}

/// What decides the result beside the headers.
std::string state_of_tools(const Toolchain& tools, const fs::path& text)
{
    // The compiler's name is a link; the program behind it changes with every version.
    std::error_code missing;
    const fs::path program = fs::canonical(tools.compiler, missing);
    return fmt::format("{}\n", fmt::join(tools.flags, " ")) + state_of(missing ? fs::path(tools.compiler) : program) +
           state_of(text);
}

/// The files in a rule for make, "target: file file \", in which a space within a name stands behind a backslash.
std::vector<std::string> files_in_rule(const std::string& rule)
{
    std::vector<std::string> files(1);
    for (std::size_t at = rule.find(": ") + 1; at < rule.size(); ++at) {
        const char here = rule[at];
        const char next = at + 1 < rule.size() ? rule[at + 1] : '\n';
        if (here == '\\' && next == ' ')
            files.back() += rule[++at];
        else if (here != ' ' && here != '\n' && !(here == '\\' && next == '\n'))
            files.back() += here;
        else if (!files.back().empty())
            files.emplace_back();
    }
    if (files.back().empty()) files.pop_back();
    return files;
}

void compile_header(const Toolchain& tools, const fs::path& text)
{
    const fs::path folder = tools.student_header.parent_path();
    write_text(tools.student_header, read_text(text));
    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.directory = folder;
    command.read = compiler_files(tools.compiler);
    command.read.push_back(tools.framework.string());
    command.arguments = {tools.compiler};
    command.arguments.insert(command.arguments.end(), tools.flags.begin(), tools.flags.end());
    for (const std::string& word : {"-I" + tools.framework.string(), std::string("-MD"), std::string("-MF"),
                                    std::string(dependencies), std::string("-x"), std::string("c++-header"),
                                    tools.student_header.string(), std::string("-o"), std::string(made)})
        command.arguments.push_back(word);
    const ConfinedResult result = run_confined(command);
    if (result.exit_status != 0)
        throw std::runtime_error(fmt::format(
            "{} cannot prepare the headers of students' files in {}; `umbral doctor` says what is missing. It says: {}",
            tools.compiler, folder.string(), one_line(result.output, 1024)));
}

}

std::vector<std::string> read_first(const Toolchain& tools, const Exercise& exercise)
{
    std::vector<std::string> arguments{"-I" + tools.framework.string(), "-include", tools.student_header.string()};
    for (const std::string& header : exercise.interfaces) arguments.insert(arguments.end(), {"-include", header});
    return arguments;
}

bool is_header_ready(const Toolchain& tools, const fs::path& text)
{
    if (!fs::exists(precompiled(tools))) return false;
    std::ifstream stream(stamp(tools));
    const std::string known{std::istreambuf_iterator<char>(stream), {}};
    const std::string expected = state_of_tools(tools, text);
    if (!known.starts_with(expected)) return false;
    std::string now = expected;
    for (std::size_t at = expected.size(); at < known.size();) {
        const std::size_t end = std::min(known.find('\n', at), known.size());
        // "size time name", where the name may hold spaces.
        const std::size_t name = known.find(' ', known.find(' ', at) + 1) + 1;
        if (name == 0 || name > end) return false;
        now += state_of(known.substr(name, end - name));
        at = end + 1;
    }
    return now == known;
}

void make_header(const Toolchain& tools, const fs::path& text)
{
    const fs::path folder = tools.student_header.parent_path();
    fs::create_directories(folder);
    const Descriptor lock(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock || flock(lock.get(), LOCK_EX) != 0)
        throw std::runtime_error(fmt::format("cannot write in {}: {}; UMBRAL_CACHE chooses another folder",
                                             folder.string(), std::strerror(errno)));
    if (is_header_ready(tools, text)) return;
    compile_header(tools, text);
    std::string state = state_of_tools(tools, text);
    for (const std::string& file : files_in_rule(read_text(folder / dependencies)))
        if (file != tools.student_header) state += state_of(file);
    fs::remove(stamp(tools));
    fs::rename(folder / made, precompiled(tools));
    write_text(stamp(tools), state);
}

}
