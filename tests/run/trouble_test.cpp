#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "support/workbench.hpp"

// What a machine that lacks something does to a run, and how a crash is named.
namespace umbral::grader::test {
namespace {

/// No file can be opened while it lives.
class NoFilesLeft {
public:
    NoFilesLeft()
    {
        getrlimit(RLIMIT_NOFILE, &before_);
        rlimit none = before_;
        none.rlim_cur = 0;
        setrlimit(RLIMIT_NOFILE, &none);
    }
    NoFilesLeft(const NoFilesLeft&) = delete;
    NoFilesLeft& operator=(const NoFilesLeft&) = delete;
    ~NoFilesLeft() { setrlimit(RLIMIT_NOFILE, &before_); }

private:
    rlimit before_{};
};

template <class Work>
std::string message_of(Work work)
{
    try {
        work();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(MachineTroubleOfRuns, no_open_file_left_is_named_and_heals)
{
    const Workbench bench;
    const RunRequest request = bench.sphere_run(unit_folder(bench.tools(), "raytracing/sphere") / "reference.so");
    Spawner spawner(bench.spawner());
    ASSERT_EQ(spawner.run(request).verdict, Verdict::ok);
    {
        const NoFilesLeft none;
        EXPECT_NE(message_of([&] { (void)spawner.run(request); }).find("no open file left"), std::string::npos);
        EXPECT_NE(message_of([&] { const Spawner other(bench.spawner()); }).find("no open file left"),
                  std::string::npos);
    }
    EXPECT_EQ(spawner.run(request).verdict, Verdict::ok);
}

TEST(MachineTroubleOfRuns, a_spawner_that_cannot_get_ready_says_why)
{
    // As a user whose processes are all taken. Root has no such limit.
    if (getuid() != 0) GTEST_SKIP() << "needs root, to become a user with no process left";
    const Workbench bench;
    const pid_t child = fork();
    if (child == 0) {
        const rlimit none{0, 0};
        setrlimit(RLIMIT_NPROC, &none);
        if (setgid(65534) != 0 || setuid(65534) != 0) _exit(3);
        const std::string said = message_of([&] { const Spawner spawner(bench.spawner()); });
        // Where nobody may not read this build, nothing can be said of it.
        if (access(bench.spawner().c_str(), X_OK) != 0) _exit(4);
        _exit(said.find("no process left") != std::string::npos ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 4) GTEST_SKIP() << "this build is not readable by others";
    EXPECT_EQ(status, 0);
}

RunOutcome run_sphere(const Workbench& bench, const std::string& text)
{
    const Built built = bench.build_sphere(text);
    EXPECT_EQ(built.verdict, Verdict::ok) << built.message;
    Spawner spawner(bench.spawner());
    return spawner.run(bench.sphere_run(built.library));
}

TEST(CrashNames, a_thread_local_too_large_is_out_of_memory)
{
    const Workbench bench;
    const RunOutcome outcome = run_sphere(
        bench,
        sphere_with(
            "static thread_local char everything[std::size_t{900} << 20U];\n",
            "    everything[static_cast<int>(sphere.radius)] = 1;\n    if (everything[0] == 7) return std::nullopt;"));
    EXPECT_EQ(outcome.verdict, Verdict::out_of_memory) << outcome.message;
    EXPECT_NE(outcome.message.find("thread_local"), std::string::npos) << outcome.message;
}

TEST(CrashNames, an_array_written_beyond_its_end_is_no_endless_recursion)
{
    const Workbench bench;
    // In a function of its own, whose return address lies near, whatever the compiler keeps in that which calls it.
    const std::string fill =
        "[[gnu::noinline]] static char fill(int size)\n{\n    volatile char few[16];\n    volatile char* at = few;\n"
        "    for (int i = 0; i < size; ++i) at[i] = 65;\n    return few[3];\n}\n";
    // Far: to the end of the stack. Near: over the return address.
    for (const char* const size : {"1 << 24", "200"}) {
        const std::string body = std::string("    if (fill(") + size + ") == 7) return std::nullopt;";
        const RunOutcome outcome = run_sphere(bench, sphere_with(fill, body));
        EXPECT_EQ(outcome.verdict, Verdict::crashed);
        EXPECT_EQ(outcome.message.find("itself"), std::string::npos) << outcome.message;
        EXPECT_NE(outcome.message.find("beyond its end"), std::string::npos) << size << ": " << outcome.message;
    }
}

TEST(CrashNames, recursion_without_end_is)
{
    const Workbench bench;
    for (const char* const room : {"16", "1 << 16", "1 << 19"}) {
        const RunOutcome outcome = run_sphere(
            bench,
            sphere_with(std::string("static float fill(float x) { volatile char room[") + room +
                            "]; room[0] = 1; room[sizeof room - 1] = 2; return x < 0 ? x : fill(x + 1) + room[0]; }\n",
                        "    if (fill(1) == 7) return std::nullopt;"));
        EXPECT_NE(outcome.message.find("itself without end"), std::string::npos) << room << ": " << outcome.message;
    }
}

}
}
