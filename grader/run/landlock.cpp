#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <system_error>

#include "run/sandbox.hpp"

// Based on: M. Salaün. Landlock: unprivileged access control. Documentation/userspace-api/landlock.rst, Linux 6.12.
// Debian 12's headers know version 1 only; the layout below is the kernel's of version 6, and an older kernel is given
// less of it.
namespace umbral::grader::sandbox {
namespace {

struct RulesetAttributes {
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scoped = 0;
};

struct [[gnu::packed]] PathBeneath {
    std::uint64_t allowed = 0;
    std::int32_t parent = -1;
};

constexpr std::uint64_t execute = 1U << 0U;
constexpr std::uint64_t write_file = 1U << 1U;
constexpr std::uint64_t read_file = 1U << 2U;
constexpr std::uint64_t read_directory = 1U << 3U;
constexpr std::uint64_t truncate_file = 1U << 14U;
constexpr std::uint64_t tcp_bind_and_connect = 3;
constexpr std::uint64_t abstract_sockets_and_signals = 3;
constexpr unsigned query_version = 1;
constexpr int rule_path_beneath = 1;

/// All rights on files that a version of Landlock knows: 13 at first, then refer, truncate and device ioctl.
constexpr std::uint64_t all_file_rights(int version)
{
    constexpr std::array<unsigned, 6> known = {0, 13, 14, 15, 15, 16};
    return (std::uint64_t{1} << known[static_cast<std::size_t>(std::min(version, 5))]) - 1;
}

[[noreturn]] void refuse_call(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

}

int landlock_version()
{
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, query_version);
    return version < 0 ? 0 : static_cast<int>(version);
}

void confine_files(std::span<const FileRule> rules)
{
    const int version = landlock_version();
    if (version == 0) return;
    const std::uint64_t all = all_file_rights(version);
    RulesetAttributes attributes{all, version >= 4 ? tcp_bind_and_connect : 0,
                                 version >= 6 ? abstract_sockets_and_signals : 0};
    const std::size_t size = version >= 6 ? sizeof attributes : version >= 4 ? 16 : 8;
    const auto ruleset = static_cast<int>(syscall(SYS_landlock_create_ruleset, &attributes, size, 0));
    if (ruleset < 0) refuse_call("landlock_create_ruleset");

    for (const FileRule& rule : rules) {
        const int file = open(rule.path.c_str(), O_PATH | O_CLOEXEC);
        if (file < 0) continue;
        struct stat status {};
        const bool is_directory = fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
        std::uint64_t allowed = read_file | (rule.execute ? execute : 0);
        if (is_directory) allowed |= read_directory;
        if (rule.write) allowed |= is_directory ? all & ~execute : (write_file | truncate_file) & all;
        PathBeneath beneath{allowed, file};
        const long added = syscall(SYS_landlock_add_rule, ruleset, rule_path_beneath, &beneath, 0);
        close(file);
        if (added != 0) refuse_call("landlock_add_rule");
    }
    if (syscall(SYS_landlock_restrict_self, ruleset, 0) != 0) refuse_call("landlock_restrict_self");
    close(ruleset);
}

}
