#include "attack/setting.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

namespace umbral::grader::attack {
namespace {

void check(bool good, const char* what)
{
    if (!good) throw std::system_error(errno, std::generic_category(), what);
}

/// unshare and clone with CLONE_NEWUSER fail with EPERM, as where the kernel forbids them. clone3 keeps its flags in
/// memory, where a filter cannot read them: it does not exist, and the C library takes clone instead.
void refuse_user_namespaces()
{
    const std::unique_ptr<void, decltype(&seccomp_release)> rules(seccomp_init(SCMP_ACT_ALLOW), &seccomp_release);
    const auto add = [&](int result) {
        if (result < 0) throw std::system_error(-result, std::generic_category(), "seccomp: refusing user namespaces");
    };
    // Calls of other kinds of programs stay what they are: the sandbox answers them, not this filter.
    add(seccomp_attr_set(rules.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_ALLOW));
    const auto with_flag = SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER);
    add(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), SCMP_SYS(unshare), 1, with_flag));
    add(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, with_flag));
    add(seccomp_rule_add(rules.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0));
    add(seccomp_load(rules.get()));
}

}

std::string Setting::name() const
{
    return fmt::format("{}, {}, {}",
                       as_nobody        ? "nobody"
                       : geteuid() == 0 ? "root"
                                        : "user",
                       without_namespaces ? "no user namespaces" : "user namespaces",
                       gl.empty() ? "default back end" : gl);
}

std::vector<Setting> all_settings()
{
    std::vector<Setting> settings;
    for (const char* const gl : {"osmesa", "egl"})
        for (const bool as_nobody : {false, true})
            for (const bool without_namespaces : {false, true}) settings.push_back({as_nobody, without_namespaces, gl});
    return settings;
}

std::string why_not(const Setting& setting)
{
    if (setting.as_nobody && geteuid() != 0) return "only root can become nobody";
    return "";
}

void enter(const Setting& setting)
{
    if (setting.as_nobody) {
        check(setgroups(0, nullptr) == 0, "setgroups");
        check(setresgid(nobody, nobody, nobody) == 0, "setresgid");
        check(setresuid(nobody, nobody, nobody) == 0, "setresuid");
    }
    if (setting.without_namespaces) {
        check(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "prctl(PR_SET_NO_NEW_PRIVS)");
        refuse_user_namespaces();
    }
}

}
