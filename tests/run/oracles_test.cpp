#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "old_calls.hpp"
#include "raw_calls.hpp"
#include "support/workbench.hpp"

// Whether a file exists, and what an interface of the kernel other than the usual one allows, is not for a run to know.
namespace umbral::grader::test {
namespace {

/// C++ that asks by every call that takes a path, and prints "name result".
const std::string questions = R"(
#include <sys/stat.h>
#include <sys/vfs.h>
namespace {
void ask(const char* path)
{
    static char room[4096];
    struct stat status;
    say("openat", raw(SYS_openat, AT_FDCWD, path, O_RDONLY));
    say("openat_cloexec", raw(SYS_openat, AT_FDCWD, path, O_RDONLY | O_CLOEXEC));
    say("openat_path", raw(SYS_openat, AT_FDCWD, path, O_PATH));
    say("openat_directory", raw(SYS_openat, AT_FDCWD, path, O_RDONLY | O_DIRECTORY));
    say("newfstatat", raw(SYS_newfstatat, AT_FDCWD, path, &status, 0));
    say("newfstatat_empty", raw(SYS_newfstatat, AT_FDCWD, path, &status, AT_EMPTY_PATH));
    say("newfstatat_link", raw(SYS_newfstatat, AT_FDCWD, path, &status, AT_SYMLINK_NOFOLLOW));
    say("statx", raw(SYS_statx, AT_FDCWD, path, 0, 0xfff, room));
    say("faccessat", raw(SYS_faccessat, AT_FDCWD, path, 4, 0));
    say("faccessat2", raw(439, AT_FDCWD, path, 4, 0));
    say("readlinkat", raw(SYS_readlinkat, AT_FDCWD, path, room, sizeof room));
    say("statfs", raw(SYS_statfs, path, room));
    say("chdir", raw(SYS_chdir, path));
    say("openat2", raw(437, AT_FDCWD, path, room + 512, 24));
    say("name_to_handle", raw(SYS_name_to_handle_at, AT_FDCWD, path, room, room + 2048, 0));
    say("utimensat", raw(SYS_utimensat, AT_FDCWD, path, 0, 0));
    say("inotify", raw(SYS_inotify_add_watch, 9, path, 1));
    say("getxattr", raw(SYS_getxattr, path, "user.x", room, 16));
#if defined(__x86_64__)
    say("open", raw(SYS_open, path, O_RDONLY));
    say("stat", raw(SYS_stat, path, &status));
    say("lstat", raw(SYS_lstat, path, &status));
    say("access", raw(SYS_access, path, 4));
    say("readlink", raw(SYS_readlink, path, room, sizeof room));
#endif
}
}
)";

class Oracles : public testing::TestWithParam<bool> {
protected:
    /// Runs `body` before the driver is loaded, or in the case.
    RunOutcome run(const std::string& before, const std::string& body) const
    {
        const std::string text =
            GetParam()
                ? sphere_with(
                      before + "namespace {\nvoid all()\n{\n" + body + "\n}\nconst bool done = (all(), true);\n}\n", "")
                : sphere_with(before + "namespace {\nvoid all()\n{\n" + body + "\n}\n}\n",
                              "    static const bool done = (all(), true); (void)done;");
        Spawner spawner(bench.spawner());
        return spawner.run(bench.sphere_run(bench.compile_sphere(text)));
    }

    Workbench bench;
};

std::string answers(const std::string& output, const std::string& from)
{
    const std::size_t begin = output.find("ask " + from + " ");
    const std::size_t line = output.find('\n', begin);
    return output.substr(line, output.find("ask ", line) - line);
}

TEST_P(Oracles, every_path_gets_the_same_answers)
{
    const std::filesystem::path reference = unit_folder(bench.tools(), "raytracing/sphere") / "reference.so";
    const std::vector<std::string> paths{reference.string(),
                                         reference.string() + ".not",
                                         "/etc/passwd",
                                         "/etc/no-such-file",
                                         "/proc/self/maps",
                                         "/",
                                         "."};
    std::string body;
    for (std::size_t i = 0; i < paths.size(); ++i)
        body += "say(\"ask " + std::to_string(i) + "\", 0); ask(\"" + paths[i] + "\");\n";
    const RunOutcome outcome = run(raw_calls + questions, body + "say(\"ask\", 0);");
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    const std::string first = answers(outcome.output, "0");
    EXPECT_GT(std::count(first.begin(), first.end(), '\n'), 15);
    for (std::size_t i = 1; i < paths.size(); ++i)
        EXPECT_EQ(answers(outcome.output, std::to_string(i)), first) << paths[i];
    std::istringstream lines(first);
    std::string name;
    for (long got = 0; lines >> name >> got;) EXPECT_EQ(got, -EPERM) << name;
}

// Standard output is an open file, about which the C library asks.
TEST_P(Oracles, the_state_of_an_open_file_is_no_secret)
{
    const RunOutcome outcome =
        run(raw_calls + "#include <sys/stat.h>\n",
            "struct stat status{}; say(\"state\", raw(SYS_newfstatat, 1, \"\", &status, AT_EMPTY_PATH)); "
            "say(\"closed\", raw(SYS_newfstatat, 77, \"\", &status, "
            "AT_EMPTY_PATH));\nsay(\"here\", raw(SYS_newfstatat, AT_FDCWD, \"\", &status, AT_EMPTY_PATH));");
    EXPECT_NE(outcome.output.find("state 0\nclosed -9\nhere -9\n"), std::string::npos) << outcome.output;
    EXPECT_TRUE(outcome.refused.empty()) << testing::PrintToString(outcome.refused);
}

#if defined(__x86_64__)
TEST_P(Oracles, calls_through_other_interfaces_fail_and_are_named)
{
    const bool old_calls = takes_old_calls();
    const std::string old_fork =
        "long got = 2; asm volatile(\"int $0x80\" : \"+a\"(got) : : \"memory\", \"r8\", "
        "\"r9\", \"r10\", \"r11\"); say(\"old\", got);";
    const RunOutcome outcome = run(raw_calls,
                                   "say(\"x32 fork\", raw(57 | 0x40000000));\nsay(\"x32 getpid\", raw(39 | "
                                   "0x40000000));\nsay(\"x32 execve\", raw(520 | 0x40000000, 0, 0, 0));\n" +
                                       (old_calls ? old_fork : ""));
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    for (const char* const line : {"x32 fork -1\n", "x32 getpid -1\n", "x32 execve -1\n"})
        EXPECT_NE(outcome.output.find(line), std::string::npos) << outcome.output;
    if (old_calls) {
        EXPECT_NE(outcome.output.find("old -"), std::string::npos) << outcome.output;
    }
    EXPECT_NE(std::ranges::find(outcome.refused, "a call through the x32 interface"), outcome.refused.end())
        << testing::PrintToString(outcome.refused);
}
#endif

INSTANTIATE_TEST_SUITE_P(Both, Oracles, testing::Bool(),
                         [](const auto& one) { return one.param ? "while_loading" : "in_the_case"; });

}
}
