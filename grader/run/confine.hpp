#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "run/sandbox.hpp"

namespace umbral::grader {

/// A program to run on a student's files with its reach limited: the compiler, the linker, the inspector.
struct ConfinedCommand {
    std::filesystem::path confine;  ///< the umbral-confine program
    std::vector<std::string> arguments;
    std::filesystem::path directory;          ///< working directory; the one tree it may write
    std::vector<std::filesystem::path> read;  ///< trees it may read and execute, beside /usr
    double cpu_seconds = 30;                  ///< of each process that it starts
    double wall_seconds = 120;                ///< longer, since a loaded machine is nobody's fault
    int memory_mib = 2048;
    std::size_t output_limit = std::size_t{256} << 10U;
};

/// The status with which umbral-confine says that it could not run the program.
inline constexpr int confinement_failed = 126;

struct ConfinedResult {
    int exit_status = -1;    ///< of the program; -1 if a signal ended it
    bool timed_out = false;  ///< by either clock
    std::string output;      ///< stdout and stderr together, cut at the limit
};

/// Runs it and waits. Throws std::system_error if it cannot be started.
[[nodiscard]] ConfinedResult run_confined(const ConfinedCommand& command);

}
