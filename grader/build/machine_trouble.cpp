#include "build/machine_trouble.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace umbral::grader {
namespace {

/// Memory that runs out may be the machine's, or what a student's templates take.
constexpr std::string_view killed = "Killed signal";

/// What compilers, assemblers and linkers print when the machine is at its end, not the student: the system's words for
/// its error, which end a line.
constexpr std::array<std::string_view, 6> signs{"No space left on device", "Disk quota exceeded",
                                                "Read-only file system",   "Input/output error",
                                                "Too many open files",     "Resource temporarily unavailable"};

/// How the lines begin that a tool prints of itself; the last is what ends a program that throws. Of the linker's only
/// those that end it: its warnings end with names that the files choose, and of which C++ makes any words.
constexpr std::array<std::string_view, 7> speakers{
    "g++: ", "cc1plus: ", "as: ", "collect2: ", "ld: ", "mold: fatal: ", "  what():  "};

/// What the assembler prints before it says what is wrong with what it was given.
constexpr std::string_view assembler_complains = ": Assembler messages:\n";

bool ends_with_sign(std::string_view line)
{
    // The assembler quotes the system.
    if (line.ends_with('\'')) line.remove_suffix(1);
    return std::ranges::any_of(signs, [&](std::string_view sign) { return line.ends_with(sign); });
}

/// "ccbNoDhr.s: Fatal error: …", without its folder: the assembler's lines about what it was given have a number behind
/// the name.
bool is_of_assembler(std::string_view line)
{
    const std::size_t end = line.find(": ");
    constexpr std::string_view folder = "/tmp/";
    return (line.starts_with("cc") || (line.starts_with(folder) && line.substr(folder.size()).starts_with("cc"))) &&
           end != line.npos && line.substr(end).starts_with(": Fatal error: ") && line.find(':') == end;
}

}

bool mentions_machine_trouble(std::string_view output)
{
    const auto is_in_it = [&](std::string_view sign) { return output.find(sign) != output.npos; };
    return is_in_it(killed) || std::ranges::any_of(signs, is_in_it);
}

bool has_line_beginning(std::string_view output, std::string_view words)
{
    return output.starts_with(words) || output.find("\n" + std::string(words)) != output.npos;
}

bool linker_refuses_files(std::string_view output) { return has_line_beginning(output, "mold: error: "); }

bool outgrew_the_file_limit(std::string_view output)
{
    for (const char* const program : {"ld", "as", "cc1plus"})
        for (const char* const speaker : {"collect2: ", "g++: "})
            if (has_line_beginning(output, std::string(speaker) + "fatal error: " + program +
                                               " terminated with signal 25 [File size limit exceeded]") ||
                has_line_beginning(output, std::string(speaker) +
                                               "fatal error: File size limit exceeded signal terminated program " +
                                               program))
                return true;
    return false;
}

bool tools_are_in_trouble(std::string_view output)
{
    // Those lines are about symbols, sections and relocations, whose names the files choose: line feeds too. And what
    // an assembler refuses to take can have it print any line.
    if (linker_refuses_files(output) || output.find(assembler_complains) != output.npos) return false;
    while (!output.empty()) {
        const std::string_view line = output.substr(0, output.find('\n'));
        output.remove_prefix(std::min(line.size() + 1, output.size()));
        const auto begins = [&](std::string_view speaker) { return line.starts_with(speaker); };
        const bool is_own = std::ranges::any_of(speakers, begins) || is_of_assembler(line);
        if (is_own && ends_with_sign(line)) return true;
    }
    return false;
}

}
