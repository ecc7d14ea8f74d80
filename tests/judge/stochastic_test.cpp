#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <umbral/core/random.hpp>
#include <vector>

#include "judge/statistics/stochastic.hpp"
#include "support/all_tests.hpp"

namespace umbral::grader {
namespace {

using Light = std::function<double(int, int)>;

/// sRGB in 8 bits. From a table, since the tests encode some 100 million values: within a hundredth of a code but for
/// the darkest.
std::uint8_t encoded(double light)
{
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> codes(1 << 16);
        for (std::size_t i = 0; i < codes.size(); ++i) {
            const double value = (static_cast<double>(i) + 0.5) / static_cast<double>(codes.size());
            codes[i] = static_cast<std::uint8_t>(
                std::lround(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055)));
        }
        return codes;
    }();
    return table[static_cast<std::size_t>(std::min(std::max(light, 0.0), 0.99999) * static_cast<double>(table.size()))];
}

/// A path tracer's picture as far as statistics goes: every pixel the mean of `samples` exponential estimates of its
/// light, which is as skewed as rare bright paths are. Encoded as sRGB in 8 bits.
Picture rendered(Random& random, int width, int height, int channels, int samples, const Light& light)
{
    Picture picture{width, height, channels, {}};
    picture.planes.resize(static_cast<std::size_t>(channels) * (static_cast<std::size_t>(height) + 2) *
                          picture.stride());
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double sum = 0;
                for (int s = 0; s < samples; ++s) sum -= std::log1p(-random.uniform_double());
                picture.row(c, y)[x] = encoded(light(x, y) * sum / samples);
            }
    return picture;
}

/// A lit floor with a dark ball and a background without noise.
double scene(int x, int y)
{
    if (y < 12) return 0;
    return std::hypot(x - 30, y - 40) < 14 ? 0.02 : 0.05 + 0.004 * x;
}

TEST(Stochastic, right_pictures_are_hardly_ever_accused)
{
    const std::uint64_t seed = 20260101;
    SCOPED_TRACE(seed);
    Random random(seed);
    const int pairs = samples_for_tests(10000);
    int alarms = 0;
    for (int i = 0; i < pairs; ++i) {
        const Picture a = rendered(random, 64, 64, 1, 2, scene);
        const Picture b = rendered(random, 64, 64, 1, 2, scene);
        alarms += apply_stochastic_rule(a, b).agree ? 0 : 1;
    }
    RecordProperty("false_alarms", alarms);
    std::printf("false alarms: %d of %d pairs, %g of them allowed on average\n", alarms, pairs,
                pairs * stochastic_alpha);
    // One is the mean of 10,000 pairs; more than six have a chance of 1 in 12,000.
    EXPECT_LE(alarms, 6);
}

TEST(Stochastic, three_percent_too_bright_is_caught)
{
    // 16 samples a pixel, each with a standard deviation of its mean: noisier than diffuse light under next event
    // estimation.
    for (const double factor : {1.03, 0.97}) {
        Random random(3);
        int caught = 0;
        for (int i = 0; i < 10; ++i) {
            const Picture yours =
                rendered(random, 128, 128, 3, 16, [&](int x, int y) { return factor * scene(x / 2, y / 2); });
            const StochasticRule rule = apply_stochastic_rule(
                yours, rendered(random, 128, 128, 3, 16, [](int x, int y) { return scene(x / 2, y / 2); }));
            caught += rule.agree ? 0 : 1;
            EXPECT_GT(rule.worst_z * (factor - 1), 0) << "the sign says which is brighter";
        }
        EXPECT_EQ(caught, 10) << factor;
    }
}

TEST(Stochastic, a_local_mistake_is_found_in_its_tile)
{
    Random random(4);
    const auto with_hole = [](int x, int y) { return x >= 96 && x < 112 && y >= 160 && y < 176 ? 0.10 : 0.2; };
    const StochasticRule rule = apply_stochastic_rule(rendered(random, 256, 256, 1, 4, with_hole),
                                                      rendered(random, 256, 256, 1, 4, [](int, int) { return 0.2; }));
    EXPECT_FALSE(rule.agree);
    EXPECT_EQ(rule.x, 96);
    EXPECT_EQ(rule.y, 160);
    EXPECT_EQ(rule.width, 16);
    EXPECT_NE(rule.message().find("too low in the 16 x 16 pixels from (96, 160)"), std::string::npos) << rule.message();
}

TEST(Stochastic, what_noise_cannot_explain_is_no_noise)
{
    Random random(5);
    const Picture lit = rendered(random, 64, 64, 1, 4, scene);
    EXPECT_TRUE(apply_stochastic_rule(lit, lit).agree) << "a picture agrees with itself";
    const auto flat = [](double light) {
        Picture picture{64, 64, 1, {}};
        picture.planes.assign((64 + 2) * picture.stride(), encoded(light));
        return picture;
    };
    EXPECT_FALSE(apply_stochastic_rule(flat(0), flat(0.2)).agree) << "black for grey";
    EXPECT_FALSE(apply_stochastic_rule(flat(0.2), flat(0)).agree) << "grey for black";
    EXPECT_FALSE(apply_stochastic_rule(flat(0.22), flat(0.2)).agree) << "10 % without noise";
}

