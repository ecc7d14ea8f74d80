#include <gtest/gtest.h>

#include "drawn_fragments.hpp"

namespace umbral::grader::test {
namespace {

TEST(Fragments, a_moved_primitive_is_one_error_with_a_name)
{
    const std::vector<Spot> expected = drawn(7, triangle, 10, 10);
    const auto moved = [&](float dx, float dy) {
        std::vector<Spot> yours = expected;
        for (Spot& spot : yours) spot.x += dx, spot.y += dy;
        return judged(yours, expected);
    };
    // To the right, the first pixel of each of the 4 rows is missing and one behind the last is extra.
    const Judgement right = moved(1, 0);
    EXPECT_EQ(right.metrics.at("wrong_place"), 4);
    EXPECT_EQ(right.metrics.at("missing"), 0);
    EXPECT_EQ(right.metrics.at("extra"), 0);
    EXPECT_DOUBLE_EQ(right.right, 0.6);
    EXPECT_NE(right.message.find("all fragments of triangle 7 lie one pixel to the right"), std::string::npos)
        << right.message;
    EXPECT_NE(moved(-1, 0).message.find("lie one pixel to the left"), std::string::npos);
    EXPECT_NE(moved(0, 1).message.find("lie one pixel too far down"), std::string::npos);
    EXPECT_NE(moved(1, -1).message.find("lie one pixel to the right and one up"), std::string::npos);
    const Judgement two = moved(2, 0);
    EXPECT_EQ(two.metrics.at("wrong_place"), 0) << "two pixels are no neighbours";
    EXPECT_EQ(two.metrics.at("missing"), two.metrics.at("extra"));
}

TEST(Fragments, only_one_step_for_the_whole_primitive_counts)
{
    const std::vector<Spot> expected = drawn(0, {"#.#.#.#.#.#"});
    std::vector<Spot> yours = expected;
    for (std::size_t i = 0; i < yours.size(); ++i) yours[i].y += i % 2 == 0 ? 1.0F : -1.0F;
    const Judgement found = judged(yours, expected);
    EXPECT_EQ(found.metrics.at("wrong_place"), 0);
    EXPECT_EQ(found.metrics.at("missing"), 6);
    EXPECT_EQ(found.right, 0);
}

TEST(Fragments, several_moved_primitives_share_a_sentence)
{
    std::vector<Spot> expected = drawn(1, triangle);
    for (const Spot& spot : drawn(2, triangle, 30, 3)) expected.push_back(spot);
    std::vector<Spot> yours = expected;
    for (Spot& spot : yours) spot.x -= 1;
    EXPECT_NE(
        judged(yours, expected).message.find("all fragments of triangle 1 (and of 1 other) lie one pixel to the left"),
        std::string::npos);
}

}
}
