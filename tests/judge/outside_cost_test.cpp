#include "judge/cost/outside_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace umbral::grader::test {
namespace {

const std::vector<double> problem_sizes{1000, 2000, 4000, 8000, 16000};

/// What runs take that need 1 ms beside their work, and for each size n so many milliseconds at the largest, growing
/// with this exponent.
OutsideCost runs_of(double at_the_largest, double exponent, double nothing = 1)
{
    OutsideCost cost{nothing, nothing, nothing};
    for (std::size_t i = 0; i < problem_sizes.size(); ++i) {
        const double taken = at_the_largest * std::pow(problem_sizes[i] / problem_sizes.back(), exponent);
        cost.all_sizes += taken;
        if (i < sizes_to_compare(problem_sizes)) cost.first_sizes += taken;
    }
    return cost;
}

std::optional<std::string> objection(const OutsideCost& student, double growth = 1)
{
    return objection_from_outside(student, runs_of(2, 1), problem_sizes, growth, "corners");
}

TEST(OutsideCost, compares_up_to_a_quarter_of_the_largest_size)
{
    EXPECT_EQ(sizes_to_compare(problem_sizes), 3U);
    EXPECT_EQ(sizes_to_compare({6, 9, 12, 15, 18}), 1U) << "never none";
    EXPECT_EQ(sizes_to_compare({1, 100}), 1U);
}

TEST(OutsideCost, work_that_grows_as_it_may_is_believed_however_slow)
{
    for (const double milliseconds : {0.01, 1.0, 30.0, 1000.0})
        for (const double exponent : {0.0, 1.0, 1.15}) EXPECT_FALSE(objection(runs_of(milliseconds, exponent)));
    EXPECT_FALSE(objection(runs_of(1000, 2), 2)) << "where n^2 is allowed";
    EXPECT_FALSE(objection(runs_of(1.5, 2))) << "too little to tell from noise";
}

TEST(OutsideCost, hidden_quadratic_work_is_not)
{
    for (const double milliseconds : {20.0, 50.0, 1000.0})
        EXPECT_TRUE(objection(runs_of(milliseconds, 2))) << milliseconds;
    // Sums of the squares of 1, 2, 4, 8, 16 sixteenths: 1 + 1/4 + 1/16 + 1/64 + 1/256 = 1.332 of 50 ms; the reference's
    // 2 ms times 1.9375.
    EXPECT_EQ(*objection(runs_of(50, 2)),
              "the counted steps are fine, but your code took 17 times the reference's time (67 ms, 3.9), and from "
              "4,000 to 16,000 corners it grows "
              "faster than that count allows: work was done that is not counted");
}

TEST(OutsideCost, noise_of_half_a_millisecond_changes_no_verdict)
{
    for (const double first : {-0.4, 0.4})
        for (const double all : {-0.4, 0.4}) {
            OutsideCost honest = runs_of(5, 1.15);
            OutsideCost forged = runs_of(40, 2);
            for (OutsideCost* each : {&honest, &forged}) each->first_sizes += first, each->all_sizes += all;
            EXPECT_FALSE(objection(honest));
            EXPECT_TRUE(objection(forged));
        }
}

TEST(OutsideCost, work_before_the_count_is_seen)
{
    EXPECT_FALSE(objection(runs_of(2, 1, 20)));
    EXPECT_TRUE(objection(runs_of(2, 1, 60)));
    EXPECT_NE(objection(runs_of(2, 1, 60))->find("before anything is counted"), std::string::npos);
}

TEST(OutsideCost, runs_as_quick_as_the_references_are_not_measured)
{
    EXPECT_FALSE(is_worth_measuring(7, 4));
    EXPECT_TRUE(is_worth_measuring(9, 4));
}

}
}