TEST(Stochastic, rounding_is_forgiven)
{
    // One code value apart everywhere, without noise: what two roundings can do to equal light.
    for (const int code : {1, 40, 128, 254}) {
        Picture a{64, 64, 1, {}};
        a.planes.assign((64 + 2) * a.stride(), static_cast<std::uint8_t>(code));
        Picture b = a;
        b.planes.assign(b.planes.size(), static_cast<std::uint8_t>(code + 1));
        EXPECT_TRUE(apply_stochastic_rule(b, a).agree) << code;
        b.planes.assign(b.planes.size(), static_cast<std::uint8_t>(std::min(code + 4, 255)));
        EXPECT_EQ(apply_stochastic_rule(b, a).agree, code + 4 > 255) << code;
    }
}

// Clipping takes light from noise that reaches beyond white: from fewer samples more, though both estimate the same.
TEST(Stochastic, clipping_at_white_is_forgiven)
{
    Random random(20260104);
    const auto bright = [](int x, int) { return x < 32 ? 0.85 : 0.3; };
    for (int i = 0; i < 20; ++i) {
        const Picture expected = rendered(random, 64, 64, 3, 64, bright);
        const StochasticRule fewer = apply_stochastic_rule(rendered(random, 64, 64, 3, 16, bright), expected);
        EXPECT_TRUE(fewer.agree) << fewer.message();
        // What is not clipped is judged as ever.
        const StochasticRule darker = apply_stochastic_rule(
            rendered(random, 64, 64, 3, 64, [&](int x, int y) { return bright(x, y) * (x < 32 ? 1 : 0.9); }), expected);
        EXPECT_FALSE(darker.agree);
        EXPECT_GE(darker.x + darker.width, 32);
    }
}

// The mean of codes would depend on how noisy a picture is; the mean of light does not.
TEST(Stochastic, fewer_samples_of_the_same_light_agree)
{
    Random random(20260105);
    const auto dim = [](int, int y) { return 0.05 + 0.003 * y; };
    for (int i = 0; i < 20; ++i) {
        const Picture expected = rendered(random, 64, 64, 3, 256, dim);
        const StochasticRule found = apply_stochastic_rule(rendered(random, 64, 64, 3, 8, dim), expected);
        EXPECT_TRUE(found.agree) << found.message();
    }
}

TEST(Stochastic, one_white_pixel_excuses_no_other)
{
    Random random(20260106);
    const auto lamps = [](int x, int y) { return x % 16 == 3 && y % 16 == 3 ? 100.0 : 0.3; };
    const Picture expected = rendered(random, 64, 64, 3, 64, lamps);
    EXPECT_FALSE(apply_stochastic_rule(rendered(random, 64, 64, 3, 64, [&](int x, int y) { return 0.9 * lamps(x, y); }),
                                       expected)
                     .agree);
}

// Two equal differences: of two random signs, every second pair is equal. No bound of the chance may lie below that;
// this one is reached.
TEST(Stochastic, the_bound_holds_for_two_values)
{
    const Estimates zero{1, 2, 1, false, {0, 0}, {}};
    const Estimates one{1, 2, 1, false, {1, 1}, {}};
    EXPECT_NEAR(apply_stochastic_rule(one, zero, {}).probability, 0.5, 1e-3);
}

// Of a skewed sum, the tail that is heavier than a normal one lies opposite to the long tail of its terms.
TEST(Stochastic, skewness_makes_one_tail_heavier)
{
    TileSums sums;
    sums.count = 256;
    sums.squares = 256;
    sums.cubes = 500;
    EXPECT_GT(tile_probability(sums, -3), 1.5 * std::erfc(3 / std::sqrt(2.0)));
    EXPECT_EQ(tile_probability(sums, 3), std::erfc(3 / std::sqrt(2.0)));
    sums.cubes = -500;
    EXPECT_GT(tile_probability(sums, 3), 1.5 * std::erfc(3 / std::sqrt(2.0)));
}

TEST(Stochastic, small_and_odd_sizes_are_judged)
{
    Random random(6);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 2}, {17, 3}, {15, 100}, {65, 33}}) {
        const Picture a = rendered(random, width, height, 3, 4, scene);
        const StochasticRule rule = apply_stochastic_rule(a, rendered(random, width, height, 3, 4, scene));
        EXPECT_TRUE(std::isfinite(rule.worst_z)) << width;
        EXPECT_TRUE(rule.agree) << width << " x " << height;
    }
}

}
}
