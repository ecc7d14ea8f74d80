#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/noise/noise.hpp"
#include "judge/rows/tensor_view.hpp"
#include "noise_runs.hpp"

// How widely estimates may scatter.
namespace umbral::grader::test {
namespace {

// One estimate in 32 is 20 times too large, of either sign: what is wrong with all others is lost in the noise, where
// so much is allowed.
TEST(Noise, a_scatter_that_right_work_does_not_need_hides_nothing)
{
    Random random(seed);
    const auto hidden = [&](const Tensor& biased) {
        std::vector<double> values = to_doubles(biased);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (const std::size_t estimate = i / biased.components; estimate % 32 == 0)
                values[i] *= estimate % 64 == 0 ? 20 : -20;
        return with_values(biased, values);
    };
    const auto right = [](const Check& check, const Tensor& student, const Tensor& expected) {
        return judge(check, student, expected, nullptr).right;
    };
    const Tensor expected = estimates(random);
    const Tensor biased = estimates(random, 0.8);
    EXPECT_LT(right(noise_check(), biased, expected), 0.5);
    EXPECT_EQ(right(noise_check(30), hidden(biased), expected), 1) << "this attack is one";
    EXPECT_EQ(right(noise_check(5), hidden(biased), expected), 0);
    const Tensor picture = run(random);
    EXPECT_EQ(right(noise_check(5), hidden(run(random, 0.9)), picture), 0);
    EXPECT_EQ(right(noise_check(1.5), run(random), picture), 1) << "nor is right work accused";
    EXPECT_EQ(right(noise_check(1.5), estimates(random), expected), 1);
}

// The same where estimates that are all alike are spread slowly, over a sixth of the rows: neighbours hardly differ.
TEST(Noise, a_scatter_that_neighbours_do_not_show_hides_nothing)
{
    Random random(seed);
    constexpr int count = 256;
    std::vector<double> right;
    std::vector<double> guess;
    for (int i = 0; i < count; ++i) {
        right.push_back(0.5 * mean_of(random, exponential, 16));
        const double place = std::clamp((i - count / 2) / 20.0, -1.0, 1.0);
        const double wave = std::cos(std::numbers::pi / 2 * place);
        guess.push_back(0.4 * 12.8 * wave * wave);
    }
    const Tensor expected = doubles(right, 1);
    EXPECT_EQ(judge(noise_check(100), doubles(guess, 1), expected, nullptr).right, 1) << "this attack is one";
    EXPECT_EQ(judge(noise_check(5), doubles(guess, 1), expected, nullptr).right, 0);
}

// Where a bias of a tenth would still be told, any scatter will do.
TEST(Noise, a_scatter_that_hides_nothing_is_free)
{
    Random random(seed);
    const Tensor expected = doubles(std::vector<double>(4000, 0.5), 1);
    std::vector<double> values;
    for (int i = 0; i < 4000; ++i) values.push_back(0.5 + 0.1 * (2 * random.uniform_double() - 1));
    const Judgement found = judge(noise_check(1), doubles(values, 1), expected, nullptr);
    EXPECT_EQ(found.right, 1) << found.message;
    EXPECT_EQ(found.metrics.at("scatter"), 0);
}

// One of eight quantities is 2.5 times too large: hardly a tenth of all that is estimated, and no matter of noise.
TEST(Noise, a_quantity_that_is_far_off_is_not_called_scatter)
{
    Random random(seed);
    const auto table = [&](double factor) {
        std::vector<double> values;
        for (int i = 0; i < 4000; ++i)
            values.push_back((i % 8 == 5 ? factor : 1) * 0.5 * mean_of(random, exponential, 16));
        return doubles(values, 8);
    };
    const Judgement found = judge(noise_check(5), table(2.5), table(1), nullptr);
    EXPECT_EQ(found.right, 0);
    EXPECT_EQ(found.message.find("scatter"), std::string::npos) << found.message;
    EXPECT_NE(found.message.find("too"), std::string::npos) << found.message;
}

}
}
