#include "calibrate/rule_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "calibrate/picture_pair.hpp"

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

TEST(RuleTable, FitsOnOneHalfAndReportsOnTheOther)
{
    const std::vector<MeasuredPair> pairs = {pair(false, false, 0.2), pair(false, false, 0.7), pair(true, false, 0.1), pair(true, true, 0.6),
                                             pair(true, true, 0.8),   pair(true, true, 1.5),   pair(false, true, 0.9), pair(false, true, 0.3)};
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

TEST(RuleTable, WrongPicturesThatLookRightDoNotCount)
{
    MeasuredPair hidden = pair(true, true, 0);
    hidden.invisible = true;
    const auto results = compare_rules(std::vector{hidden, pair(true, true, 2)});
    EXPECT_EQ(results.front().bugs, 1U);
    EXPECT_EQ(results.front().caught, 1U);
}

TEST(RuleTable, HillsEstimateFindsTheRateOfAPowerLaw)
{
    // P(ratio > r) = (r / 0.01)^-2: beyond 1 lies one in ten thousand.
    const std::uint64_t seed = 17;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::vector<double> ratios;
    for (int i = 0; i < 20000; ++i) ratios.push_back(0.01 / std::sqrt(1 - random.uniform_double()));
    const Margins margins = margins_of(ratios);
    EXPECT_EQ(margins.count, 20000U);
    EXPECT_NEAR(margins.median, 0.01 * std::sqrt(2.0), 3e-4);
    EXPECT_GT(margins.alarm_rate, 0.7e-4);
    EXPECT_LT(margins.alarm_rate, 1.4e-4);
}

TEST(RuleTable, MarginsOfFewOrEqualRatiosStayFinite)
{
    EXPECT_EQ(margins_of({}).count, 0U);
    EXPECT_EQ(margins_of({0.3}).largest, 0.3);
    EXPECT_EQ(margins_of(std::vector<double>(50, 0.0)).alarm_rate, 0);
    EXPECT_EQ(margins_of(std::vector<double>(50, 0.5)).alarm_rate, 0);
    EXPECT_EQ(margins_of(std::vector<double>(50, 2.0)).alarm_rate, 1);
}

TEST(RuleTable, ASubmissionHasManyPictures)
{
    EXPECT_NEAR(alarms_of_submission(1e-6, 100), 1e-4, 1e-8);
    EXPECT_EQ(alarms_of_submission(0, 100), 0);
}

TEST(PicturePair, SceneNamesDecideTheHalfAndUnitsStayTogether)
{
    EXPECT_EQ(held_out("lighting/shaders: pictures/a"), held_out("lighting/shaders: random/b"));
    int held = 0;
    for (int i = 0; i < 1000; ++i) held += held_out("scene " + std::to_string(i)) ? 1 : 0;
    EXPECT_NEAR(held, 500, 60);
}

}
}
