#include <gtest/gtest.h>

#include <bench/accuracy/law.hpp>
#include <bench/accuracy/samples.hpp>
#include <bench/accuracy/study.hpp>
#include <cmath>

namespace umbral::bench {
namespace {

/// A knob whose errors are what they are said to be.
Knob knob_with(const std::vector<double>& amounts, const std::vector<double>& errors)
{
    Knob knob{"k", "K", "", "ns", "", {{"e", "error", "px"}}, {{"all", "all", 1}}, {}, {}, {}};
    for (std::size_t i = 0; i < amounts.size(); ++i)
        knob.results.push_back({std::to_string(i), "all", 1 + amounts[i], {{"e", errors[i]}}, "f", amounts[i]});
    return knob;
}

TEST(BenchLaw, fits_as_textbooks_do)
{
    // Worked by hand: means 3 and 3.6, Sxx = 10, Sxy = 8; residuals 0, -0.8, 1.4, -0.4, -0.2; squares sum to 2.8.
    const std::vector<double> x = {1, 2, 3, 4, 5};
    const std::vector<double> y = {2, 2, 5, 4, 5};
    const Line line = fit_line(x, y);
    EXPECT_NEAR(line.slope, 0.8, 1e-12);
    EXPECT_NEAR(line.intercept, 1.2, 1e-12);
    EXPECT_NEAR(line.half_width, 3.182 * std::sqrt(2.8 / 3 / 10), 1e-9);
    EXPECT_THROW((void)fit_line(std::vector<double>{1, 1}, std::vector<double>{1, 2}), std::invalid_argument);
    EXPECT_THROW((void)fit_line(std::vector<double>{1}, std::vector<double>{1}), std::invalid_argument);
}

TEST(BenchLaw, intervals_hold_the_true_slope_in_95_of_100)
{
    constexpr std::uint64_t seed = 91;
    Random random(seed);
    int held = 0;
    for (int round = 0; round < 4000; ++round) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < 6; ++i) {
            // Box and Muller: normal noise.
            const double radius = std::sqrt(-2 * std::log(1 - random.uniform_double()));
            x.push_back(i);
            y.push_back(2 - 0.5 * i + radius * std::cos(6.283185307179586 * random.uniform_double()));
        }
        const Line line = fit_line(x, y);
        held += std::abs(line.slope + 0.5) <= line.half_width ? 1 : 0;
    }
    EXPECT_NEAR(held / 4000.0, 0.95, 0.015) << "seed " << seed;
}

TEST(BenchLaw, judges_powers_and_exponentials)
{
    const std::vector<double> amounts = {1, 2, 4, 8, 16, 0, 32};
    std::vector<double> square;
    std::vector<double> fading;
    for (const double amount : amounts) {
        square.push_back(3 * amount * amount);
        fading.push_back(std::pow(10, -0.25 * amount));
    }
    const Knob knob = knob_with(amounts, square);
    const Law right = law_of(knob, {"f", "e", "n", 2, "Because.", "But."});
    EXPECT_EQ(right.verdict, "as theory says");
    EXPECT_EQ(right.points, 6U) << "an amount of 0 is no number";
    EXPECT_NEAR(right.slope, 2, 1e-12);
    EXPECT_EQ(right.reason, "Because.");
    const Law wrong = law_of(knob, {"f", "e", "n", 1, "Because.", "But."});
    EXPECT_EQ(wrong.verdict, "differs");
    EXPECT_EQ(wrong.reason, "Because. But.");
    EXPECT_EQ(law_of(knob, {"g", "e", "n", 2, "", ""}).verdict, "too few to tell") << "no such family";
    const Law exponential = law_of(knob_with(amounts, fading), {"f", "e", "n", -0.25, "", "", true});
    EXPECT_NEAR(exponential.slope, -0.25, 1e-12);
    EXPECT_EQ(exponential.verdict, "as theory says");
    EXPECT_NEAR(law_of(knob_with({1, 10, 100, 1000}, {1, 1, 1, 1}), {"f", "", "n", 1, "", ""}).slope, 0.91, 0.01)
        << "without a measure the time is fitted";
    const Law scattered = law_of(knob_with({1, 2, 4, 8}, {1, 9, 1, 9}), {"f", "e", "n", 0, "", ""});
    EXPECT_EQ(scattered.verdict, "too few to tell");
}

TEST(BenchSamples, areas_are_those_that_fine_grids_count)
{
    constexpr std::uint64_t seed = 92;
    Random random(seed);
    const std::vector<glm::dvec2> grid = cells(512 * 512, nullptr);
    for (int i = 0; i < 60; ++i) {
        const HalfPlane edge = random_edge(random, 0, 6.283185307179586);
        // Cells on the edge, at most two in each of 512 columns or rows, are the only ones that may be wrong.
        EXPECT_NEAR(covered_area(edge), covered_share(edge, grid), 1.5 / 512) << "seed " << seed << ", edge " << i;
    }
}

TEST(BenchSamples, each_pattern_is_what_its_name_says)
{
    Random random(93);
    std::vector<int> columns(16);
    for (const glm::dvec2& p : hammersley(16, {0, 0})) ++columns[static_cast<std::size_t>(16 * p.y)];
    EXPECT_EQ(columns, std::vector<int>(16, 1));
    std::vector<int> counts(16);
    for (const glm::dvec2& p : cells(16, &random))
        ++counts[static_cast<std::size_t>(4 * p.y) * 4 + static_cast<std::size_t>(4 * p.x)];
    EXPECT_EQ(counts, std::vector<int>(16, 1));
    EXPECT_EQ(independent(7, random).size(), 7U);
}

TEST(BenchStudy, times_every_trial_and_names_every_setting_once)
{
    Study study = study_of("id", "Title", "", "ns", {{"e", "error", "px"}}, 1e9, "n");
    for (const char* situation : {"1", "2"}) {
        study.knob.situations.push_back({situation, situation, 1});
        for (const int work : {1000, 200'000})
            study.trials.push_back({std::to_string(work),
                                    "f",
                                    static_cast<double>(work),
                                    {{"e", 1.0 / work}},
                                    1,
                                    [work] {
                                        for (int i = 0; i < work; ++i) keep(i);
                                    },
                                    situation});
    }
    study.laws = {{"f", "e", "n", -1, "", ""}};
    const Knob knob = finish(std::move(study), {"", true, ""});
    EXPECT_EQ(knob.settings.size(), 2U);
    ASSERT_EQ(knob.results.size(), 4U);
    EXPECT_GT(knob.results[1].time, 10 * knob.results[0].time);
    EXPECT_EQ(knob.curves.size(), 2U);
    EXPECT_EQ(knob.laws.front().verdict, "as theory says");
    EXPECT_DOUBLE_EQ(root_mean_square(std::vector<double>{3, 4, 0, 0}), 2.5);
}

}
}
