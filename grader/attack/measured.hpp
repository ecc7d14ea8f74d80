#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace umbral::grader::attack {

/// A program, how it is called, and what its process does before it begins.
struct Call {
    std::vector<std::string> words;        ///< the program's path first
    std::vector<std::string> environment;  ///< "NAME=value"
    std::filesystem::path output;          ///< a file that takes what it prints
    double seconds = 600;                  ///< after these it is killed, with its process group
    std::function<void()> before;          ///< in the child; a std::exception ends it with status 127
    std::function<bool()> interrupt;       ///< asked every 20 ms: true kills it by SIGKILL; may be empty
};

/// How it ended, and what it took.
struct Measured {
    int status = -1;  ///< what it exited with; -1 if a signal ended it
    int signal = 0;   ///< that ended it
    bool timed_out = false;
    double seconds = 0;
    double peak_mib = 0;  ///< resident memory of the process itself, without its children, looked at every 20 ms
    std::string printed;  ///< at most the first 4 MiB
};

/// Runs it to its end. Throws std::system_error if no process can be started.
[[nodiscard]] Measured run_measured(const Call& call);

/// Bytes of all regular files below a folder, in KiB of disk; follows no link, and skips what it may not read.
[[nodiscard]] double disk_kib(const std::filesystem::path& folder);

/// A file's bytes, at most `limit`; empty if there is none.
[[nodiscard]] std::string bytes_of_file(const std::filesystem::path& file, std::size_t limit = std::size_t{64} << 20U);

}
