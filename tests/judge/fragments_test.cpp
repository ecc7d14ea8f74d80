#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drawn_fragments.hpp"
#include "explaining.hpp"

namespace umbral::grader::test {
namespace {

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity_f = std::numeric_limits<float>::infinity();

TEST(Fragments, equal_ones_in_any_order_are_right)
{
    std::vector<Spot> expected = drawn(3, triangle);
    std::vector<Spot> yours(expected.rbegin(), expected.rend());
    const Judgement found = judged(yours, expected);
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.error, 0);
    EXPECT_EQ(found.message, "");
    EXPECT_EQ(found.sketch, "");
    EXPECT_FALSE(found.first_difference);
    EXPECT_EQ(found.metrics.at("fragments"), 10);
}

TEST(Fragments, rows_are_called_what_the_driver_calls_them)
{
    const auto said = [](const std::string& words) {
        const Tensor names = table(Element::uint8, 1, std::vector<char>(words.begin(), words.end()));
        return judged({{3, 1, 0, 0.5F}}, {{3, 0, 0, 0.25F}, {3, 1, 0, 0.5F}}, {}, &names);
    };
    const Judgement corners = said("polygon: corner, -");
    EXPECT_EQ(corners.message, "1 of 2 corners are right; 1 missing; the first is corner 0 of polygon 3");
    ASSERT_TRUE(corners.first_difference);
    EXPECT_EQ(corners.first_difference->yours, "no corner");
    EXPECT_EQ(corners.sketch, "") << "corners are no pixels";
    EXPECT_TRUE(said("task: path, corner").message.ends_with("the first is path 0, corner 0 of task 3"));
    EXPECT_TRUE(said("segment").message.ends_with("the first is pixel (0, 0) of segment 3"));
}

TEST(Fragments, two_different_values_never_look_alike)
{
    const Judgement found = judged({{3, 0, 0, 0.302065F}}, {{3, 0, 0, std::nextafter(0.302065F, 1.0F)}}, {});
    ASSERT_TRUE(found.first_difference);
    EXPECT_NE(found.first_difference->yours, found.first_difference->expected);
}

TEST(Fragments, each_class_is_counted)
{
    std::vector<Spot> expected = drawn(3, triangle);
    std::vector<Spot> yours = expected;
    yours.erase(yours.begin());          // (0, 0) is missing
    yours.push_back({3, 20, 20, 0.5F});  // too much, far away
    yours.push_back({3, 1, 3, 0.5F});    // drawn again
    yours.push_back({3, 1, 3, 0.5F});    // and again
    yours[1].value = 0.75F;              // (1, 1): another value
    const Judgement found = judged(yours, expected);
    EXPECT_EQ(found.metrics.at("missing"), 1);
    EXPECT_EQ(found.metrics.at("extra"), 1);
    EXPECT_EQ(found.metrics.at("duplicated"), 2);
    EXPECT_EQ(found.metrics.at("wrong_value"), 1);
    EXPECT_EQ(found.metrics.at("wrong_place"), 0);
    EXPECT_DOUBLE_EQ(found.right, 8.0 / (10 + 1 + 2));
    EXPECT_EQ(found.error, 0.25);
    EXPECT_EQ(found.message,
              "8 of 10 fragments are right; 1 missing, 1 extra, 2 drawn again, 1 with a wrong value; the first that "
              "is missing or too much is pixel (0, 0) of triangle 3");
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->where, "pixel (0, 0) of triangle 3");
    EXPECT_EQ(found.first_difference->yours, "no fragment");
    EXPECT_EQ(found.first_difference->expected, "(0.5)");
    EXPECT_EQ(found.first_difference->cell, 0U);
    EXPECT_EQ(found.sketch,
              "-...\n#~..\n###.\n#2##\nx 0..3, y 0..3; # right - missing 2 drawn again ~ wrong value . empty");
}

TEST(Fragments, what_there_is_more_of_is_shown)
{
    const std::vector<Spot> expected = drawn(3, triangle);
    std::vector<Spot> yours = expected;
    yours.erase(yours.begin());
    for (Spot& spot : yours) spot.value = 0.75F;
    const Judgement found = judged(yours, expected);
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->yours, "(0.75)");
    EXPECT_TRUE(found.message.ends_with("the first with a wrong value is pixel (0, 1) of triangle 3")) << found.message;
}

TEST(Fragments, a_row_of_its_primitive_stands_for_a_fragment_too_many)
{
    const std::vector<Spot> expected{{1, 5, 6, 1.0F}, {2, 5, 6, 1.0F}};
    std::vector<Spot> yours = expected;
    yours.push_back({2, 4, 6, 1.0F});
    EXPECT_EQ(judged(yours, expected).first_difference.value().cell, 1U);
    yours.back().primitive = 0;
    EXPECT_EQ(judged(yours, expected).first_difference.value().cell, std::nullopt);
}

