#include <gtest/gtest.h>
#include <sys/syscall.h>

#include <chrono>
#include <functional>

#include "busy_machine.hpp"
#include "run/processor_wait.hpp"

namespace umbral::grader::test {
namespace {

/// What a process waited for a processor that did `work` for half a second.
double waited_by(const std::function<void()>& work)
{
    const pid_t child = fork();
    if (child == 0)
        for (;;) work();
    const Descriptor process(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
    const ProcessorWait waited(process.get());
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const double seconds = waited.seconds();
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(waited.seconds(), 0) << "it is over";
    return seconds;
}

void compute()
{
    std::atomic<int> turns = 0;
    while (turns < 1000) ++turns;
}

TEST(ProcessorWait, counts_the_time_that_others_took)
{
    const BusyMachine busy;
    EXPECT_GT(waited_by(compute), 0.1);
}

TEST(ProcessorWait, is_not_what_a_process_sleeps)
{
    EXPECT_LT(waited_by([] { std::this_thread::sleep_for(std::chrono::seconds(1)); }), 0.1);
}

TEST(ProcessorWait, is_unknown_of_what_is_no_process) { EXPECT_EQ(ProcessorWait(-1).seconds(), 0); }

}
}
