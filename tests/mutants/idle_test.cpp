#include <gtest/gtest.h>

#include "mutants/idle_unit.hpp"
#include "support/workbench.hpp"

// A program that does nothing earns nothing.
namespace umbral::grader::test {
namespace {

TEST(Idle, program_earns_what_checks_hang_on_no_other)
{
    const Workbench bench;
    Worker worker(bench.tools());
    const std::filesystem::path finder = bench.tools().programs / "umbral-mutate";
    if (!std::filesystem::exists(finder))
        GTEST_SKIP() << "NO MUTANTS: umbral-mutate was not built, for lack of libclang";
    Exercise unit = bench.exercise("pipeline/draw-deferred");
    const IdleUnit idle = try_idle(worker, finder, unit, 0);
    EXPECT_EQ(idle.trouble, "");
    EXPECT_TRUE(idle.holds()) << idle.credit;
    // What it passes when nothing hangs on anything: OpenGL's state is as it was.
    for (Check& check : unit.checks) check.with.clear();
    const IdleUnit alone = try_idle(worker, finder, unit, 0);
    EXPECT_FALSE(alone.holds());
    EXPECT_EQ(alone.earning.back(), "state/state 1.00 of 1.00");
}

// Who gives back each vector keeps its length, and each product of two.
TEST(Idle, program_that_gives_back_what_it_was_given_keeps_lengths)
{
    const Workbench bench;
    Worker worker(bench.tools());
    const std::filesystem::path finder = bench.tools().programs / "umbral-mutate";
    if (!std::filesystem::exists(finder))
        GTEST_SKIP() << "NO MUTANTS: umbral-mutate was not built, for lack of libclang";
    Exercise unit = bench.exercise("transforms/rotation-identities");
    const IdleUnit echo = try_idle(worker, finder, unit, 0, MutantFamily::echo);
    EXPECT_EQ(echo.trouble, "");
    EXPECT_TRUE(echo.holds()) << echo.credit;
    for (Check& check : unit.checks) check.with.clear();
    EXPECT_FALSE(try_idle(worker, finder, unit, 0, MutantFamily::echo).holds());
}

}
}