TEST(Fragments, the_tolerance_holds_for_attributes_only)
{
    const std::vector<Spot> expected{{0, 5, 6, 1.0F}};
    EXPECT_EQ(judged({{0, 5, 6, 1.05F}}, expected, absolute(0.1)).right, 1);
    EXPECT_EQ(judged({{0, 5, 6, 1.05F}}, expected, absolute(0.01)).right, 0);
    EXPECT_EQ(judged({{0, 5, 6, std::nextafter(1.0F, 2.0F)}}, expected).right, 0)
        << "without a tolerance values are equal or wrong";
    EXPECT_EQ(judged({{0, 5.05F, 6, 1.0F}}, expected, absolute(0.1)).right, 0);
    EXPECT_EQ(judged({{1, 5, 6, 1.0F}}, expected, absolute(10)).right, 0) << "another primitive";
}

TEST(Fragments, the_word_for_a_primitive_is_the_drivers_choice)
{
    Tensor names = table(Element::uint8, 1, std::vector<char>{'l', 'i', 'n', 'e'});
    EXPECT_NE(judged({}, {{2, 5, 6, 1.0F}}, {}, &names).message.find("pixel (5, 6) of line 2"), std::string::npos);
}

TEST(Fragments, the_sketch_stays_small_and_round_the_first_bad_place)
{
    const std::vector<Spot> expected = drawn(0, std::vector<std::string>(60, std::string(60, '#')));
    std::vector<Spot> yours = expected;
    std::erase_if(yours, [](const Spot& spot) { return spot.x == 30 && spot.y == 20; });
    const std::string sketch = judged(yours, expected).sketch;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= sketch.size();) {
        const std::size_t end = std::min(sketch.find('\n', at), sketch.size());
        lines.push_back(sketch.substr(at, end - at));
        at = end + 1;
    }
    ASSERT_EQ(lines.size(), 16U) << sketch;
    for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(lines[i], i == 7 ? "#######-#######" : "###############");
    EXPECT_EQ(lines[15], "x 23..37, y 13..27; # right - missing");
}

TEST(Fragments, expected_duplicates_must_come_as_often)
{
    const std::vector<Spot> expected{{0, 1, 1, 0.1F}, {0, 1, 1, 0.2F}};
    EXPECT_EQ(judged(expected, expected).right, 1);
    const Judgement one = judged({{0, 1, 1, 0.1F}}, expected);
    EXPECT_EQ(one.right, 0.5);
    EXPECT_EQ(one.metrics.at("missing"), 1);
}

TEST(Fragments, hostile_rows_are_extra_and_do_no_harm)
{
    const std::vector<Spot> expected{{0, 1, 1, 0.5F}, {0, 2, 1, 0.5F}};
    const Judgement found = judged({{nan_f, 1, 1, 0.5F},
                                    {0, infinity_f, 1},
                                    {0, 1, -infinity_f},
                                    {0, 1.5F, 1},
                                    {0, 3e38F, 1},
                                    {0, 4294967296.0F, 1},
                                    {0, 1, 1, nan_f}},
                                   expected);
    EXPECT_EQ(found.right, 0);
    EXPECT_FALSE(found.error);
    EXPECT_EQ(found.metrics.at("extra"), 6);
    EXPECT_EQ(found.metrics.at("missing"), 1);
    EXPECT_EQ(found.metrics.at("wrong_value"), 1);
    EXPECT_NE(found.message.find("6 of yours lie at no pixel"), std::string::npos) << found.message;
    for (const auto& [name, value] : found.metrics) EXPECT_TRUE(std::isfinite(value)) << name;
    // Only unplaced ones beside all that was expected: no place to show, but not right.
    const Judgement more = judged({{0, 1, 1, 0.5F}, {0, 2, 1, 0.5F}, {nan_f, 1, 1}}, expected);
    EXPECT_DOUBLE_EQ(more.right, 2.0 / 3);
    EXPECT_FALSE(more.error);
    EXPECT_NE(more.message, "");
    // Coordinates at the ends of what is counted: neither a sketch nor a step overflows.
    const float far = 1073741824.0F;
    EXPECT_EQ(judged({{far, far, far}, {-far, -far, -far}}, expected).right, 0);
    EXPECT_EQ(judged({{0, far, -far, 0.5F}}, {{0, far, far, 0.5F}}).right, 0);
}

TEST(Fragments, nothing_or_another_shape)
{
    const Check check = check_of(JudgeKind{"fragments"});
    const Tensor expected = fragments({{0, 1, 1}});
    EXPECT_EQ(judge(check, Tensor{}, expected, nullptr).right, 0);
    EXPECT_EQ(judge(check, floats({}, 4), expected, nullptr).metrics.at("missing"), 1);
    EXPECT_EQ(judge(check, floats({0, 1, 1}, 3), expected, nullptr).message,
              "Yours has rows of 3 float; expected rows of 4 float.");
    EXPECT_EQ(judge(check, doubles({0, 1, 1, 0}, 4), expected, nullptr).right, 0);
    Tensor damaged = expected;
    damaged.bytes.pop_back();
    EXPECT_EQ(judge(check, damaged, expected, nullptr).right, 0);
    EXPECT_THROW((void)judge(check, expected, floats({}, 4), nullptr), std::invalid_argument);
    EXPECT_THROW((void)judge(check, floats({1, 2}, 2), floats({1, 2}, 2), nullptr), std::invalid_argument);
    EXPECT_THROW((void)judge(check, expected, fragments({{0, nan_f, 1}}), nullptr), std::invalid_argument);
    EXPECT_THROW((void)judge(check, expected, fragments({{0, 0.5F, 1}}), nullptr), std::invalid_argument);
    EXPECT_THROW((void)judge(check, expected, fragments({{0, 1, 1, nan_f}}), nullptr), std::invalid_argument);
}

