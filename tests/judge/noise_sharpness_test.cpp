#include <gtest/gtest.h>

#include <cmath>

#include "judge/noise/noise.hpp"
#include "judge/statistics/error_budget.hpp"
#include "noise_runs.hpp"
#include "right_pictures.hpp"

// Noisy pictures that are softer or sharper than they should be: found, and no right one accused of it.
namespace umbral::grader::test {
namespace {

/// The shadows of two balls on a lit floor, their edges so many pixels wide.
Tensor shadows(Random& random, double width, int samples = 32)
{
    const Light light = [=](int x, int y) {
        const double inside = std::min(std::hypot(x - 21.3, y - 24.1) - 11, std::hypot(x - 45.2, y - 42.7) - 13);
        return 0.1 + 0.6 * std::clamp(0.5 + inside / width, 0.0, 1.0);
    };
    return noisy(random, 64, 64, 3, samples, light, uniform);
}

TEST(NoiseSharpness, a_shadow_that_is_too_hard_or_too_soft_is_found)
{
    SCOPED_TRACE(seed);
    struct Case {
        double yours;
        double right;
        const char* words;
    };
    for (const Case& one : {Case{0.5, 6, "The picture is too sharp"}, Case{3, 8, "The picture is too sharp"},
                            Case{6, 0.5, "The picture is too soft"}, Case{5, 2.5, "The picture is too soft"}}) {
        Random random(seed);
        const Tensor expected = shadows(random, one.right);
        const Judgement found = judge(check, shadows(random, one.yours), expected, nullptr);
        EXPECT_LT(found.metrics.at("probability"), check_alpha()) << one.yours << " for " << one.right;
        EXPECT_LT(found.right, 1);
        EXPECT_EQ(found.message.rfind(one.words, 0), 0U) << found.message;
        const Judgement bytes = judge(check, as_bytes(shadows(random, one.yours)), as_bytes(expected), nullptr);
        EXPECT_LT(bytes.right, 1) << one.yours << " for " << one.right << ", in bytes";
        EXPECT_EQ(judge(check, shadows(random, one.right), expected, nullptr).right, 1);
        EXPECT_EQ(judge(check, as_bytes(shadows(random, one.right)), as_bytes(expected), nullptr).right, 1);
    }
}

TEST(NoiseSharpness, a_bias_is_told_as_a_bias)
{
    Random random(seed);
    const Tensor expected = run(random);
    for (const double factor : {0.5, 0.95, 1.05, 2.0}) {
        const Judgement found = judge(check, run(random, factor), expected, nullptr);
        EXPECT_EQ(found.message.find("too s"), std::string::npos) << factor << " " << found.message;
    }
}

// White pixels, what was cut off at them, and rounding are no difference in sharpness: an eighth of the noise in yours.
TEST(NoiseSharpness, clipped_pictures_with_less_noise_are_not_accused)
{
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < samples_for_tests(200); ++i) {
        const auto dots = [](int x, int y) { return 0.05 + (x % 8 < 3 && y % 8 < 3 ? 0.9 : 0.0); };
        const Tensor expected = as_bytes(noisy(random, 64, 64, 3, 4, dots));
        const Tensor yours = as_bytes(noisy(random, 64, 64, 3, 32, dots));
        for (const PatternSums& one :
             sharpness_sums(light_of(to_picture(check, yours)), light_of(to_picture(check, expected))))
            EXPECT_GT(tile_probability(one.sums, deviation_of(one.sums, forgiven_bytes)), 1e-6);
    }
}

TEST(NoiseSharpness, right_pictures_are_not_accused)
{
    const SumsOfPair sharpness = [](const Estimates& a, const Estimates& b, int) {
        std::vector<TileSums> all;
        for (const PatternSums& one : sharpness_sums(a, b)) all.push_back(one.sums);
        return all;
    };
    // Eight cells of 4 x 4 pixels of each colour are in such a small picture.
    expect_uniform("the sharpness", sharpness, 1.2);
}

// Exchanging the two turns the sign and nothing else; what is small, or flat, has no sharpness.
TEST(NoiseSharpness, is_of_both_alike_and_needs_something_to_be_sharp)
{
    Random random(seed);
    const Estimates a = noisy_estimates(random, 2, exponential);
    const Estimates b = noisy_estimates(random, 2, exponential);
    const auto there = sharpness_sums(a, b);
    const auto back = sharpness_sums(b, a);
    ASSERT_EQ(there.size(), 6U);
    for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_EQ(there[i].sums.difference, -back[i].sums.difference);
        EXPECT_EQ(there[i].sums.squares, back[i].sums.squares);
        EXPECT_GT(there[i].sums.squares, 0);
    }
    const Estimates thin{2, 40, 1, true, std::vector<double>(80, 0.5), {}};
    const Estimates flat{40, 40, 1, true, std::vector<double>(1600, 0.5), {}};
    const Estimates other{40, 40, 1, true, std::vector<double>(1600, 0.6), {}};
    for (const auto& sums : {sharpness_sums(thin, thin), sharpness_sums(other, flat)})
        for (const PatternSums& one : sums)
            EXPECT_EQ(tile_probability(one.sums, deviation_of(one.sums, forgiven_floats)), 1);
}

}
}
