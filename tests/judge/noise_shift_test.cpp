#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>
#include <vector>

#include "judge/noise/noise.hpp"
#include "judge/statistics/error_budget.hpp"
#include "noise_runs.hpp"
#include "right_pictures.hpp"

// Noisy pictures that lie a pixel beside their place: found, and no right one accused of it.
namespace umbral::grader::test {
namespace {

/// Two bricks on a dark ground, 32 samples a pixel; no light leaves the picture where it is moved.
Tensor bricks(Random& random, int right, int down)
{
    const auto brick = [](int x, int y) { return x >= 8 && x < 39 && y % 32 >= 6 && y % 32 < 17 ? 0.3 : 0.05; };
    const Light light = [=](int x, int y) { return brick(x - right, y - down); };
    return noisy(random, 64, 64, 3, 32, light, uniform);
}

TEST(NoiseShift, a_picture_a_pixel_off_is_found_and_its_direction_said)
{
    SCOPED_TRACE(seed);
    struct Case {
        int right;
        int down;
        const char* words;
    };
    for (const Case& one :
         {Case{1, 0, "The picture lies too far to the right"}, Case{-1, 0, "The picture lies too far to the left"},
          Case{0, 1, "The picture lies too far down"}, Case{0, -1, "The picture lies too far up"}}) {
        Random random(seed);
        const Tensor expected = bricks(random, 0, 0);
        const Judgement found = judge(check, bricks(random, one.right, one.down), expected, nullptr);
        EXPECT_LT(found.right, 0.91) << one.words;
        EXPECT_EQ(found.message.rfind(one.words, 0), 0U) << found.message;
        EXPECT_LT(found.metrics.at("probability"), check_alpha()) << one.words;
        const Tensor bytes = as_bytes(bricks(random, one.right, one.down));
        EXPECT_LT(judge(check, bytes, as_bytes(expected), nullptr).right, 0.91) << one.words << ", in bytes";
    }
}

// No tile's mean moves: in dots of light on a dark ground only the alignment shows that all of them lie beside their
// places.
TEST(NoiseShift, what_no_mean_shows_is_found)
{
    Random random(seed);
    const auto dots = [](int x, int y) { return 0.1 + (x % 4 == 2 && y % 4 == 2 ? 0.4 : 0.0); };
    const Tensor expected = noisy(random, 64, 64, 1, 16, dots);
    EXPECT_EQ(judge(check, noisy(random, 64, 64, 1, 16, dots), expected, nullptr).right, 1);
    const Tensor moved = noisy(random, 64, 64, 1, 16, [&](int x, int y) { return dots(x - 1, y); });
    const Judgement found = judge(check, moved, expected, nullptr);
    EXPECT_LT(found.right, 1);
    EXPECT_EQ(found.message.rfind("The picture lies too far to the right", 0), 0U) << found.message;
}

TEST(NoiseShift, a_bias_is_told_as_a_bias)
{
    Random random(seed);
    const Tensor expected = run(random);
    for (const double factor : {0.5, 0.95, 1.05, 2.0}) {
        const Judgement found = judge(check, run(random, factor), expected, nullptr);
        EXPECT_EQ(found.message.find("too far"), std::string::npos) << factor << " " << found.message;
    }
}

// By the definition: squared differences of six alignments, of pictures with an empty border.
TEST(NoiseShift, the_sum_compares_squared_differences)
{
    Random random(seed);
    const Light inside = [](int x, int y) { return x < 6 || y < 6 || x > 56 || y > 56 ? 0 : floor_and_ball(x, y); };
    const Estimates yours = noisy_estimates(random, 2, exponential, inside);
    const Estimates expected = noisy_estimates(random, 2, exponential, inside);
    const auto squares = [&](int right, int down) {
        double sum = 0;
        for (int y = 1; y < 31; ++y)
            for (int x = 1; x < 31; ++x) {
                const double moved = yours.values[static_cast<std::size_t>(32 * (y - down) + x - right)];
                const double difference = moved - expected.values[static_cast<std::size_t>(32 * y + x)];
                sum += difference * difference;
            }
        return sum;
    };
    for (const bool vertical : {false, true}) {
        const auto side = [&](int step) {
            const auto at = [&](int aside) { return vertical ? squares(aside, step) : squares(step, aside); };
            return at(-1) + 2 * at(0) + at(1);
        };
        double slopes = 0;
        for (int y = 1; y < 31; ++y)
            for (int x = 1; x < 31; ++x) {
                const auto mean = [&](int i, int j) {
                    const auto n = static_cast<std::size_t>(32 * (y + (vertical ? i : j)) + x + (vertical ? j : i));
                    return (yours.values[n] + expected.values[n]) / 2;
                };
                slopes +=
                    std::abs(mean(1, -1) + 2 * mean(1, 0) + mean(1, 1) - mean(-1, -1) - 2 * mean(-1, 0) - mean(-1, 1)) /
                    8 / 900;
            }
        const TileSums sums = alignment_sums(yours, expected, 0, vertical).sums;
        EXPECT_NEAR(sums.difference * slopes * 16, side(-1) - side(1), 1e-9) << vertical;
        // Exchanging the two turns the sign and nothing else.
        const TileSums turned = alignment_sums(expected, yours, 0, vertical).sums;
        EXPECT_EQ(turned.difference, -sums.difference);
        EXPECT_EQ(turned.squares, sums.squares);
    }
}

TEST(NoiseShift, right_pictures_are_not_accused)
{
    expect_uniform("the alignment", [](const Estimates& a, const Estimates& b, int i) {
        return std::vector{alignment_sums(a, b, 0, i % 2 == 1).sums};
    });
}

TEST(NoiseShift, narrow_pictures_and_flat_ones_have_no_alignment)
{
    const Estimates thin{2, 40, 1, true, std::vector<double>(80, 0.5), {}};
    EXPECT_EQ(deviation_of(alignment_sums(thin, thin, 0, false).sums, forgiven_floats), 0);
    const Estimates flat{40, 40, 1, true, std::vector<double>(1600, 0.5), {}};
    const Estimates other{40, 40, 1, true, std::vector<double>(1600, 0.6), {}};
    const TileSums sums = alignment_sums(other, flat, 0, true).sums;
    EXPECT_EQ(tile_probability(sums, deviation_of(sums, forgiven_floats)), 1);
}

}
}