TEST(Fragments, a_full_recording_takes_bounded_time)
{
    // 24 MB of rows in one place, then all over the plane; quadratic work would take hours.
    const std::vector<Spot> expected = drawn(0, std::vector<std::string>(40, std::string(40, '#')));
    std::vector<Spot> same(1'500'000, Spot{0, 3, 3, nan_f});
    EXPECT_LT(judged(same, expected).right, 1e-3);
    Random random(1);
    for (Spot& spot : same)
        spot = {static_cast<float>(random.below(9)), static_cast<float>(random.below(4000)),
                static_cast<float>(random.below(4000))};
    EXPECT_LT(judged(same, expected).right, 1e-3);
}

TEST(Fragments, controls_earn_what_a_bounding_box_does)
{
    const Tensor expected = fragments(drawn(0, triangle));
    const Check check = check_of(JudgeKind{"fragments"});
    const BestControl best = best_control(check, expected, nullptr, 1);
    EXPECT_EQ(best.name, "bounding boxes");
    EXPECT_DOUBLE_EQ(best.right, 10.0 / 16);
    EXPECT_EQ(points_for(check, best.right, best.right), 0);
    // A diagonal of 100 pixels has a box of 10000: it is left out, as it would earn next to nothing.
    std::vector<Spot> diagonal;
    for (int i = 0; i < 100; ++i)
        diagonal.push_back({0, static_cast<float>(i), static_cast<float>(i), static_cast<float>(i)});
    EXPECT_LT(best_control(check, fragments(diagonal), nullptr, 1).right, 0.05);
}

TEST(Fragments, mistakes_match_by_their_set_of_deviations)
{
    const Check check = check_of(JudgeKind{"fragments"}, absolute(0.01));
    const std::vector<Spot> expected = drawn(0, triangle);
    std::vector<Spot> fewer = expected;
    fewer.pop_back();
    std::vector<Spot> darker = expected;
    for (Spot& spot : darker) spot.value = 0.25F;
    const auto same = [&](const std::vector<Spot>& yours, const std::vector<Spot>& mistake) {
        const Tensor a = fragments(yours);
        const Tensor b = fragments(expected);
        return resemblance(FailingCheck{&check, &a, &b, nullptr}, fragments(mistake)).says == Says::for_it;
    };
    EXPECT_TRUE(same(fewer, fewer));
    EXPECT_TRUE(same(darker, darker));
    EXPECT_TRUE(same({}, {}));
    EXPECT_FALSE(same(fewer, darker));
    EXPECT_FALSE(same(expected, fewer));
    EXPECT_FALSE(same(fewer, expected));
    EXPECT_FALSE(same(fewer, {}));
    std::vector<Spot> nothing_known = expected;
    for (Spot& spot : nothing_known) spot.value = nan_f;
    EXPECT_TRUE(same(nothing_known, nothing_known));
    EXPECT_FALSE(same(nothing_known, darker));
    EXPECT_TRUE(explain(check, fragments(darker), fragments(expected)).empty()) << "no named transform fits";
}

TEST(Fragments, one_of_several_may_match_and_the_rest_are_again)
{
    const Judgement found = judged({{0, 1, 1, 0.9F}, {0, 1, 1, 0.5F}, {0, 8, 8}, {0, 8, 8}}, {{0, 1, 1, 0.5F}});
    EXPECT_EQ(found.metrics.at("wrong_value"), 0);
    EXPECT_EQ(found.metrics.at("extra"), 1) << "the second at an extra place is drawn again";
    EXPECT_EQ(found.metrics.at("duplicated"), 2);
    EXPECT_DOUBLE_EQ(found.right, 1.0 / 4);
    EXPECT_EQ(judged({}, {{0, 1, 1, 0.1F}, {0, 1, 1, 0.2F}}).metrics.at("missing"), 2);
}

TEST(Fragments, every_attribute_matters)
{
    const Check check = check_of(JudgeKind{"fragments"}, absolute(0.01));
    const Tensor expected = floats({0, 1, 1, 0.5F, 0.25F}, 5);
    EXPECT_EQ(judge(check, floats({0, 1, 1, 0.9F, 0.25F}, 5), expected, nullptr).right, 0);
    EXPECT_EQ(judge(check, floats({0, 1, 1, 0.5F, 0.9F}, 5), expected, nullptr).right, 0);
}

}
}
