#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

Check worth(Millipoints points, double zero, double full)
{
    Check check = check_of(JudgeKind{"numbers"}, absolute(1));
    check.points = points;
    check.zero = zero;
    check.full = full;
    return check;
}

TEST(Points, are_linear_between_the_thresholds)
{
    EXPECT_EQ(points_for(worth(2000, 0, 1), 0.5, 0), 1000);
    EXPECT_EQ(points_for(worth(2000, 0.5, 0.9), 0.7, 0), 1000);
    EXPECT_EQ(points_for(worth(2000, 0.5, 0.9), 0.9, 0), 2000);
    EXPECT_EQ(points_for(worth(2000, 0.5, 0.9), 0.5, 0), 0);
    EXPECT_EQ(points_for(worth(2000, 0, 1), 0.6, 0.2), 1000) << "the best control earns nothing";
    EXPECT_EQ(points_for(worth(2000, 0, 1), 0.2, 0.2), 0);
    EXPECT_EQ(points_for(worth(1000, 0, 1), 1.0 / 3, 0), 333);
    EXPECT_EQ(points_for(worth(1000, 0, 1), 2.0 / 3, 0), 667) << "rounded once, to the nearest";
}

TEST(Points, a_control_at_the_full_mark_leaves_nothing_to_earn_but_more)
{
    EXPECT_EQ(points_for(worth(2000, 0, 1), 1, 1), 0);
    EXPECT_EQ(points_for(worth(2000, 0, 0.9), 0.95, 0.95), 0);
    EXPECT_EQ(points_for(worth(2000, 0, 0.9), 1, 0.95), 2000);
    EXPECT_EQ(points_for(worth(2000, 0, 1), std::numeric_limits<double>::quiet_NaN(), 0), 0);
}

TEST(Points, of_a_check_with_a_clearly_wrong_row_are_at_most_four_fifths)
{
    const auto judged = [](double right, std::size_t clearly_wrong) {
        Judgement judgement;
        judgement.right = right;
        judgement.clearly_wrong = clearly_wrong;
        return judgement;
    };
    EXPECT_EQ(points_for(worth(1000, 0, 1), judged(0.99, 1), 0), 800);
    EXPECT_EQ(points_for(worth(1000, 0, 1), judged(0.99, 0), 0), 990) << "what may be rounding costs its share";
    EXPECT_EQ(points_for(worth(1000, 0, 1), judged(0.7, 30), 0), 700) << "where the share costs more, it decides";
    EXPECT_EQ(points_for(worth(1000, 0, 0.98), judged(0.99, 1), 0), 1000) << "a check that forgives rows";
    Check hard = worth(1000, 0, 1);
    hard.hard = true;
    EXPECT_EQ(points_for(hard, judged(0.99, 1), 0), 990);
}

TEST(Points, rows_are_clearly_wrong_where_no_rounding_explains_them)
{
    const auto clearly_wrong = [](const Tolerance& tolerance, const std::vector<float>& yours) {
        const Check check = check_of(JudgeKind{"numbers"}, tolerance);
        return judge(check, floats(yours), floats({1, 2, 4}), nullptr).clearly_wrong;
    };
    EXPECT_EQ(clearly_wrong(absolute(0.01), {1, 2, 4}), 0U);
    EXPECT_EQ(clearly_wrong(absolute(0.01), {1.005F, 2, 4}), 0U);
    EXPECT_EQ(clearly_wrong(absolute(0.01), {1.07F, 2, 4}), 0U) << "wrong, but by less than eight times the bound";
    EXPECT_EQ(clearly_wrong(absolute(0.01), {1.09F, 2, 5}), 2U);
    EXPECT_EQ(clearly_wrong(absolute(0.01), {1, std::numeric_limits<float>::quiet_NaN(), 4}), 1U);
    Tolerance either = absolute(0.01);
    either.relative = 0.1;
    EXPECT_EQ(clearly_wrong(either, {1.09F, 2, 5}), 0U) << "within eight times one of its bounds";

    const Check check = check_of(JudgeKind{"numbers"}, absolute(0.01));
    const Judgement extra = judge(check, optional_floats({1, 2}, {1, 1}), optional_floats({1, 2}, {1, 0}), nullptr);
    EXPECT_EQ(extra.clearly_wrong, 1U) << "an answer where there is none";
}

TEST(Points, never_fall_with_more_right_and_stay_in_their_range)
{
    const std::uint64_t seed = 20240517;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int round = 0; round < 20000; ++round) {
        const double zero = random.uniform_double();
        const Check check = worth(random.below(20000), zero, zero + (1 - zero) * random.uniform_double() + 1e-9);
        const double control = random.uniform_double();
        const double low = random.uniform_double();
        const double high = std::min(1.0, low + random.uniform_double() * (round % 2 == 0 ? 1 : 1e-6));
        const Millipoints less = points_for(check, low, control);
        const Millipoints more = points_for(check, high, control);
        ASSERT_LE(less, more) << "right " << low << " and " << high;
        ASSERT_GE(less, 0);
        ASSERT_LE(more, check.points);
        ASSERT_EQ(points_for(check, std::max(check.zero, control), control), 0);
        ASSERT_LE(points_for(check, low, std::min(1.0, control + 0.1)), less) << "a better control never gives points";
        ASSERT_EQ(points_for(check, check.full, std::min(control, zero)), check.points);
    }
}

}
}
