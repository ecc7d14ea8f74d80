#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <thread>

#include "busy_machine.hpp"
#include "old_calls.hpp"
#include "raw_calls.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

/// All descendants of a process, by their numbers.
std::vector<pid_t> descendants(pid_t of)
{
    std::vector<pid_t> found;
    for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(of) + "/task")) {
        std::ifstream children(task.path() / "children");
        for (pid_t child = 0; children >> child;) {
            found.push_back(child);
            const std::vector<pid_t> below = descendants(child);
            found.insert(found.end(), below.begin(), below.end());
        }
    }
    return found;
}

bool lives(pid_t process)
{
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string number;
    std::string name;
    std::string state;
    return static_cast<bool>(stat >> number >> name >> state) && state != "Z" && state != "X";
}

class SpawnerTest : public testing::Test {
protected:
    Workbench bench;
    fs::path reference = unit_folder(bench.tools(), "raytracing/sphere") / "reference.so";

    /// Runs what is handed in, and then good work with the same spawner.
    RunOutcome run_and_recover(const std::string& text)
    {
        const fs::path library = bench.compile_sphere(text);
        Spawner spawner(bench.spawner());
        const RunOutcome before = spawner.run(bench.sphere_run(reference));
        RunRequest request = bench.sphere_run(library);
        request.limits.wall_seconds = 1;
        RunOutcome outcome = spawner.run(request);
        const RunOutcome after = spawner.run(bench.sphere_run(reference));
        EXPECT_EQ(after.verdict, Verdict::ok) << after.message;
        EXPECT_EQ(after.recording.tensors, before.recording.tensors);
        return outcome;
    }
};

TEST_F(SpawnerTest, names_the_protections_it_saw_work)
{
    const Spawner spawner(bench.spawner());
    const auto& seen = spawner.protections();
    for (const char* const wanted : {"resource limits", "no new privileges", "seccomp"}) {
        EXPECT_NE(std::find(seen.begin(), seen.end(), wanted), seen.end()) << wanted;
    }
    EXPECT_TRUE(spawner.gl().empty());
}

TEST_F(SpawnerTest, keeps_what_was_printed_within_bounds)
{
    const RunOutcome outcome = run_and_recover(
        sphere_with("", "    static int lines = 0;\n    while (lines < 1 << 17) std::printf(\"%079d\\n\", lines++);"));
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    EXPECT_GT(outcome.output.size(), std::size_t{32} << 10U);
    EXPECT_LE(outcome.output.size(), (std::size_t{64} << 10U) + 100);
}

TEST_F(SpawnerTest, prints_no_control_characters)
{
    const RunOutcome outcome = run_and_recover(sphere_with("",
                                                           "    for (int i = 0; i < 4096; ++i) std::putchar(i * 37);\n "
                                                           "   std::printf(\"\\033[2J\\033]0;owned\\007 text\\n\");"));
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    EXPECT_NE(outcome.output.find("text"), std::string::npos);
    for (const char c : outcome.output)
        EXPECT_TRUE(c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20) << static_cast<int>(c);
}

TEST_F(SpawnerTest, survives_closed_descriptors)
{
    const RunOutcome outcome = run_and_recover(sphere_with(
        raw_calls, "    for (int fd = 0; fd < 1000; ++fd) raw(SYS_close, fd);\n    std::printf(\"gone\\n\");"));
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
}

TEST_F(SpawnerTest, survives_closed_descriptors_while_loading)
{
    const RunOutcome outcome =
        run_and_recover(sphere_with(raw_calls + "static int shut() { for (int fd = 0; fd < 1000; ++fd) raw(SYS_close, "
                                                "fd); return 1; }\nstatic const int value = shut();\n",
                                    "    if (value == 7) return std::nullopt;"));
    EXPECT_NE(outcome.verdict, Verdict::grader_fault) << outcome.message;
}

// int 0x80 enters the kernel by its old numbers: a filter that looks at numbers only would take fork for read.
TEST_F(SpawnerTest, stops_calls_of_another_architecture)
{
    if (!takes_old_calls()) GTEST_SKIP() << "this kernel takes no 32-bit calls";
    const RunOutcome outcome =
        run_and_recover(sphere_with("",
                                    "    long got = 2;\n    asm volatile(\"int $0x80\" : \"+a\"(got) : : "
                                    "\"memory\");\n    std::printf(\"fork %ld\\n\", got);\n    std::fflush(stdout);"));
    if (outcome.verdict == Verdict::ok) {
        EXPECT_NE(outcome.output.find("fork -"), std::string::npos) << outcome.output;
    } else {
        EXPECT_EQ(outcome.verdict, Verdict::blocked) << outcome.message;
    }
}

