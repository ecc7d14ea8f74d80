#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "raw_calls.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

/// Hostile statements; each says "name result" of what it tried. All results must be errors.
struct Attack {
    const char* name;
    const char* code;
    const char* refused;  ///< the call that the report must name when the case is running; nullptr if it fails without
                          ///< being named
};

const std::vector<Attack> attacks = {
    {"open_passwd", R"(say("open", raw(SYS_openat, AT_FDCWD, "/etc/passwd", O_RDONLY));)", "openat"},
    {"open_reference_source", R"(say("open", raw(SYS_openat, AT_FDCWD, REFERENCE, O_RDONLY));)", "openat"},
    {"open_reference_library", R"(say("open", raw(SYS_openat, AT_FDCWD, REFERENCE_LIBRARY, O_RDONLY));)", "openat"},
    {"open_other_build",
     R"(say("open", raw(SYS_openat, AT_FDCWD, OTHER_BUILD, O_RDONLY)); )"
     R"(say("directory", raw(SYS_openat, AT_FDCWD, CACHE, O_RDONLY));)",
     "openat"},
    {"takes_memory_from_the_machine",
     R"(void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); )"
     R"(for (int advice : {100, 101}) say("madvise", raw(SYS_madvise, page, 4096, advice));)",
     nullptr},
    {"shared_memory",
     R"(for (int kind : {0x01, 0x03, 0x21}) )"
     R"(say("mmap", raw(SYS_mmap, 0, 1 << 20, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | kind, -1, 0));)",
     "mmap"},
    {"open_maps", R"(say("open", raw(SYS_openat, AT_FDCWD, "/proc/self/maps", O_RDONLY));)", "openat"},
    {"open_mem",
     R"(say("open", raw(SYS_openat, AT_FDCWD, "/proc/self/mem", O_RDWR)); )"
     R"(say("read", raw(SYS_openat, AT_FDCWD, "/proc/self/mem", O_RDONLY));)",
     "openat"},
    {"openat2", R"(long how[3] = {0, 0, 0}; say("openat2", raw(437, AT_FDCWD, "/etc/passwd", how, 24));)", "openat2"},
    {"write_file", R"(say("open", raw(SYS_openat, AT_FDCWD, CACHE "/planted", O_CREAT | O_WRONLY, 0600));)", "openat"},
    {"write_tmp", R"(say("open", raw(SYS_openat, AT_FDCWD, "/tmp/umbral-planted", O_CREAT | O_WRONLY, 0600));)",
     "openat"},
    {"socket",
     R"(for (int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK}) )"
     R"(say("socket", raw(SYS_socket, family, SOCK_STREAM, 0));)",
     "socket"},
    {"connect",
     R"(sockaddr_in to{}; to.sin_family = AF_INET; for (int fd = 0; fd < 32; )"
     R"(++fd) say("connect", raw(SYS_connect, fd, &to, sizeof to));)",
     "connect"},
    {"sendmsg", R"(msghdr m{}; for (int fd = 3; fd < 32; ++fd) say("sendmsg", raw(SYS_sendmsg, fd, &m, 0));)",
     "sendmsg"},
    {"clone", R"(say("clone", raw(SYS_clone, SIGCHLD, 0, 0, 0, 0));)", "clone"},
    {"clone_thread", R"(static char stack[65536]; say("clone", raw(SYS_clone, 0x50f00, stack + 65536, 0, 0, 0));)",
     "clone"},
    {"clone3", R"(long args[11] = {0, 0, 0, 0, SIGCHLD}; say("clone3", raw(435, args, sizeof args));)", "clone3"},
#ifdef SYS_fork
    {"fork", R"(say("fork", raw(SYS_fork));)", "fork"},
    {"vfork", R"(say("vfork", raw(SYS_vfork));)", "vfork"},
#endif
    {"execve",
     R"(const char* const words[] = {"/bin/sh", nullptr}; say("execve", raw(SYS_execve, words[0], words, words + 1));)",
     "execve"},
    {"execveat",
     R"(const char* const words[] = {"/bin/sh", nullptr}; )"
     R"(say("execveat", raw(SYS_execveat, AT_FDCWD, words[0], words, words + 1, 0));)",
     "execveat"},
    {"kill_parent",
     R"(say("getppid", raw(SYS_getppid)); say("kill", raw(SYS_kill, raw(SYS_getppid), SIGKILL)); )"
     R"(say("all", raw(SYS_kill, -1, SIGKILL));)",
     "kill"},
    {"tgkill", R"(say("tgkill", raw(SYS_tgkill, 1, 1, SIGKILL)); say("tkill", raw(SYS_tkill, 1, SIGKILL));)", "tgkill"},
    {"pidfd", R"(say("open", raw(434, 1, 0)); say("signal", raw(424, 3, SIGKILL, 0, 0));)", "pidfd_open"},
    {"ptrace", R"(say("ptrace", raw(SYS_ptrace, 16, 1, 0, 0)); say("traceme", raw(SYS_ptrace, 0, 0, 0, 0));)",
     "ptrace"},
    {"process_vm_readv",
     R"(char b[8]; long v[2] = {(long)b, 8}; say("read", raw(SYS_process_vm_readv, 1, v, 1, v, 1, 0)); )"
     R"(say("write", raw(SYS_process_vm_writev, 1, v, 1, v, 1, 0));)",
     "process_vm_readv"},
    {"setrlimit",
     R"(rlimit all{RLIM_INFINITY, RLIM_INFINITY}; for (int r = 0; r < 16; )"
     R"(++r) say("prlimit64", raw(SYS_prlimit64, 0, r, &all, 0)); )"
     R"(say("setrlimit", raw(SYS_setrlimit, RLIMIT_AS, &all));)",
     "prlimit64"},
    {"prctl",
     R"(say("dumpable", raw(SYS_prctl, 4, 1, 0, 0, 0)); say("pdeathsig", raw(SYS_prctl, 1, 0, 0, 0, 0)); )"
     R"(say("seccomp", raw(SYS_prctl, 22, 0, 0, 0, 0));)",
     "prctl"},
    {"sigaction",
     R"(long action[4] = {0, 0, 0, 0}; say("sigaction", raw(SYS_rt_sigaction, SIGSYS, action, 0, 8)); )"
     R"(say("altstack", raw(SYS_sigaltstack, 0, 0));)",
     "rt_sigaction"},
    {"io_uring", R"(char p[256] = {}; say("setup", raw(425, 8, p)); say("enter", raw(426, 3, 0, 0, 0, 0, 0));)",
     "io_uring_setup"},
    {"memfd", R"(say("memfd", raw(SYS_memfd_create, "x", 0)); say("secret", raw(447, 0));)", "memfd_create"},
    {"unshare",
     R"(say("unshare", raw(SYS_unshare, 0x10000000)); say("setns", raw(SYS_setns, 3, 0)); )"
     R"(say("chroot", raw(SYS_chroot, "/")); say("mount", raw(SYS_mount, 0, "/", 0, 4096, 0));)",
     "unshare"},
    {"keys_and_bpf",
     R"(say("bpf", raw(SYS_bpf, 0, 0, 0)); say("keyctl", raw(SYS_keyctl, 0, 0, 0)); )"
     R"(say("userfaultfd", raw(SYS_userfaultfd, 0)); say("perf", raw(SYS_perf_event_open, 0, 0, -1, -1, 0));)",
     "bpf"},
    {"link_and_remove",
     R"(say("symlink", raw(SYS_symlinkat, "/etc/passwd", AT_FDCWD, CACHE "/link")); )"
     R"(say("unlink", raw(SYS_unlinkat, AT_FDCWD, OTHER_BUILD, 0)); )"
     R"(say("rename", raw(SYS_renameat2, AT_FDCWD, OTHER_BUILD, AT_FDCWD, CACHE "/away", 0)); )"
     R"(say("mkdir", raw(SYS_mkdirat, AT_FDCWD, CACHE "/made", 0700)); )"
     R"(say("chmod", raw(SYS_fchmodat, AT_FDCWD, OTHER_BUILD, 0));)",
     "unlinkat"},
    {"priority",
     R"(say("nice", raw(SYS_setpriority, 0, 0, -20)); say("affinity", raw(SYS_sched_setaffinity, 0, 0, 0)); )"
     R"(say("scheduler", raw(SYS_sched_setscheduler, 0, 1, 0));)",
     "setpriority"},
    {"no_such_call", R"(say("call", raw(9999)); say("call", raw(-1));)", "call 9999"},
    {"timers_and_alarms",
     R"(long v[4] = {0, 1, 0, 1}; say("itimer", raw(SYS_setitimer, 0, v, 0)); )"
     R"(say("timer", raw(SYS_timer_create, 0, 0, 0));)",
     "setitimer"},
    {"ioctl_of_terminal",
     R"(char c = 'x'; for (int fd = 0; fd < 3; ++fd) say("ioctl", raw(SYS_ioctl, fd, 0x5412, &c)); )"
     R"(say("fcntl", raw(SYS_fcntl, 1, F_SETFL, 0)); say("fcntl", raw(SYS_fcntl, 1, 1033, 0));)",
     nullptr},
};

