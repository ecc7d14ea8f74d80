#include <poll.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>
#include <system_error>

#include "run/child.hpp"
#include "run/descriptor.hpp"
#include "run/protocol.hpp"
#ifdef UMBRAL_WITH_GL
#include "run/warm_gl.hpp"
#endif

// The spawner: started afresh by the grader, it holds what every run needs (libraries, with GL a warm context) and no secret.
// It forks one run for each message, waits for it, and tells how it ended.
namespace umbral::grader {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
double seconds_of(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

std::uint64_t mapped_bytes()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// Waits for the run or for its time to be over; a grader that is gone ends everything.
protocol::Ended supervise(pid_t run, double wall_seconds)
{
    const auto start = Clock::now();
    const Descriptor process(static_cast<int>(syscall(SYS_pidfd_open, run, 0)));
    protocol::Ended ended;
    for (;;) {
        const double left = wall_seconds - seconds_since(start);
        if (left <= 0) {
            ended.timed_out = 1;
            kill(run, SIGKILL);
            break;
        }
        std::array<pollfd, 2> watched{pollfd{process.get(), POLLIN, 0}, pollfd{protocol::control_descriptor, POLLHUP, 0}};
        const int ready = poll(watched.data(), watched.size(), static_cast<int>(left * 1000) + 1);
        if (watched[0].revents != 0) break;
        if (ready > 0 && (watched[1].revents & (POLLHUP | POLLERR)) != 0) {
            kill(run, SIGKILL);
            break;
        }
    }
    rusage used{};
    int status = 0;
    while (wait4(run, &status, 0, &used) < 0 && errno == EINTR) {
    }
    ended.wait_status = status;
    ended.peak_memory_kib = used.ru_maxrss;
    ended.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    ended.wall_seconds = seconds_since(start);
    return ended;
}

/// Does `attempt` succeed in a fork of its own? Protections are named only where they were seen to work.
template <class Attempt>
bool proven(Attempt attempt)
{
    const pid_t probe = fork();
    if (probe == 0) {
        try {
            sandbox::drop_privileges();
            _exit(attempt() ? 0 : 1);
        } catch (const std::exception&) {
            _exit(1);
        }
    }
    int status = 0;
    return probe > 0 && waitpid(probe, &status, 0) == probe && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool files_are_confined()
{
    return proven([] {
        sandbox::confine_files({});
        return !std::ifstream("/etc/passwd");
    });
}

bool calls_are_filtered(const sandbox::Filter& filter)
{
    return proven([&] {
        std::signal(SIGSYS, [](int) { _exit(0); });
        sandbox::install(filter);
        (void)!pause();
        return false;
    });
}

void say_hello(const ChildSetup& setup, const std::string& namespaces)
{
    protocol::Hello hello;
    std::string protections = "resource limits\nno new privileges\n";
    if (calls_are_filtered(setup.running)) protections += "seccomp\n";
    if (files_are_confined()) protections += "landlock " + std::to_string(sandbox::landlock_version()) + "\n";
    protections += namespaces;
    std::strncpy(hello.protections, protections.c_str(), sizeof hello.protections - 1);
#ifdef UMBRAL_WITH_GL
    std::strncpy(hello.gl, warm_gl().c_str(), sizeof hello.gl - 1);
#endif
    send_packet(protocol::control_descriptor, bytes_of(hello), {});
}

int serve(const std::string& namespaces)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 0);
    ChildSetup setup{sandbox::loading_filter(), sandbox::running_filter(), 0};
    say_hello(setup, namespaces);
    setup.base_address_space = mapped_bytes();
    for (;;) {
        protocol::Start start;
        Packet packet = receive_packet(protocol::control_descriptor, writable_bytes_of(start));
        if (packet.closed) return 0;
        if (packet.size != sizeof start || packet.descriptors.size() != 1) return 1;
        const pid_t run = fork();
        if (run == 0) live(setup, packet.descriptors[0].get());
        packet.descriptors.clear();
        protocol::Ended ended;
        if (run < 0)
            ended.could_not_start = 1;
        else
            ended = supervise(run, start.wall_seconds);
        send_packet(protocol::control_descriptor, bytes_of(ended), {});
    }
}

/// The same addresses in every run: code that reads what it never wrote, or sorts by pointer, gives the same answer twice. The kernel
/// takes this up at exec, so the program starts itself once more. Whoever attacks a run owns it already; hiding addresses gains nothing.
void fix_addresses(char** words)
{
    const int current = personality(0xffffffff);
    if (current < 0 || (current & ADDR_NO_RANDOMIZE) != 0 || personality(static_cast<unsigned>(current) | ADDR_NO_RANDOMIZE) < 0) return;
    execv("/proc/self/exe", words);
}

/// In a process namespace of its own the serving process is number 1: when it ends, the kernel ends every run with it.
int start()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::string namespaces;
    bool own_processes = false;
    for (const std::string& name : sandbox::enter_namespaces(true)) {
        namespaces += name + "\n";
        own_processes = own_processes || name == "process namespace";
    }
    if (!own_processes) return serve(namespaces);
    const pid_t first = fork();
    if (first == 0) return serve(namespaces);
    if (first < 0) throw std::system_error(errno, std::generic_category(), "fork");
    close(protocol::control_descriptor);
    int status = 0;
    while (waitpid(first, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}
}

int main(int, char** words)
{
    try {
        umbral::grader::fix_addresses(words);
        return umbral::grader::start();
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-spawner: %s\n", error.what());
        return 1;
    }
}
