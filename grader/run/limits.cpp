#include <linux/capability.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "run/sandbox.hpp"

namespace umbral::grader::sandbox {

void drop_privileges()
{
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        throw std::system_error(errno, std::generic_category(), "prctl(PR_SET_NO_NEW_PRIVS)");
}

void drop_capabilities()
{
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
    if (syscall(SYS_capset, &header, none.data()) != 0)
        throw std::system_error(errno, std::generic_category(), "capset");
}

std::vector<std::string> enter_namespaces(bool processes)
{
    // One by one where the whole does not work: inside containers some are allowed and others not. The user namespace
    // comes first, since it gives the right to make the others.
    struct Kind {
        int flag;
        const char* name;
    };
    std::vector<std::string> entered;
    for (const Kind kind : {Kind{CLONE_NEWUSER, "user namespace"}, Kind{CLONE_NEWNET, "network namespace"},
                            Kind{CLONE_NEWIPC, "IPC namespace"}, Kind{CLONE_NEWUTS, "UTS namespace"},
                            Kind{CLONE_NEWPID, "process namespace"}}) {
        if (kind.flag == CLONE_NEWPID && !processes) continue;
        if (unshare(kind.flag) == 0) entered.emplace_back(kind.name);
    }
    return entered;
}

void limit_resources(const ResourceLimits& limits)
{
    const auto set = [](__rlimit_resource resource, std::uint64_t value, std::uint64_t hard = 0) {
        const rlimit both{value, std::max(value, hard)};
        if (setrlimit(resource, &both) != 0)
            throw std::system_error(errno, std::generic_category(), "setrlimit " + std::to_string(resource));
    };
    set(RLIMIT_CORE, 0);
    // Whatever the shell has that the grader was started from; compilers may still take more.
    rlimit stack{};
    if (getrlimit(RLIMIT_STACK, &stack) == 0) {
        stack.rlim_cur = std::min(stack.rlim_max, rlim_t{ResourceLimits::stack});
        (void)setrlimit(RLIMIT_STACK, &stack);
    }
    if (limits.address_space != 0) set(RLIMIT_AS, limits.address_space);
    // The soft limit ends a process by a signal of its own, which its parent can tell from others; the hard one by
    // SIGKILL.
    if (limits.cpu_seconds != 0) set(RLIMIT_CPU, limits.cpu_seconds, limits.cpu_seconds + 1);
    if (limits.file_size != 0) set(RLIMIT_FSIZE, limits.file_size);
    if (limits.descriptors != 0) set(RLIMIT_NOFILE, limits.descriptors);
    if (limits.no_children) set(RLIMIT_NPROC, 0);
}

}
