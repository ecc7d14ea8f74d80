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
    if (!made) throw std::runtime_error("seccomp_init failed: this kernel or libseccomp does not know this machine's architecture");
    return made;
}

/// The program that libseccomp makes of the rules, taken out through a memory file: it is built once and installed by every run.
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
    SCMP_SYS(read),          SCMP_SYS(write),        SCMP_SYS(readv),          SCMP_SYS(writev),
    SCMP_SYS(pread64),       SCMP_SYS(lseek),        SCMP_SYS(close),          SCMP_SYS(fstat),
    SCMP_SYS(mmap),          SCMP_SYS(mprotect),     SCMP_SYS(munmap),         SCMP_SYS(mremap),
    SCMP_SYS(madvise),       SCMP_SYS(brk),          SCMP_SYS(futex),          SCMP_SYS(exit),
    SCMP_SYS(exit_group),    SCMP_SYS(rt_sigreturn), SCMP_SYS(rt_sigprocmask), SCMP_SYS(restart_syscall),
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday),   SCMP_SYS(time),
    SCMP_SYS(getpid),        SCMP_SYS(gettid),       SCMP_SYS(getuid),         SCMP_SYS(geteuid),
    SCMP_SYS(getrandom),     SCMP_SYS(sched_yield),  SCMP_SYS(nanosleep),      SCMP_SYS(clock_nanosleep),
    SCMP_SYS(getrusage),     SCMP_SYS(sysinfo),      SCMP_SYS(uname),          SCMP_SYS(sched_getaffinity),
};

/// Innocent programs ask these without need (is stdout a terminal?): they get an error, and are not reported.
constexpr std::array quietly_refused = {SCMP_SYS(ioctl), SCMP_SYS(fcntl), SCMP_SYS(readlink), SCMP_SYS(newfstatat), SCMP_SYS(access), SCMP_SYS(faccessat2)};

Filter run_filter(bool may_open)
{
    const Context rules = context(SCMP_ACT_TRAP);
    for (const int call : always) check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, call, 0), "seccomp_rule_add");
    for (const int call : quietly_refused)
        if (!(may_open && call == SCMP_SYS(newfstatat))) check(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), call, 0), "seccomp_rule_add");
    if (may_open) {
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), 0), "seccomp_rule_add");
        // The second filter is still to come; a filter of the student's own could only take away.
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, SCMP_SYS(seccomp), 0), "seccomp_rule_add");
        // Opening for reading only; which files, Landlock decides.
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ALLOW, SCMP_SYS(openat), 1, SCMP_A2_32(SCMP_CMP_MASKED_EQ, O_ACCMODE | O_CREAT | O_TRUNC, O_RDONLY)),
              "seccomp_rule_add");
    }
    return program(rules);
}

}

Filter loading_filter() { return run_filter(true); }
Filter running_filter() { return run_filter(false); }

Filter compiler_filter()
{
    const Context rules = context(SCMP_ACT_ALLOW);
    for (const int call : {SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(mount),
                           SCMP_SYS(umount2), SCMP_SYS(pivot_root), SCMP_SYS(keyctl), SCMP_SYS(add_key), SCMP_SYS(request_key), SCMP_SYS(bpf),
                           SCMP_SYS(unshare), SCMP_SYS(setns), SCMP_SYS(perf_event_open), SCMP_SYS(io_uring_setup), SCMP_SYS(userfaultfd)})
        check(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), call, 0), "seccomp_rule_add");
    return program(rules);
}

void install(const Filter& filter)
{
    const sock_fprog described{static_cast<unsigned short>(filter.size()), const_cast<sock_filter*>(filter.data())};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &described) != 0) throw std::system_error(errno, std::generic_category(), "seccomp");
}

std::string call_name(unsigned number)
{
    const std::unique_ptr<char, decltype(&std::free)> name(seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, static_cast<int>(number)), &std::free);
    return name ? std::string(name.get()) : "call " + std::to_string(number);
}

}
