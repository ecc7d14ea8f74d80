#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>

#include "worker/at_once.hpp"

// Two things done with two workers at the same time, where there are two.
namespace umbral::grader::test {
namespace {

TEST(AtOnce, one_after_the_other_with_a_single_worker)
{
    Worker worker{Toolchain{}};
    std::string order;
    at_once(
        worker, [&](Worker& with) { order += &with == &worker ? "first " : "? "; },
        [&](Worker& with) { order += &with == &worker ? "other" : "?"; });
    EXPECT_EQ(order, "first other");
}

TEST(AtOnce, each_with_a_worker_of_its_own)
{
    Worker worker{Toolchain{}};
    worker.allow_second(true);
    const std::thread::id here = std::this_thread::get_id();
    bool is_first_here = false;
    bool is_other_elsewhere = false;
    at_once(
        worker, [&](Worker& with) { is_first_here = &with == &worker && std::this_thread::get_id() == here; },
        [&](Worker& with) { is_other_elsewhere = &with == worker.second() && std::this_thread::get_id() != here; });
    EXPECT_TRUE(is_first_here);
    EXPECT_TRUE(is_other_elsewhere);
}

TEST(AtOnce, what_either_throws_is_thrown_when_both_are_done)
{
    for (const bool has_second : {false, true}) {
        Worker worker{Toolchain{}};
        worker.allow_second(has_second);
        bool is_first_done = false;
        const auto fails = [](Worker&) { throw std::runtime_error("no"); };
        EXPECT_THROW(at_once(
                         worker, [&](Worker&) { is_first_done = true; }, fails),
                     std::runtime_error);
        EXPECT_TRUE(is_first_done);
        EXPECT_THROW(at_once(worker, fails, [](Worker&) {}), std::runtime_error);
    }
}

}
}
