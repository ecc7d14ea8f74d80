#include "run/confine.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "support/temporary_folder.hpp"
#include "support/workbench.hpp"

// Programs that only compilers' files may be read by.
namespace umbral::grader::test {
namespace {

using umbral::test::TemporaryFolder;

/// Is `happens` so within ten seconds?
template <class Happens>
bool soon(const Happens& happens)
{
    for (int i = 0; i < 200 && !happens(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return happens();
}

pid_t process_in(const std::filesystem::path& file)
{
    pid_t process = 0;
    std::ifstream(file) >> process;
    return process;
}

bool is_running(pid_t process) { return std::filesystem::exists("/proc/" + std::to_string(process)); }

// A compiler is a program that starts others.
TEST(Confine, what_a_program_started_ends_with_the_grader)
{
    const TemporaryFolder folder;
    const pid_t grader = fork();
    ASSERT_GE(grader, 0);
    if (grader == 0) {
        ConfinedCommand command;
        command.confine = Workbench().tools().programs / "umbral-confine";
        command.directory = folder.path();
        command.cpu_seconds = 60;
        command.wall_seconds = 60;
        command.read = {"/bin/*", "/usr/bin/*"};
        command.arguments = {"/bin/sh", "-c", "sleep 60 & echo $! >started.part; mv started.part started; wait"};
        (void)run_confined(command);
        _exit(0);
    }
    const bool has_started = soon([&] { return process_in(folder / "started") != 0; });
    const pid_t sleeper = process_in(folder / "started");
    EXPECT_TRUE(has_started && is_running(sleeper)) << sleeper;
    kill(grader, SIGKILL);
    waitpid(grader, nullptr, 0);
    EXPECT_TRUE(soon([&] { return !is_running(sleeper); }));
}

}
}
