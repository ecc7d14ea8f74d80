#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "run/sandbox.hpp"

namespace umbral::grader {

/// A program to run on a student's files with its reach limited: the compiler, the linker, the inspector.
struct ConfinedCommand {
    std::filesystem::path confine;       ///< the umbral-confine program
    std::vector<std::string> arguments;  ///< the program, by its path, and its arguments
    std::filesystem::path directory;     ///< working directory; the one tree it may write
    /// What it may read and execute beside the shared libraries that programs need: trees, files, or "FOLDER/*" for the
    /// files of one folder. Of all else it does not learn whether it exists (run/path_gate.hpp).
    std::vector<std::string> read;
    double cpu_seconds = 30;     ///< of each process that it starts
    double all_cpu_seconds = 0;  ///< of all processes together; beyond, they are stopped. 0: no limit
    double wall_seconds = 120;   ///< longer, since a loaded machine is nobody's fault
    int memory_mib = 2048;
    std::size_t output_limit = std::size_t{256} << 10U;
    std::uintmax_t disk_limit = 0;  ///< bytes that `directory` may hold; beyond, the program is stopped. 0: no limit
    bool stop_at_limit =
        false;  ///< stop the program once it has printed more than `output_limit`, instead of dropping the rest
};

/// The status with which umbral-confine says that it could not run the program.
inline constexpr int confinement_failed = 126;

struct ConfinedResult {
    /// How it was stopped from outside, if it was.
    enum class Stopped { no, out_of_processor_time, out_of_wall_time, too_much_output, too_much_disk };
    int exit_status = -1;  ///< of the program; -1 if a signal ended it
    Stopped stopped = Stopped::no;
    std::string output;      ///< stdout and stderr together, cut at the limit
    double cpu_seconds = 0;  ///< that it took, with all that it started
    double wall_seconds = 0;
};

/// Runs it and waits. Throws std::system_error if it cannot be started.
[[nodiscard]] ConfinedResult run_confined(const ConfinedCommand& command);

}
