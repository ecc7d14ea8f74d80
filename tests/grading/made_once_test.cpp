#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "run/spawner.hpp"
#include "worker/made_once.hpp"

namespace umbral::grader::test {
namespace {

RunOutcome run_of(double seconds, std::size_t bytes = 0)
{
    RunOutcome outcome;
    outcome.cpu_seconds = seconds;
    outcome.recording.tensors["value"].bytes.resize(bytes);
    return outcome;
}

using Runs = MadeOnce<RunOutcome>;
using KeptRun = Runs::Pointer;
constexpr std::size_t mebibyte = std::size_t{1} << 20U;

/// Remembers 8 MiB of what is recorded as "value".
Runs remembering()
{
    return Runs(8 * mebibyte,
                [](const RunOutcome& outcome) { return outcome.recording.tensors.at("value").bytes.size(); });
}

TEST(MadeOnce, makes_each_run_once_for_all_who_ask_at_the_same_time)
{
    Runs runs = remembering();
    std::atomic<int> made = 0;
    std::vector<KeptRun> got(4);
    {
        std::vector<std::jthread> threads;
        for (KeptRun& one : got)
            threads.emplace_back([&] {
                one = runs.get("sphere", [&] {
                    ++made;
                    std::this_thread::sleep_for(std::chrono::milliseconds(20));
                    return run_of(3);
                });
            });
    }
    EXPECT_EQ(made, 1);
    for (const KeptRun& one : got) EXPECT_EQ(one, got.front());
    EXPECT_EQ(got.front()->cpu_seconds, 3);
}

TEST(MadeOnce, may_need_another_run)
{
    Runs runs = remembering();
    const KeptRun run =
        runs.get("mistake", [&] { return run_of(1 + runs.get("reference", [] { return run_of(1); })->cpu_seconds); });
    EXPECT_EQ(run->cpu_seconds, 2);
}

TEST(MadeOnce, tries_again_what_could_not_be_made)
{
    Runs runs = remembering();
    const auto fails = []() -> RunOutcome { throw std::runtime_error("no room on the disk"); };
    EXPECT_THROW((void)runs.get("sphere", fails), std::runtime_error);
    EXPECT_EQ(runs.get("sphere", [] { return run_of(4); })->cpu_seconds, 4);
}

TEST(MadeOnce, makes_again_what_it_was_told_to_forget)
{
    Runs runs = remembering();
    const KeptRun first = runs.get("sphere", [] { return run_of(1); });
    runs.forget("sphere");
    runs.forget("no such key");
    EXPECT_EQ(runs.get("sphere", [] { return run_of(2); })->cpu_seconds, 2);
    EXPECT_EQ(first->cpu_seconds, 1);
}

TEST(MadeOnce, forgets_what_was_not_asked_for_lately_and_leaves_what_is_in_use)
{
    Runs runs = remembering();
    const auto seconds = [&](const char* key, double if_made) {
        return runs.get(key, [&] { return run_of(if_made, 2 * mebibyte); })->cpu_seconds;
    };
    const KeptRun first = runs.get("first", [] { return run_of(1, 2 * mebibyte); });
    for (const char* const key : {"second", "third", "fourth", "fifth", "sixth"}) {
        EXPECT_EQ(seconds(key, 2), 2);
        EXPECT_EQ(seconds("first", 5), 1) << "it is asked for again and again";
    }
    EXPECT_EQ(seconds("second", 6), 6);
    for (const char* const key : {"seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth"})
        EXPECT_EQ(seconds(key, 3), 3);
    EXPECT_EQ(seconds("first", 5), 5);
    EXPECT_EQ(first->cpu_seconds, 1);
}

}
}