class Attacks : public testing::TestWithParam<std::tuple<Attack, bool>> {
protected:
    [[nodiscard]] std::string defines() const
    {
        const auto define = [](const char* name, const std::filesystem::path& path) {
            return std::string("#define ") + name + " \"" + path.string() + "\"\n";
        };
        return define("REFERENCE", bench.tools().reference / "raytracing" / "sphere.cpp") +
               define("REFERENCE_LIBRARY", reference) + define("OTHER_BUILD", other_build) +
               define("CACHE", bench.tools().cache);
    }

    Workbench bench;
    std::filesystem::path reference = unit_folder(bench.tools(), "raytracing/sphere") / "reference.so";
    std::filesystem::path other_build = bench.write("cache/builds/aa/other/student.so", "somebody's work");
};

std::vector<long> results_in(const std::string& output)
{
    std::vector<long> results;
    std::istringstream lines(output);
    std::string what;
    for (long got = 0; lines >> what >> got;) results.push_back(got);
    return results;
}

TEST_P(Attacks, get_errors_only_and_leave_the_spawner_in_order)
{
    const auto& [attack, at_start] = GetParam();
    const std::string body = std::string("void attack()\n{\n") + attack.code + "\n}\n";
    const std::string text =
        at_start ? sphere_with(
                       raw_calls + defines() + "namespace {\n" + body + "const bool done = (attack(), true);\n}\n", "")
                 : sphere_with(raw_calls + defines() + "namespace {\n" + body + "}\n",
                               "static const bool done = (attack(), true); (void)done;");
    const std::filesystem::path library = bench.compile_sphere(text);

    Spawner spawner(bench.spawner());
    const RunOutcome good = spawner.run(bench.sphere_run(reference));
    ASSERT_EQ(good.verdict, Verdict::ok) << good.message;
    const RunOutcome outcome = spawner.run(bench.sphere_run(library));

    // A refused call fails, and the code may go on: what it computes is judged.
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    const std::vector<long> results = results_in(outcome.output);
    EXPECT_FALSE(results.empty()) << outcome.output;
    for (const long result : results) EXPECT_LT(result, 0) << outcome.output;
    if (attack.refused != nullptr && !at_start) {
        EXPECT_NE(std::find(outcome.refused.begin(), outcome.refused.end(), attack.refused), outcome.refused.end())
            << testing::PrintToString(outcome.refused);
    }
    EXPECT_TRUE(std::filesystem::exists(other_build));
    EXPECT_FALSE(std::filesystem::exists("/tmp/umbral-planted"));
    EXPECT_FALSE(std::filesystem::exists(bench.tools().cache / "planted"));

    const RunOutcome after = spawner.run(bench.sphere_run(reference));
    EXPECT_EQ(after.verdict, Verdict::ok) << after.message;
    EXPECT_EQ(after.recording.tensors.at("t").bytes, good.recording.tensors.at("t").bytes);
}

INSTANTIATE_TEST_SUITE_P(All, Attacks, testing::Combine(testing::ValuesIn(attacks), testing::Bool()),
                         [](const auto& one) {
                             return std::string(std::get<0>(one.param).name) +
                                    (std::get<1>(one.param) ? "_at_start" : "_in_the_case");
                         });

}
}
