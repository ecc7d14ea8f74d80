#include <fcntl.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <system_error>

#include "run/sandbox.hpp"

namespace umbral::grader::sandbox {
namespace {

struct Release {
    void operator()(void* context) const noexcept { seccomp_release(context); }
};
using Context = std::unique_ptr<void, Release>;

// libseccomp returns -errno.
void check(int result, const char* what)
{
    if (result < 0) throw std::system_error(-result, std::generic_category(), what);
}

Context context(std::uint32_t otherwise)
{
    Context made(seccomp_init(otherwise));
    if (!made)
        throw std::runtime_error(
            "seccomp_init failed: this kernel or libseccomp does not know this machine's architecture");
    return made;
}

/// The program that libseccomp makes of the rules, taken out through a memory file: it is built once and installed by
/// every run.
Filter program(const Context& rules)
{
    const int file = memfd_create("filter", MFD_CLOEXEC);
    if (file < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
    check(seccomp_export_bpf(rules.get(), file), "seccomp_export_bpf");
    const off_t size = lseek(file, 0, SEEK_END);
    Filter filter(static_cast<std::size_t>(size) / sizeof(sock_filter));
    const ssize_t got = pread(file, filter.data(), filter.size() * sizeof(sock_filter), 0);
    close(file);
    if (got != size) throw std::runtime_error("seccomp_export_bpf wrote a program that could not be read back");
    return filter;
}

/// What computing, drawing in software and printing to an open descriptor need.
constexpr std::array always = {
    SCMP_SYS(read),
    SCMP_SYS(write),
    SCMP_SYS(readv),
    SCMP_SYS(writev),
    SCMP_SYS(pread64),
    SCMP_SYS(lseek),
    SCMP_SYS(close),
    SCMP_SYS(fstat),
    SCMP_SYS(mprotect),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(madvise),
    SCMP_SYS(brk),
    SCMP_SYS(futex),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_getres),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(time),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(getuid),
    SCMP_SYS(geteuid),
    SCMP_SYS(getrandom),
    SCMP_SYS(sched_yield),
    SCMP_SYS(nanosleep),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(getrusage),
    SCMP_SYS(sysinfo),
    SCMP_SYS(uname),
    SCMP_SYS(sched_getaffinity),
};

/// Innocent programs ask these without need (is stdout a terminal?): they get an error, and are not reported.
constexpr std::array quietly_refused = {SCMP_SYS(ioctl), SCMP_SYS(fcntl), SCMP_SYS(readlink), SCMP_SYS(access),
                                        SCMP_SYS(faccessat2)};

}

/// How programs ask for a file by its path; libseccomp has negative numbers for calls that a processor's interface
/// lacks.
constexpr std::array paths_are_asked_by = {SCMP_SYS(open),     SCMP_SYS(openat),     SCMP_SYS(stat),
                                           SCMP_SYS(lstat),    SCMP_SYS(newfstatat), SCMP_SYS(statx),
                                           SCMP_SYS(access),   SCMP_SYS(faccessat),  SCMP_SYS(faccessat2),
                                           SCMP_SYS(readlink), SCMP_SYS(readlinkat)};

Filter run_filter()
{
    const Context rules = context(SCMP_ACT_TRAP);
    // Calls through the x32 and the 32-bit interface have numbers of their own. libseccomp's default kills without a
    // word.
    check(seccomp_attr_set(rules.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_TRAP), "seccomp_attr_set");
    for (const int call : always) check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, call, 0), "seccomp_rule_add");
    // Memory of its own only. Pages of shared memory stay as long as one of them is mapped, and count nowhere once they
    // are not: a run could take all that the machine has, beyond any limit. MAP_SHARED_VALIDATE has the same bit.
    constexpr unsigned flags = 3;
    check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, SCMP_SYS(mmap), 1,
                           SCMP_CMP(flags, SCMP_CMP_MASKED_EQ, MAP_SHARED, 0)),
          "seccomp_rule_add");
    for (const int call : quietly_refused)
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), call, 0), "seccomp_rule_add");
    return program(rules);
}

Filter compiler_filter(bool hold_paths)
{
    const Context rules = context(SCMP_ACT_ALLOW);
    for (const int call : {SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv),
                           SCMP_SYS(process_vm_writev), SCMP_SYS(mount), SCMP_SYS(umount2), SCMP_SYS(pivot_root),
                           SCMP_SYS(keyctl), SCMP_SYS(add_key), SCMP_SYS(request_key), SCMP_SYS(bpf), SCMP_SYS(unshare),
                           SCMP_SYS(setns), SCMP_SYS(perf_event_open), SCMP_SYS(io_uring_setup), SCMP_SYS(userfaultfd)})
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), call, 0), "seccomp_rule_add");
    if (!hold_paths) return program(rules);
    // Its path lies in a structure: programs fall back to openat where it is unknown.
    check(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(openat2), 0), "seccomp_rule_add");
    for (const int call : paths_are_asked_by)
        if (call >= 0) check(seccomp_rule_add(rules.get(), SCMP_ACT_NOTIFY, call, 0), "seccomp_rule_add");
    return program(rules);
}

void install(const Filter& filter)
{
    const sock_fprog described{static_cast<unsigned short>(filter.size()), const_cast<sock_filter*>(filter.data())};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &described) != 0)
        throw std::system_error(errno, std::generic_category(), "seccomp");
}

std::string call_name(unsigned number)
{
    // -1 has every bit set: a number that no interface knows.
    if (number != ~0U && (number & other_architecture) != 0) return "a call through the 32-bit interface";
#if defined(__x86_64__)
    constexpr unsigned x32 = 0x40000000;
    if (number != ~0U && (number & x32) != 0) return "a call through the x32 interface";
#endif
    const std::unique_ptr<char, decltype(&std::free)> name(
        seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, static_cast<int>(number)), &std::free);
    return name ? std::string(name.get()) : "call " + std::to_string(number);
}

}
