#include "build/machine_trouble.hpp"

#include <algorithm>
#include <array>

namespace umbral::grader {
namespace {

/// Memory that runs out may be the machine's, or what a student's templates take.
constexpr std::string_view killed = "Killed signal";

/// What compilers, assemblers and linkers print when the machine is at its end, not the student.
constexpr std::array<std::string_view, 10> signs{"No space left on device",
                                                 "Disk quota exceeded",
                                                 "Read-only file system",
                                                 "Input/output error",
                                                 "Too many open files",
                                                 "Resource temporarily unavailable",
                                                 killed,
                                                 "Cannot fork",
                                                 "cannot fork",
                                                 "vfork: "};

/// How the lines begin that a tool prints of itself; the last is what ends a program that throws.
constexpr std::array<std::string_view, 8> speakers{
    "g++: ", "cc1plus: ", "as: ", "collect2: ", "ld: ", "mold: ", "/tmp/cc", "  what():  "};

}

bool mentions_machine_trouble(std::string_view output)
{
    return std::ranges::any_of(signs, [&](std::string_view sign) { return output.find(sign) != output.npos; });
}

bool tools_are_in_trouble(std::string_view output)
{
    while (!output.empty()) {
        const std::string_view line = output.substr(0, output.find('\n'));
        output.remove_prefix(std::min(line.size() + 1, output.size()));
        const auto begins = [&](std::string_view speaker) { return line.starts_with(speaker); };
        if (!std::ranges::any_of(speakers, begins) || line.find(killed) != line.npos) continue;
        if (mentions_machine_trouble(line)) return true;
    }
    return false;
}

}
