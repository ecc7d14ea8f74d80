#include <gtest/gtest.h>

#include <array>
#include <bench/accuracy/timing.hpp>
#include <cmath>
#include <string>

namespace umbral::bench {
namespace {

// How often and in which order, not how long: times are not tested.
TEST(Timing, takes_turns_and_begins_each_round_with_another)
{
    std::string order;
    const std::array<std::function<void()>, 3> variants = {[&] { order += 'a'; }, [&] { order += 'b'; },
                                                           [&] { order += 'c'; }};
    const std::vector<double> fastest =
        fastest_of_interleaved(variants, {.rounds = 4, .least = 4, .seconds = 0, .turn = 0});
    EXPECT_EQ(order,
              "abc"
              "abc"
              "bca"
              "cab"
              "abc");
    ASSERT_EQ(fastest.size(), 3U);
    for (const double seconds : fastest) EXPECT_TRUE(seconds >= 0 && std::isfinite(seconds));
}

TEST(Timing, ends_when_its_time_is_over_but_not_before_the_least)
{
    int calls = 0;
    const std::array<std::function<void()>, 1> one = {[&] { ++calls; }};
    (void)fastest_of_interleaved(one, {.rounds = 1000, .least = 7, .seconds = 0, .turn = 0});
    EXPECT_EQ(calls, 1 + 7);
    EXPECT_TRUE(fastest_of_interleaved({}, {}).empty());
}

}
}
