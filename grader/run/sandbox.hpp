#pragma once

#include <linux/filter.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// What the kernel offers to keep a process from doing harm. Each piece works without privileges and is inherited by
/// children.
namespace umbral::grader::sandbox {

/// A file or directory tree that stays reachable under Landlock.
struct FileRule {
    std::filesystem::path path;
    bool write = false;
    bool execute = false;
};

/// Version of Landlock that this kernel offers; 0 if none.
[[nodiscard]] int landlock_version();

/// From here on this thread reaches only `rules`, may open no TCP port and signal no process outside. Needs
/// no_new_privs. Rules whose path does not exist are skipped. Throws std::system_error if the kernel refuses; does
/// nothing if it has no Landlock.
void confine_files(std::span<const FileRule> rules);

/// Sets no_new_privs: exec can no longer raise privileges. Throws std::system_error.
void drop_privileges();

/// Gives up all capabilities: root without them is like anybody. Some calls that every program makes do more for root:
/// madvise takes pages of memory away from the machine. Throws std::system_error.
void drop_capabilities();

/// New user, network, IPC and UTS namespaces (and a process namespace for children) for this process, as far as the
/// kernel lets us. Returns the names of those entered.
std::vector<std::string> enter_namespaces(bool processes);

/// Limits of one process; 0 leaves a limit as it is.
struct ResourceLimits {
    static constexpr std::uint64_t stack = std::uint64_t{8} << 20U;  ///< bytes, always, as far as the hard limit allows
    std::uint64_t address_space = 0;                                 ///< bytes
    std::uint64_t cpu_seconds = 0;
    std::uint64_t file_size = 0;  ///< bytes
    std::uint64_t descriptors = 0;
    bool no_children = false;
};
/// Applies them, and no core dumps. Throws std::system_error.
void limit_resources(const ResourceLimits& limits);

using Filter = std::vector<sock_filter>;

/// For a run, from before the first foreign code to its end: memory, its own clock, what is open already. Whatever else
/// is tried raises SIGSYS, so that it can be named; opening files too, by whatever path, and emulated_calls.hpp gives
/// the loader what it needs.
[[nodiscard]] Filter run_filter();
/// For the compiler: everything but sockets, tracing, mounting and keys, which fail with EPERM. With `hold_paths`,
/// calls that ask for a file by its path wait for an answer from whoever holds the filter's listener
/// (run/path_gate.hpp).
[[nodiscard]] Filter compiler_filter(bool hold_paths);
/// Installs a filter for this process. Filters add up: a later one can only take away. Throws std::system_error.
void install(const Filter& filter);

/// Set in the number of a refused call that was made through another interface of the kernel than this program's own.
inline constexpr unsigned other_architecture = 0x80000000;

/// Name of a system call, "openat", "call 999", or "a call through the x32 interface".
[[nodiscard]] std::string call_name(unsigned number);

}
