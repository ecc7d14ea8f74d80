#include "bench/judges/rule_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "bench/held_out.hpp"
#include "bench/judges/picture_pair.hpp"

namespace umbral::grader {
namespace {

MeasuredPair pair(bool harmful, bool held, double measure)
{
    MeasuredPair made;
    made.harmful = harmful;
    made.held_out = held;
    made.measures.fill(measure);
    made.ours.worst = measure;
    return made;
}

const RuleResult& result_of(const std::vector<RuleResult>& results, PictureRule rule, const std::string& origin)
{
    for (const RuleResult& result : results)
        if (result.rule == rule && result.origin == origin) return result;
    throw std::runtime_error("no such row");
}

TEST(RuleTable, fits_on_one_half_and_reports_on_the_other)
{
    const std::vector<MeasuredPair> pairs = {pair(false, false, 0.2), pair(false, false, 0.7), pair(true, false, 0.1),
                                             pair(true, true, 0.6),   pair(true, true, 0.8),   pair(true, true, 1.5),
                                             pair(false, true, 0.9),  pair(false, true, 0.3)};
    EXPECT_EQ(fitted_threshold(pairs, PictureRule::rmse), 0.7) << "the largest harmless one of the calibration half";
    const auto results = compare_rules(pairs);
    const RuleResult& fitted = result_of(results, PictureRule::rmse, "best on the other half");
    EXPECT_EQ(fitted.caught, 2U);
    EXPECT_EQ(fitted.bugs, 3U);
    EXPECT_EQ(fitted.alarms, 1U);
    EXPECT_EQ(fitted.harmless, 2U);
    const RuleResult& ours = result_of(results, PictureRule::ours, "in use");
    EXPECT_EQ(ours.threshold, 1);
    EXPECT_EQ(ours.caught, 1U) << "ours is never fitted here: its thresholds are those in use";
    EXPECT_EQ(ours.alarms, 0U);
}

TEST(RuleTable, wrong_pictures_that_look_right_do_not_count)
{
    MeasuredPair hidden = pair(true, true, 0);
    hidden.invisible = true;
    const auto results = compare_rules(std::vector{hidden, pair(true, true, 2)});
    EXPECT_EQ(results.front().bugs, 1U);
    EXPECT_EQ(results.front().caught, 1U);
}

TEST(RuleTable, tails_of_known_laws_give_their_rates)
{
    const std::uint64_t seed = 17;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    // Cut at the bound, where samples end by chance: only what lies below it is seen.
    const auto rate = [&](auto draw) {
        std::vector<double> ratios;
        while (ratios.size() < 4000)
            if (const double ratio = draw(1 - random.uniform_double()); ratio <= 1) ratios.push_back(ratio);
        return margins_of(ratios).alarm_rate;
    };
    // P(ratio > r) = (r / 0.003)^-2: beyond 1 lie nine in a million.
    const double power = rate([](double u) { return 0.003 / std::sqrt(u); });
    EXPECT_GT(power, 1e-6);
    EXPECT_LT(power, 8e-5);
    // Exponential with mean 0.08: beyond 1 lie 3.7 in a million.
    const double exponential = rate([](double u) { return -0.08 * std::log(u); });
    EXPECT_GT(exponential, 1e-8);
    EXPECT_LT(exponential, 1e-4);
    EXPECT_LT(rate([](double u) { return 0.5 * u; }), 1e-12) << "a law that ends at one half reaches nothing beyond";
}

TEST(RuleTable, median_and_rate_of_what_exceeds)
{
    std::vector<double> ratios(99, 0.25);
    ratios.push_back(1.5);
    const Margins margins = margins_of(ratios);
    EXPECT_EQ(margins.median, 0.25);
    EXPECT_EQ(margins.largest, 1.5);
    EXPECT_DOUBLE_EQ(margins.alarm_rate, 0.01);
}

TEST(RuleTable, margins_of_few_or_equal_ratios_stay_finite)
{
    EXPECT_EQ(margins_of({}).count, 0U);
    EXPECT_EQ(margins_of({0.3}).largest, 0.3);
    EXPECT_EQ(margins_of(std::vector<double>(50, 0.0)).alarm_rate, 0);
    EXPECT_EQ(margins_of(std::vector<double>(50, 0.5)).alarm_rate, 0);
    EXPECT_EQ(margins_of(std::vector<double>(50, 2.0)).alarm_rate, 1);
}

TEST(RuleTable, a_submission_has_many_pictures)
{
    EXPECT_NEAR(alarms_of_submission(1e-6, 100), 1e-4, 1e-8);
    EXPECT_EQ(alarms_of_submission(0, 100), 0);
}

TEST(PicturePair, scene_names_decide_the_half_and_units_stay_together)
{
    EXPECT_EQ(held_out("lighting/shaders: pictures/a"), held_out("lighting/shaders: random/b"));
    int held = 0;
    for (int i = 0; i < 1000; ++i) held += held_out("scene " + std::to_string(i)) ? 1 : 0;
    EXPECT_NEAR(held, 500, 60);
}

}
}
