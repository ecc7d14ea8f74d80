#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "run/descriptor.hpp"
#include "run/path_gate.hpp"
#include "run/sandbox.hpp"

// umbral-confine MEMORY_MIB CPU_SECONDS DIRECTORY [RULE…] -- PROGRAM [ARGUMENT…]
// Runs a program that may write DIRECTORY (and works there), read and execute what the RULEs name (run/path_gate.hpp)
// and the shared libraries that programs need, and nothing else, of which it does not even learn whether it exists: no
// network.
namespace umbral::grader {
namespace {

struct Command {
    sandbox::ResourceLimits limits;
    std::string directory;
    std::vector<std::string> rules;
    char** program = nullptr;
};

Command command_from(int count, char** words)
{
    Command command;
    int at = 4;
    if (count >= at + 2) {
        command.limits = {.address_space = std::strtoull(words[1], nullptr, 10) << 20U,
                          .cpu_seconds = std::strtoull(words[2], nullptr, 10),
                          .file_size = std::uint64_t{128} << 20U,
                          .descriptors = 256,
                          .no_children = false};
        command.directory = words[3];
        for (; at < count && std::strcmp(words[at], "--") != 0; ++at) command.rules.emplace_back(words[at]);
    }
    if (at + 1 >= count)
        throw std::runtime_error(
            "usage: umbral-confine MEMORY_MIB CPU_SECONDS DIRECTORY [RULE…] -- PROGRAM [ARGUMENT…]");
    command.program = words + at + 1;
    for (const char* rule : {UMBRAL_LIBRARY_FOLDER "/*", "/usr/lib64/*", "/etc/ld.so.cache", "/dev/null"})
        command.rules.emplace_back(rule);
    command.rules.emplace_back(command.program[0]);
    return command;
}

/// For Landlock, which knows trees only: the files of one folder are its tree, of which the gate shows less.
std::vector<sandbox::FileRule> file_rules(const Command& command)
{
    std::vector<sandbox::FileRule> rules{{command.directory, true, false}};
    for (const std::string& rule : command.rules) {
        const bool is_device = rule == "/dev/null";
        rules.push_back({rule.ends_with("/*") ? rule.substr(0, rule.size() - 2) : rule, is_device, !is_device});
    }
    return rules;
}

/// The filter that holds paths back for the gate, where the kernel has such filters and no other program listens
/// already; else the plain one.
Descriptor install_filter()
{
    const sandbox::Filter filter = sandbox::compiler_filter(true);
    const sock_fprog described{static_cast<unsigned short>(filter.size()), const_cast<sock_filter*>(filter.data())};
    Descriptor listener(
        static_cast<int>(syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &described)));
    if (!listener) sandbox::install(sandbox::compiler_filter(false));
    return listener;
}

/// In the child: enters the confinement, hands the gate's listener to the parent, and becomes the program.
[[noreturn]] void exec_program(const Command& command, int parent)
{
    try {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        std::signal(SIGTERM, SIG_DFL);
        if (chdir(command.directory.c_str()) != 0) throw std::runtime_error("cannot enter " + command.directory);
        sandbox::limit_resources(command.limits);
        sandbox::enter_namespaces(false);
        sandbox::drop_privileges();
        sandbox::confine_files(file_rules(command));
        {
            const Descriptor listener = install_filter();
            const std::byte byte{};
            const std::array handed{listener.get()};
            send_packet(parent, {&byte, 1}, listener ? std::span<const int>(handed) : std::span<const int>{});
        }
        execvp(command.program[0], command.program);
        throw std::runtime_error(std::string("cannot run ") + command.program[0] + ": " + std::strerror(errno));
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-confine: %s\n", error.what());
        _exit(126);
    }
}

/// A compiler has children, which nobody else would end with the grader. Only where the group is this program's own.
void end_with_parent()
{
    if (getpgrp() != getpid()) return;
    std::signal(SIGTERM, [](int) { kill(0, SIGKILL); });
    prctl(PR_SET_PDEATHSIG, SIGTERM);
}

/// Ends as the program did.
int end_like(int status)
{
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    std::signal(WTERMSIG(status), SIG_DFL);
    kill(getpid(), WTERMSIG(status));
    return 126;
}

int run(const Command& command)
{
    end_with_parent();
    auto [ours, theirs] = socket_pair();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
    if (child == 0) exec_program(command, theirs.get());
    theirs.reset();
    std::byte byte{};
    Packet packet = receive_packet(ours.get(), {&byte, 1});
    if (!packet.descriptors.empty())
        guard_paths(std::move(packet.descriptors.front()), child,
                    PathRules(std::filesystem::canonical(command.directory), command.rules));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return end_like(status);
}

}
}

int main(int count, char** words)
{
    try {
        return umbral::grader::run(umbral::grader::command_from(count, words));
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-confine: %s\n", error.what());
        return 126;
    }
}
