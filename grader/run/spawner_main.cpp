#include <poll.h>
#include <sys/eventfd.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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
#include "run/machine_trouble.hpp"
#include "run/processor_wait.hpp"
#include "run/protocol.hpp"
#ifdef UMBRAL_WITH_GL
#include "run/warm_gl.hpp"
#endif

// The spawner: started afresh by the grader, it holds what every run needs (libraries, with GL a warm context) and no
// secret. It forks one run for each message, waits for it, and tells how it ended.
namespace umbral::grader {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
double seconds_of(const timeval& time)
{
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::uint64_t mapped_bytes()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// How often the kernel has killed a process because memory had run out, since the machine was started; 0 if it does
/// not say.
std::uint64_t kills_for_memory()
{
    std::ifstream counters("/proc/vmstat");
    std::string name;
    for (std::uint64_t count = 0; counters >> name >> count;)
        if (name == "oom_kill") return count;
    return 0;
}

/// How many times its limit a run may take on a machine that is busy with others.
constexpr double patience = 8;

/// Waits for the run or for its time to be over; a grader that is gone ends everything. The student's time begins when
/// the eventfd `confined` says that the run has entered its sandbox; before, only our own code runs. What the run waits
/// for a processor is not its time: a class on all processors, and a student's other programs, would cost right work
/// its points.
protocol::Ended supervise(pid_t run, int confined, double wall_seconds)
{
    auto start = Clock::now();
    double allowed = protocol::seconds_to_confine;
    const Descriptor process(static_cast<int>(syscall(SYS_pidfd_open, run, 0)));
    const ProcessorWait waited(process.get());
    double waited_before = 0;
    protocol::Ended ended;
    for (;;) {
        const double spent = seconds_since(start);
        double left = allowed - spent;
        if (left <= 0) left = std::min(allowed + waited.seconds() - waited_before, patience * allowed) - spent;
        if (left <= 0) {
            ended.timed_out = 1;
            kill(run, SIGKILL);
            break;
        }
        std::array<pollfd, 3> watched{pollfd{process.get(), POLLIN, 0},
                                      pollfd{protocol::control_descriptor, POLLHUP, 0}, pollfd{confined, POLLIN, 0}};
        const int ready = poll(watched.data(), watched.size(), static_cast<int>(left * 1000) + 1);
        if (ready > 0 && (watched[2].revents & POLLIN) != 0) {
            start = Clock::now();
            allowed = wall_seconds;
            waited_before = waited.seconds();
            confined = -1;
        }
        if (watched[0].revents != 0) break;
        if (ready > 0 && (watched[1].revents & (POLLHUP | POLLERR)) != 0) {
            kill(run, SIGKILL);
            break;
        }
    }
    rusage used{};
    int status = 0;
    // Before the kernel forgets what it counted of the process.
    ended.waited_seconds = std::max(0.0, waited.seconds() - waited_before);
    while (wait4(run, &status, 0, &used) < 0 && errno == EINTR) {
    }
    ended.wait_status = status;
    ended.peak_memory_kib = used.ru_maxrss;
    ended.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    ended.wall_seconds = seconds_since(start);
    return ended;
}

/// Forks a run and waits for it. `kills_seen` is what kills_for_memory() last said.
protocol::Ended run_once(const ChildSetup& setup, Descriptor run_socket, double wall_seconds, std::uint64_t& kills_seen)
{
    protocol::Ended ended;
    const Descriptor confined(eventfd(0, EFD_CLOEXEC));
    const pid_t run = confined ? fork() : -1;
    if (run == 0) live(setup, run_socket.get(), confined.get());
    const int error = errno;
    run_socket.reset();
    if (run < 0) {
        ended.could_not_start = error;
        return ended;
    }
    ended = supervise(run, confined.get(), wall_seconds);
    if (WIFSIGNALED(ended.wait_status) && WTERMSIG(ended.wait_status) == SIGKILL && ended.timed_out == 0) {
        const std::uint64_t kills = kills_for_memory();
        ended.out_of_memory_kill = kills > kills_seen ? 1 : 0;
        kills_seen = kills;
    }
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
    // Without a process to try it in, nothing is known of the protection: that is no reason to call it missing.
    if (probe < 0) throw std::system_error(errno, std::generic_category(), "fork");
    int status = 0;
    return waitpid(probe, &status, 0) == probe && WIFEXITED(status) && WEXITSTATUS(status) == 0;
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
    if (calls_are_filtered(setup.filter)) protections += "seccomp\n";
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
    ChildSetup setup{sandbox::run_filter(), 0};
    say_hello(setup, namespaces);
    setup.base_address_space = mapped_bytes();
    std::uint64_t kills_seen = kills_for_memory();
    for (;;) {
        protocol::Start start;
        Packet packet = receive_packet(protocol::control_descriptor, writable_bytes_of(start));
        if (packet.closed) return 0;
        if (packet.size != sizeof start || packet.descriptors.size() != 1) return 1;
        const protocol::Ended ended = run_once(setup, std::move(packet.descriptors[0]), start.wall_seconds, kills_seen);
        send_packet(protocol::control_descriptor, bytes_of(ended), {});
    }
}

/// The same addresses in every run: code that reads what it never wrote, or sorts by pointer, gives the same answer
/// twice. The kernel takes this up at exec, so the program starts itself once more. Whoever attacks a run owns it
/// already; hiding addresses gains nothing.
void fix_addresses(char** words)
{
    const int current = personality(0xffffffff);
    if (current < 0 || (current & ADDR_NO_RANDOMIZE) != 0 ||
        personality(static_cast<unsigned>(current) | ADDR_NO_RANDOMIZE) < 0)
        return;
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

/// Says why there will be no runs, if anybody listens.
void say_trouble(const std::string& what) noexcept
{
    try {
        protocol::Hello hello;
        std::strncpy(hello.trouble, what.c_str(), sizeof hello.trouble - 1);
        send_packet(protocol::control_descriptor, bytes_of(hello), {});
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-spawner: %s\n", error.what());
    }
}

}
}

int main(int, char** words)
{
    using namespace umbral::grader;
    try {
        fix_addresses(words);
        return start();
    } catch (const std::system_error& error) {
        say_trouble(machine_trouble(error));
    } catch (const std::exception& error) {
        say_trouble(error.what());
    }
    return 1;
}
