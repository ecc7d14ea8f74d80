#include "judge/noise/noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "judge/rows/tensor_view.hpp"
#include "noise_runs.hpp"

namespace umbral::grader::test {
namespace {

double right(const Tensor& student, const Tensor& expected) { return judge(check, student, expected, nullptr).right; }

TEST(Noise, the_same_numbers_in_the_same_order_are_right)
{
    Random random(seed);
    const Tensor once = run(random);
    const Judgement found = judge(check, once, once, nullptr);
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.metrics.at("probability"), 1);
    EXPECT_TRUE(found.message.empty());
    // Summed up in another order: every pixel a rounding away, on the same side.
    Tensor rounded = once;
    for (std::size_t i = 0; i < once.count(); ++i) {
        float value = 0;
        std::memcpy(&value, once.bytes.data() + i * sizeof value, sizeof value);
        value *= 1 + 4e-7F;
        std::memcpy(rounded.bytes.data() + i * sizeof value, &value, sizeof value);
    }
    EXPECT_NE(rounded, once);
    EXPECT_EQ(judge(check, rounded, once, nullptr).metrics.at("probability"), 1);
    // … and a bias with the same numbers is no noise at all, however small.
    Random again(seed);
    EXPECT_LT(right(run(again, 1.003), once), 1);
}

TEST(Noise, other_numbers_of_the_same_light_are_right)
{
    Random random(seed);
    for (int i = 0; i < 10; ++i) {
        const Tensor expected = run(random);
        const Tensor student = run(random);
        EXPECT_EQ(right(student, expected), 1);
        EXPECT_EQ(right(as_bytes(student), as_bytes(expected)), 1);
        EXPECT_EQ(right(estimates(random), estimates(random)), 1);
    }
}

TEST(Noise, alpha_is_no_light)
{
    Random random(seed);
    const auto with_alpha = [&](float alpha) {
        Tensor light = noisy(random, 64, 64, 4, 32, floor_and_ball, uniform);
        for (std::size_t i = 3; i < light.count(); i += 4)
            std::memcpy(light.bytes.data() + i * sizeof alpha, &alpha, sizeof alpha);
        return light;
    };
    EXPECT_EQ(right(with_alpha(0), with_alpha(1)), 1);
}

TEST(Noise, credit_falls_with_the_light_in_the_wrong_place)
{
    SCOPED_TRACE(seed);
    Random random(seed);
    std::printf("seed %llu: credit before rescaling by what is wrong\n", static_cast<unsigned long long>(seed));
    const Tensor expected = run(random);
    double last = 1;
    for (const double factor : {1.03, 1.06, 1.2, 1.5, 1.9}) {
        const Judgement found = judge(check, run(random, factor), expected, nullptr);
        std::printf("  times %.2f: %.2f (%.1f %% in the wrong place)\n", factor, found.right,
                    found.metrics.at("misplaced_percent"));
        EXPECT_LT(found.right, last) << factor;
        EXPECT_NEAR(found.metrics.at("misplaced_percent"), 100 * (1 - 1 / factor), 2) << factor;
        EXPECT_NEAR(right(run(random, 1 / factor), expected), found.right, 0.1) << "too dark as too bright";
        last = found.right;
    }
    EXPECT_EQ(right(run(random, 3.14159265), expected), 0);
    EXPECT_EQ(right(run(random, 1 / 3.14159265), expected), 0);
    EXPECT_GT(right(run(random, 1.03), expected), 0.6);
    EXPECT_LT(right(run(random, 1.03), expected), 0.95);
    // A patch that lies in the dark costs what its light is worth.
    const Tensor patch = noisy(
        random, 64, 64, 3, 32,
        [](int x, int y) { return x >= 40 && x < 56 && y >= 16 && y < 32 ? 0.0 : floor_and_ball(x, y); }, uniform);
    const Judgement dark = judge(check, patch, expected, nullptr);
    EXPECT_GT(dark.metrics.at("misplaced_percent"), 5);
    EXPECT_LT(dark.metrics.at("misplaced_percent"), 15);
    EXPECT_NE(dark.message.find("too low in the"), std::string::npos) << dark.message;
}

TEST(Noise, controls_earn_next_to_nothing)
{
    Random random(seed);
    for (const Tensor& expected : {run(random), as_bytes(run(random)), estimates(random)}) {
        const BestControl best = best_control(check, expected, nullptr, seed);
        EXPECT_LT(best.right, 0.25) << best.name;
        for (const auto& [name, tensor] : controls(check, expected, seed)) {
            const double got = judge(check, tensor, expected, nullptr).right;
            EXPECT_EQ(points_for(check, got, best.right), 0) << name;
            const bool dark = name == "zeros" || name == "black" || name == "blank";
            EXPECT_LE(got, dark ? 0.0 : 0.25) << name;
        }
    }
    // The mean of one quantity is its answer: no control may know it.
    Tensor one = doubles(std::vector<double>(100, 0.25));
    for (const auto& [name, tensor] : controls(check, one, seed))
        EXPECT_LT(judge(check, tensor, one, nullptr).right, 1) << name;
}

TEST(Noise, noise_is_no_hiding_place)
{
    Random random(seed);
    const Tensor expected = run(random);
    // Nothing, but for one pixel of each tile that makes the sum of squares as large as one likes.
    EXPECT_EQ(right(noisy(random, 64, 64, 3, 1, [](int x, int y) { return x % 16 == 5 && y % 16 == 5 ? 100.0 : 0.0; }),
                    expected),
              0);
    // The same with the right mean.
    EXPECT_EQ(
        right(noisy(random, 64, 64, 3, 1, [](int x, int y) { return x % 16 == 5 && y % 16 == 5 ? 256 * 0.13 : 0.0; }),
              expected),
        0);
    // Noise without end round nothing, and round the mean.
    for (const double mean : {0.0, 0.13})
        for (const double size : {0.5, 5.0, 1e6}) {
            const auto spread = [&](int, int) { return mean + size * (2 * random.uniform_double() - 1); };
            EXPECT_LT(right(noisy(random, 64, 64, 3, 1, spread, [](Random&) { return 1.0; }), expected), 0.25)
                << mean << " " << size;
        }
    // A table that one row spoils.
    const Tensor table = estimates(random);
    std::vector<double> spoilt(1600, 0.0);
    for (std::size_t c = 0; c < 4; ++c) spoilt[c] = 1e9;
    EXPECT_EQ(right(doubles(spoilt, 4), table), 0);
    // … while rough estimators of the same light are welcome.
    for (const Noise noise : {exponential, visible})
        EXPECT_EQ(right(noisy(
                            random, 64, 64, 3, 1, [](int x, int y) { return floor_and_ball(x, y); }, noise),
                        expected),
                  1);
    EXPECT_EQ(right(noisy(
                        random, 64, 64, 3, 8, [](int x, int y) { return floor_and_ball(x, y); }, firefly),
                    expected),
              1);
}

// Their sum differs from any other by less than its noise, and cut at four means they have that mean.
TEST(Noise, huge_estimates_of_either_sign_prove_nothing)
{
    Random random(seed);
    for (const double chance : {0.07, 0.25, 0.5})
        for (const double size : {30.0, 1e5}) {
            const auto spikes = [&](const Tensor& expected) {
                std::vector<double> values(expected.count(), 1e-9);
                for (double& value : values)
                    if (random.uniform_double() < chance) value = (random.below(2) == 0 ? -1 : 1) * size;
                return with_values(expected, values);
            };
            for (const Tensor& expected : {run(random), estimates(random)})
                EXPECT_EQ(right(spikes(expected), expected), 0) << chance << " " << size;
        }
}

// A control variate takes away what it knows the mean of, and adds the mean.
TEST(Noise, differences_may_be_negative_now_and_then)
{
    Random random(seed);
    const Tensor expected = run(random);
    std::vector<double> values = to_doubles(run(random));
    for (double& value : values) value += 0.15 * (2 * random.uniform_double() - 1);
    ASSERT_LT(std::ranges::min(values), 0);
    EXPECT_EQ(right(with_values(expected, values), expected), 1);
}

TEST(Noise, what_is_no_number_is_wrong)
{
    Random random(seed);
    const Tensor expected = run(random);
    Tensor student = expected;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(student.bytes.data() + 400, &nan, sizeof nan);
    EXPECT_EQ(right(student, expected), 0);
    EXPECT_FALSE(judge(check, student, expected, nullptr).borderline) << "nothing that a second run could save";
    EXPECT_EQ(right(noisy(random, 32, 32, 3, 1, floor_and_ball), expected), 0) << "another size";
    EXPECT_EQ(right(as_bytes(expected), expected), 0) << "another type";
}

TEST(Noise, what_cannot_be_judged_is_a_fault_of_ours)
{
    Random random(seed);
    const auto judged_by_itself = [](const Tensor& tensor) { (void)judge(check, tensor, tensor, nullptr); };
    EXPECT_THROW(judged_by_itself(estimates(random, 1, 63)), std::invalid_argument)
        << "too few replicates to prove anything";
    EXPECT_NO_THROW(judged_by_itself(estimates(random, 1, 64)));
    EXPECT_THROW(judged_by_itself(grid(64, 64, std::vector<std::uint32_t>(4096, 1))), std::invalid_argument)
        << "ids have no mean";
    Tensor broken = estimates(random);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::memcpy(broken.bytes.data(), &nan, sizeof nan);
    EXPECT_THROW(judged_by_itself(broken), std::invalid_argument);
}

TEST(Noise, a_declared_bias_is_forgiven)
{
    Random random(seed);
    const Tensor expected = run(random);
    Random again(seed);
    const Tensor student = run(again, 1.02);
    Check generous = check;
    generous.tolerance = relative(0.021);
    EXPECT_LT(right(student, expected), 1);
    EXPECT_EQ(judge(generous, student, expected, nullptr).right, 1);
    generous.tolerance = relative(0.01);
    EXPECT_LT(judge(generous, student, expected, nullptr).right, 1);
    generous.tolerance = absolute(0.02);
    EXPECT_EQ(judge(generous, student, expected, nullptr).right, 1);
}

TEST(Noise, two_runs_are_judged_together)
{
    Judgement first;
    first.right = 1;
    first.error = 0.02;
    first.message = "";
    first.metrics = {{"probability", 3e-5}};
    first.chance = 3e-5;
    Judgement second = first;
    const Judgement wrong = judge_both(first, second);
    EXPECT_LT(wrong.metrics.at("probability"), check_alpha());
    EXPECT_LT(wrong.right, 1);
    EXPECT_GT(wrong.right, 0.5);
    EXPECT_FALSE(wrong.message.empty());
    EXPECT_EQ(wrong.metrics.at("probability_first"), 3e-5);
    // The worse of the two says what is wrong.
    second.metrics["probability"] = 2e-5;
    second.chance = 2e-5;
    second.message = "the light is too low";
    EXPECT_EQ(judge_both(first, second).message.find("the light is too low"), 0U);
    EXPECT_EQ(judge_both(second, first).message.find("the light is too low"), 0U);
    second.message = "";
    second.metrics["probability"] = 0.4;
    second.chance = 0.4;
    EXPECT_EQ(judge_both(first, second).right, 1);
    // Wrong by itself, saved by the second.
    first.metrics["probability"] = 5e-7;
    first.chance = 5e-7;
    first.right = 0.8;
    first.message = "too bright";
    EXPECT_EQ(judge_both(first, second).right, 1);
    EXPECT_TRUE(judge_both(first, second).message.empty());
    // A second run that broke down decides by itself.
    Judgement broken;
    broken.message = "crashed";
    EXPECT_EQ(judge_both(first, broken).right, 0);
    EXPECT_EQ(judge_both(first, broken).message, "crashed");
}

}
}
