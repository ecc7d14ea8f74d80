#include "judge/statistics/error_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <umbral/core/random.hpp>

#include "judge/explain/thresholds.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {
namespace {

using thresholds::noise_borderline;

TEST(ErrorBudget, sidak_shares_out_what_independent_tests_may_err)
{
    for (const double alpha : {1e-12, 1e-4, 0.05, 0.5})
        for (const int tests : {1, 2, 10, 3267}) {
            const double level = sidak(alpha, tests);
            // The chance that none errs, in more precision.
            const long double none = std::exp(tests * std::log1p(-static_cast<long double>(level)));
            EXPECT_NEAR(static_cast<double>((1 - none) / alpha), 1, alpha < 1e-10 ? 1e-5 : 1e-9)
                << alpha << " " << tests;
            EXPECT_NEAR(sidak_probability(level, tests) / alpha, 1, 1e-12);
        }
    EXPECT_NEAR(sidak(0.25, 1), 0.25, 1e-15);
    EXPECT_EQ(sidak_probability(1, 5), 1);
    EXPECT_EQ(sidak_probability(0, 5), 0);
    EXPECT_NEAR(check_alpha() * most_noise_checks, thresholds::submission_alpha, 1e-8);
}

/// The product of two p-values at which both together have the probability `level`.
double product_at(double level)
{
    double low = 1e-300;
    double high = noise_borderline;
    for (int i = 0; i < 2000; ++i) {
        const double middle = std::sqrt(low * high);
        (two_stage_probability(middle, 1, noise_borderline) < level ? low : high) = middle;
    }
    return low;
}

TEST(ErrorBudget, the_rate_of_the_two_stages_is_exact)
{
    // The oracle: the area of { first < borderline, first * second <= product } in the unit square, summed up in a
    // million thin slices.
    for (const double level : {1e-12, 1e-9, check_alpha(), 1e-4, 5e-3}) {
        const double product = product_at(level);
        constexpr int slices = 1000000;
        double area = product;  // first <= product: any second one is small enough
        const double ratio = std::log(noise_borderline / product) / slices;
        for (int i = 0; i < slices; ++i) {
            const double left = product * std::exp(i * ratio);
            const double right = product * std::exp((i + 1) * ratio);
            area += (right - left) * product / ((left + right) / 2);
        }
        EXPECT_NEAR(area / level, 1, 1e-6) << level;
    }
}

TEST(ErrorBudget, the_first_run_decides_where_the_second_cannot)
{
    const double product = product_at(check_alpha());
    EXPECT_EQ(after_first_run(1), FirstRun::right);
    EXPECT_EQ(after_first_run(noise_borderline), FirstRun::right);
    EXPECT_EQ(after_first_run(std::nextafter(noise_borderline, 0)), FirstRun::borderline);
    EXPECT_EQ(after_first_run(check_alpha()), FirstRun::borderline) << "just below the level a second run may save it";
    EXPECT_EQ(after_first_run(product * 1.001), FirstRun::borderline);
    EXPECT_EQ(after_first_run(product * 0.999), FirstRun::wrong);
    EXPECT_EQ(after_first_run(0), FirstRun::wrong);
    // Whatever a second run gave, it would stay wrong.
    EXPECT_LT(two_stage_probability(product * 0.999, 1, noise_borderline), check_alpha());
    EXPECT_EQ(two_stage_probability(0, 0.5, noise_borderline), 0);
    EXPECT_EQ(two_stage_probability(0.3, 1e-20, noise_borderline), 0.3)
        << "without a second run the first is what there is";
    // With every first run followed by a second it is Fisher's combination of two.
    EXPECT_NEAR(two_stage_probability(0.2, 0.1, 1), 0.02 * (1 - std::log(0.02)), 1e-15);
}

TEST(ErrorBudget, correct_submissions_fail_as_often_as_the_budget_says)
{
    // A million correct submissions, each with as many noise checks as the budget is for, decided as the grader
    // decides.
    const std::uint64_t seed = 20260215;
    SCOPED_TRACE(seed);
    Random random(seed);
    constexpr int submissions = 1000000;
    int failing = 0;
    int again = 0;
    for (int i = 0; i < submissions; ++i) {
        bool fails = false;
        for (int check = 0; check < most_noise_checks; ++check) {
            const double first = random.uniform_double();
            if (first >= noise_borderline) continue;
            const FirstRun decision = after_first_run(first);
            fails = fails || decision == FirstRun::wrong;
            if (decision != FirstRun::borderline) continue;
            ++again;
            fails = fails || two_stage_probability(first, random.uniform_double(), noise_borderline) < check_alpha();
        }
        failing += fails ? 1 : 0;
    }
    std::printf(
        "seed %llu: %d of %d correct submissions with %d noise checks fail (expected %g), %.4f of the checks run "
        "again\n",
        static_cast<unsigned long long>(seed), failing, submissions, most_noise_checks,
        submissions * thresholds::submission_alpha, static_cast<double>(again) / submissions / most_noise_checks);
    // 100 with a standard deviation of 10: four of them on both sides, so that a budget half used would show too.
    EXPECT_GE(failing, 60);
    EXPECT_LE(failing, 140);
    EXPECT_NEAR(static_cast<double>(again) / submissions / most_noise_checks, noise_borderline, 1e-4);
}

TEST(ErrorBudget, a_second_run_finds_what_one_leaves_open)
{
    // Two runs at 3.5 standard deviations each: neither proves anything at the level of one check, both together do.
    const double one = std::erfc(3.9 / std::sqrt(2.0));
    EXPECT_GT(one, check_alpha());
    EXPECT_LT(two_stage_probability(one, one, noise_borderline), check_alpha());
    // A freak of 1 in 3 million is forgiven if the second run is ordinary.
    EXPECT_GT(two_stage_probability(3e-7, 0.5, noise_borderline), check_alpha());
}

}
}