TEST_F(SpawnerTest, a_filter_of_the_students_own_gives_no_rights)
{
    const std::string lying_filter = R"(
static int lie()
{
    // seccomp() shall claim success without doing anything: then the grader's second filter would be missing.
    sock_filter code[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_seccomp, 0, 1),
                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    sock_fprog program{4, code};
    say("install", raw(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program));
    return 1;
}
static const int value = lie();
)";
    const RunOutcome outcome = run_and_recover(sphere_with(raw_calls + lying_filter, R"(
    if (value == 7) return std::nullopt;
    say("passwd", raw(SYS_openat, AT_FDCWD, "/etc/passwd", O_RDONLY));
    say("reference", raw(SYS_openat, AT_FDCWD, ")" + reference.string() + R"(", O_RDONLY));
    say("socket", raw(SYS_socket, AF_INET, SOCK_STREAM, 0));)"));
    for (const char* const line : {"passwd -", "reference -", "socket -"})
        EXPECT_NE(outcome.output.find(line), std::string::npos) << outcome.output;
}

TEST_F(SpawnerTest, a_filled_stack_is_told)
{
    const RunOutcome outcome =
        run_and_recover(sphere_with("static float fill(float x) { volatile char room[1 << 16]; for (std::size_t i = 0; "
                                    "i < sizeof room; i += 64) room[i] = 1; "
                                    "return x < 0 ? x : fill(x + 1) + room[0]; }\n",
                                    "    if (fill(1) == 7) return std::nullopt;"));
    EXPECT_EQ(outcome.verdict, Verdict::crashed);
    EXPECT_EQ(outcome.recording.note, wire::Note::stack_overflow) << outcome.message;
}

TEST_F(SpawnerTest, starts_again_when_it_was_killed)
{
    Spawner spawner(bench.spawner());
    const RunOutcome before = spawner.run(bench.sphere_run(reference));
    for (int round = 0; round < 3; ++round) {
        for (const pid_t process : descendants(getpid())) kill(process, SIGKILL);
        const RunOutcome after = spawner.run(bench.sphere_run(reference));
        EXPECT_EQ(after.verdict, Verdict::ok) << after.message;
        EXPECT_EQ(after.recording.tensors, before.recording.tensors);
    }
}

/// How many turns of an empty loop take so much time of a processor.
long turns_in(double seconds)
{
    constexpr long some = 20'000'000;
    const std::clock_t start = std::clock();
    volatile long i = 0;
    while (i < some) i = i + 1;
    return static_cast<long>(seconds * CLOCKS_PER_SEC / static_cast<double>(std::clock() - start) * some);
}

// Right work that computes for less than its time is right, however busy the machine is.
TEST_F(SpawnerTest, waiting_for_a_processor_is_no_time_of_the_run)
{
    const BusyMachine busy;
    const std::string loop = "    static bool done = false;\n    for (volatile long i = 0; !done && i < " +
                             std::to_string(turns_in(0.5)) + "; i = i + 1) {}\n    done = true;";
    const RunOutcome outcome = run_and_recover(sphere_with("", loop));
    EXPECT_EQ(outcome.verdict, Verdict::ok) << outcome.message;
    EXPECT_GT(outcome.wall_seconds, 1) << "or it shows nothing";
    EXPECT_LT(outcome.cpu_seconds, 1);
}

TEST_F(SpawnerTest, a_program_that_is_none_is_told)
{
    EXPECT_THROW(Spawner(bench.tools().programs / "umbral-no-such"), std::exception);
    EXPECT_THROW(Spawner("/bin/true"), std::exception);
}

// A grader that is killed in the middle of a run leaves no process behind.
TEST_F(SpawnerTest, ends_with_the_grader)
{
    const Built built = bench.build_sphere(sphere_with("", "    for (volatile int i = 0;; i = i + 1) {}"));
    ASSERT_EQ(built.verdict, Verdict::ok) << built.message;
    RunRequest request = bench.sphere_run(built.library);
    request.limits.wall_seconds = 60;
    const pid_t grader = fork();
    if (grader == 0) {
        Spawner spawner(bench.spawner());
        (void)spawner.run(request);
        _exit(0);
    }
    // The spawner (two processes where it has a namespace) and the run: wait until the run is at work.
    std::vector<pid_t> all;
    for (int i = 0; i < 200; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::vector<pid_t> now = descendants(grader);
        const bool steady = now.size() >= 2 && now == all;
        all = std::move(now);
        if (steady && i > 50) break;
    }
    ASSERT_GE(all.size(), 2U);
    kill(grader, SIGKILL);
    waitpid(grader, nullptr, 0);
    for (int i = 0; i < 250 && std::any_of(all.begin(), all.end(), lives); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(std::any_of(all.begin(), all.end(), lives));
}

}
}
