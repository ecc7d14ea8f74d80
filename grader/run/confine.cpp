#include "run/confine.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <system_error>

#include "model/disk.hpp"
#include "run/descriptor.hpp"
#include "run/processor_time.hpp"

namespace umbral::grader {
namespace {

using Clock = std::chrono::steady_clock;

/// Seconds between two looks at what a program has written and computed.
constexpr double looking_interval = 0.2;

std::vector<std::string> whole_command(const ConfinedCommand& command)
{
    std::vector<std::string> words{command.confine.string(), std::to_string(command.memory_mib),
                                   std::to_string(static_cast<int>(std::ceil(command.cpu_seconds))),
                                   command.directory.string()};
    words.insert(words.end(), command.read.begin(), command.read.end());
    words.emplace_back("--");
    words.insert(words.end(), command.arguments.begin(), command.arguments.end());
    return words;
}

pid_t start(const ConfinedCommand& command, int output)
{
    const std::vector<std::string> words = whole_command(command);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const std::string temporary = "TMPDIR=" + command.directory.string();
    // The same files compile to the same, whenever that is: __TIME__ is the beginning of 2020.
    std::array environment{const_cast<char*>("PATH=/usr/bin:/bin"), const_cast<char*>("LC_ALL=C.UTF-8"),
                           const_cast<char*>("SOURCE_DATE_EPOCH=1577836800"), const_cast<char*>(temporary.c_str()),
                           static_cast<char*>(nullptr)};

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, 1);
    posix_spawn_file_actions_adddup2(&actions, output, 2);
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // A group of its own, so that a compiler's children end with it.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    pid_t process = -1;
    const int failed =
        posix_spawn(&process, command.confine.c_str(), &actions, &attributes, arguments.data(), environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::system_error(failed, std::generic_category(), "starting " + command.confine.string());
    return process;
}

/// Has it written or computed more than it may? `computed` becomes what it has computed by now.
ConfinedResult::Stopped stopped_by(const ConfinedCommand& command, pid_t process, double& computed)
{
    using Stopped = ConfinedResult::Stopped;
    if (command.disk_limit != 0 && bytes_below(command.directory) > command.disk_limit) return Stopped::too_much_disk;
    if (command.all_cpu_seconds == 0) return Stopped::no;
    computed = std::max(computed, processor_seconds_of_tree(process));
    return computed > command.all_cpu_seconds ? Stopped::out_of_processor_time : Stopped::no;
}

}

ConfinedResult run_confined(const ConfinedCommand& command)
{
    // A socket, not a pipe: what a program opens by the name of its own output (/proc/self/fd/1) is refused and never
    // waits.
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw std::system_error(errno, std::generic_category(), "socketpair");
    Descriptor reading(ends[0]);
    Descriptor writing(ends[1]);
    const pid_t process = start(command, writing.get());
    writing.reset();

    using Stopped = ConfinedResult::Stopped;
    ConfinedResult result;
    const auto begin = Clock::now();
    const bool looks = command.disk_limit != 0 || command.all_cpu_seconds != 0;
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    double next_look = looking_interval;
    std::array<char, 16384> buffer{};
    while (result.stopped == Stopped::no) {
        if (looks && elapsed() >= next_look) {
            result.stopped = stopped_by(command, process, result.cpu_seconds);
            next_look = elapsed() + looking_interval;
            continue;
        }
        const double left = command.wall_seconds - elapsed();
        if (left <= 0) {
            result.stopped = Stopped::out_of_wall_time;
            break;
        }
        const double wait = looks ? std::min(left, next_look - elapsed()) : left;
        pollfd watched{reading.get(), POLLIN, 0};
        if (poll(&watched, 1, static_cast<int>(wait * 1000) + 1) == 0) continue;
        const ssize_t got = read(reading.get(), buffer.data(), buffer.size());
        if (got == 0) break;
        if (got < 0) {
            if (errno == EINTR || errno == EAGAIN) continue;
            break;
        }
        const std::size_t room = command.output_limit - std::min(command.output_limit, result.output.size());
        if (command.stop_at_limit && static_cast<std::size_t>(got) > room) result.stopped = Stopped::too_much_output;
        result.output.append(buffer.data(), std::min(static_cast<std::size_t>(got), room));
    }
    if (result.stopped != Stopped::no) kill(-process, SIGKILL);
    int status = 0;
    rusage used{};
    while (wait4(process, &status, 0, &used) < 0 && errno == EINTR) {
    }
    kill(-process, SIGKILL);
    if (WIFEXITED(status)) result.exit_status = WEXITSTATUS(status);
    // A compiler whose child the kernel stopped ends by itself, with a message about the child's signal.
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    const double waited_for = seconds(used.ru_utime) + seconds(used.ru_stime);
    result.cpu_seconds = std::max(result.cpu_seconds, waited_for);
    result.wall_seconds = elapsed();
    // The kernel stops a process at its limit by its own clock, which is a little ahead of what it tells afterwards.
    const bool spent = waited_for >= 0.95 * command.cpu_seconds;
    if (result.stopped == Stopped::no && result.exit_status != 0 && spent)
        result.stopped = Stopped::out_of_processor_time;
    return result;
}

}
