#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "worker/shared_runs.hpp"

namespace umbral::grader::test {
namespace {

RunOutcome run_of(double seconds, std::size_t bytes = 0)
{
    RunOutcome outcome;
    outcome.cpu_seconds = seconds;
    outcome.recording.tensors["value"].bytes.resize(bytes);
    return outcome;
}

TEST(SharedRuns, makes_each_run_once_for_all_who_ask_at_the_same_time)
{
    SharedRuns runs;
    std::atomic<int> made = 0;
    std::vector<SharedRuns::Run> got(4);
    {
        std::vector<std::jthread> threads;
        for (SharedRuns::Run& one : got)
            threads.emplace_back([&] {
                one = runs.get("sphere", [&] {
                    ++made;
                    std::this_thread::sleep_for(std::chrono::milliseconds(20));
                    return run_of(3);
                });
            });
    }
    EXPECT_EQ(made, 1);
    for (const SharedRuns::Run& one : got) EXPECT_EQ(one, got.front());
    EXPECT_EQ(got.front()->cpu_seconds, 3);
}

TEST(SharedRuns, may_need_another_run)
{
    SharedRuns runs;
    const SharedRuns::Run run =
        runs.get("mistake", [&] { return run_of(1 + runs.get("reference", [] { return run_of(1); })->cpu_seconds); });
    EXPECT_EQ(run->cpu_seconds, 2);
}

TEST(SharedRuns, tries_again_what_could_not_be_made)
{
    SharedRuns runs;
    const auto fails = []() -> RunOutcome { throw std::runtime_error("no room on the disk"); };
    EXPECT_THROW((void)runs.get("sphere", fails), std::runtime_error);
    EXPECT_EQ(runs.get("sphere", [] { return run_of(4); })->cpu_seconds, 4);
}

TEST(SharedRuns, forgets_when_they_take_too_much_and_leaves_what_is_in_use)
{
    SharedRuns runs;
    constexpr std::size_t large = std::size_t{200} << 20U;
    const SharedRuns::Run first = runs.get("first", [] { return run_of(1, large); });
    const SharedRuns::Run second = runs.get("second", [] { return run_of(2, large); });
    EXPECT_EQ(first->cpu_seconds, 1);
    EXPECT_EQ(runs.get("first", [] { return run_of(5); })->cpu_seconds, 5);
}

}
}
