#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "judge/noise/noise.hpp"
#include "judge/statistics/error_budget.hpp"
#include "noise_runs.hpp"
#include "support/all_tests.hpp"

// That p-values of correct work are uniform where that is claimed, and never too small anywhere: this bounds the rate
// of false alarms, which counting failures of a few thousand pictures could not.
namespace umbral::grader::test {
namespace {

constexpr std::uint64_t seed = 20260314;

struct Model {
    const char* name;
    Noise noise;
};
constexpr Model models[] = {{"exponential", exponential}, {"uniform", uniform}, {"firefly", firefly}};

/// The p-value of one tile of 16 x 16 pixels, each the mean of `samples` estimates on both sides; the light varies
/// across it.
double tile_p(Random& random, Noise yours, int your_samples, Noise expected, int samples)
{
    Estimates a{16, 16, 1, true, std::vector<double>(256), {}};
    Estimates b = a;
    for (std::size_t i = 0; i < 256; ++i) {
        const double light = 0.02 + 0.001 * static_cast<double>(i);
        a.values[i] = light * mean_of(random, yours, your_samples);
        b.values[i] = light * mean_of(random, expected, samples);
    }
    const TileSums sums = tilings_of(a, b, 0).front().sums.front();
    return tile_probability(sums, deviation_of(sums, forgiven_floats));
}

/// Kolmogorov and Smirnov's distance of a sample from the uniform distribution, times the root of its size.
double distance_from_uniform(std::vector<double> p)
{
    std::sort(p.begin(), p.end());
    const auto n = static_cast<double>(p.size());
    double largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        largest = std::max({largest, (static_cast<double>(i) + 1) / n - p[i], p[i] - static_cast<double>(i) / n});
    return std::sqrt(n) * largest;
}

TEST(NoiseUniform, p_values_of_tiles_of_floats_are_uniform)
{
    SCOPED_TRACE(seed);
    Random random(seed);
    std::printf("seed %llu; distance of the p-values of tiles from uniform (1.63: chance 1 %%, 1.95: 0.1 %%)\n",
                static_cast<unsigned long long>(seed));
    for (const Model& model : models)
        for (const int samples : {1, 4, 16, 64}) {
            const int tiles = samples_for_tests(samples == 64 ? 1500 : 4000);
            std::vector<double> p;
            for (int i = 0; i < tiles; ++i) p.push_back(tile_p(random, model.noise, samples, model.noise, samples));
            const double distance = distance_from_uniform(p);
            std::printf("  %-12s %2d samples a pixel, %d tiles: %.2f\n", model.name, samples, tiles, distance);
            // With few samples of fireflies a few pixels carry the sum. That is not normal: only the tails are claimed,
            // which are lighter.
            EXPECT_LT(distance, model.noise == firefly && samples < 16 ? 5.0 : 1.95) << model.name << samples;
            for (const double x : {0.1, 0.01, 1e-3}) {
                const auto found =
                    static_cast<double>(std::count_if(p.begin(), p.end(), [&](double one) { return one <= x; }));
                EXPECT_LE(found, tiles * x + 3.3 * std::sqrt(tiles * x) + 1) << model.name << samples << " " << x;
            }
        }
}

TEST(NoiseUniform, other_estimators_of_the_same_light_are_not_accused)
{
    // The student samples worse or better than the reference: differences are skewed to one side, and symmetric no
    // more.
    SCOPED_TRACE(seed);
    Random random(seed + 1);
    const int tiles = samples_for_tests(40000);
    std::printf("seed %llu, %d tiles each: P(p <= x) / x of the bound that judges a tile\n",
                static_cast<unsigned long long>(seed + 1), tiles);
    for (const int samples : {1, 2, 4, 16}) {
        std::vector<double> p;
        for (int i = 0; i < tiles; ++i)
            p.push_back(i % 2 == 0 ? tile_p(random, exponential, samples, uniform, 2 * samples)
                                   : tile_p(random, uniform, 2 * samples, exponential, samples));
        std::printf("  exponential, %2d samples, against uniform: ", samples);
        for (const double x : {0.3, 0.1, 0.01, 1e-3}) {
            const auto found = static_cast<double>(
                std::count_if(p.begin(), p.end(), [&](double one) { return std::min(1.0, 3.179 * one) <= x; }));
            std::printf("  %g: %.2f", x, found / tiles / x);
            EXPECT_LE(found, tiles * x + 3 * std::sqrt(tiles * x)) << samples << " " << x;
        }
        std::printf("\n");
    }
}

/// P(|sum of w_i s_i| >= size of w times t) over all signs s, counted one by one.
double exact_tail(const std::vector<double>& weights, double sum)
{
    const std::size_t all = std::size_t{1} << weights.size();
    std::size_t count = 0;
    double current = 0;
    for (const double weight : weights) current -= weight;
    // Gray's code: one sign changes at a time.
    for (std::size_t i = 0; i < all; ++i) {
        if (std::abs(current) >= sum * (1 - 1e-12)) ++count;
        const auto bit = static_cast<std::size_t>(__builtin_ctzll(i + 1));
        if (bit >= weights.size()) break;
        current += (((i + 1) >> (bit + 1)) & 1U) == 0 ? 2 * weights[bit] : -2 * weights[bit];
    }
    return static_cast<double>(count) / static_cast<double>(all);
}

double bound(double deviation) { return 3.179 * std::erfc(deviation / std::sqrt(2.0)); }

TEST(NoiseUniform, the_bound_holds_for_every_sign_of_every_difference)
{
    // Where both sides estimate alike, in floats or in rounded and clipped bytes, a pixel's difference has either sign
    // with equal chance, given its size: all chances are counts of signs. Counted here for sizes of all kinds, to the
    // farthest tail there is.
    SCOPED_TRACE(seed);
    Random random(seed + 2);
    for (int trial = 0; trial < 60; ++trial) {
        const std::size_t n = 1 + random.below(16);
        std::vector<double> weights;
        for (std::size_t i = 0; i < n; ++i)
            weights.push_back(trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? random.uniform_double() : firefly(random));
        double squares = 0;
        for (const double weight : weights) squares += weight * weight;
        // The sums of some random signs, and the largest of all.
        for (int draw = 0; draw < 12; ++draw) {
            double sum = 0;
            for (const double weight : weights) sum += draw == 0 || random.below(4) > 0 ? weight : -weight;
            sum = std::abs(sum);
            EXPECT_LE(exact_tail(weights, sum), bound(sum / std::sqrt(squares)) * (1 + 1e-12)) << n << " " << sum;
        }
    }
}

TEST(NoiseUniform, the_bound_holds_in_the_far_tail_of_equal_differences)
{
    // Differences of one size make the heaviest tails. Binomial ones, exactly, for up to 4096 pixels: down to 1e-300.
    double worst = 0;
    for (const int n : {1, 2, 3, 5, 16, 63, 64, 255, 256, 1024, 4096}) {
        double tail = 0;  // P(sum >= k), from the far end
        for (int plus = n; 2 * plus > n; --plus) {
            tail += std::exp(std::lgamma(n + 1.0) - std::lgamma(plus + 1.0) - std::lgamma(n - plus + 1.0) -
                             n * std::log(2.0));
            const double deviation = (2 * plus - n) / std::sqrt(static_cast<double>(n));
            if (bound(deviation) < 1e-300 || tail < 1e-300) continue;
            worst = std::max(worst, 2 * tail / bound(deviation));
            ASSERT_LE(2 * tail, bound(deviation) * (1 + 1e-9)) << n << " " << plus;
        }
    }
    std::printf("worst tail over its bound: %.4f\n", worst);
    EXPECT_GT(worst, 0.99) << "two pixels reach the bound: its factor cannot be smaller";
}

std::string name_of(const char* what, int samples)
{
    return std::string(what) + ", " + std::to_string(samples) + (samples == 1 ? " sample" : " samples");
}

/// Counts of pictures whose probability is at most x, against what x allows.
void expect_super_uniform(const std::vector<double>& p, const char* what)
{
    std::printf("  %-34s", what);
    const auto n = static_cast<double>(p.size());
    for (const double x : {0.5, 0.1, 0.01, 0.002}) {
        const auto found = static_cast<double>(std::count_if(p.begin(), p.end(), [&](double one) { return one <= x; }));
        std::printf("  %g: %.2f", x, found / n / x);
        EXPECT_LE(found, n * x + 3 * std::sqrt(n * x)) << what << " " << x;
    }
    std::printf("\n");
}

TEST(NoiseUniform, probabilities_of_pictures_are_never_too_small)
{
    SCOPED_TRACE(seed);
    Random random(seed + 3);
    const int pairs = samples_for_tests(4000);
    std::printf("seed %llu, %d pairs of pictures each: P(probability <= x) / x\n",
                static_cast<unsigned long long>(seed + 3), pairs);
    Check check = noise_check();
    for (const int samples : {1, 4, 16}) {
        std::vector<double> of_floats;
        std::vector<double> of_bytes;
        std::vector<double> of_other;
        for (int i = 0; i < pairs; ++i) {
            const auto light = [](int x, int y) { return floor_and_ball(2 * x, 2 * y); };
            const Tensor a = noisy(random, 32, 32, 1, samples, light);
            const Tensor b = noisy(random, 32, 32, 1, samples, light);
            of_floats.push_back(judge(check, a, b, nullptr).metrics.at("probability"));
            of_bytes.push_back(judge(check, as_bytes(a), as_bytes(b), nullptr).metrics.at("probability"));
            if (i % 2 == 0)
                of_other.push_back(judge(check, noisy(random, 32, 32, 1, samples, light, visible), b, nullptr)
                                       .metrics.at("probability"));
        }
        expect_super_uniform(of_floats, name_of("floats", samples).c_str());
        expect_super_uniform(of_bytes, name_of("bytes", samples).c_str());
        expect_super_uniform(of_other, name_of("floats, another estimator", samples).c_str());
    }
}

TEST(NoiseUniform, three_percent_are_found)
{
    SCOPED_TRACE(seed);
    Random random(seed + 4);
    constexpr int pairs = 200;
    std::printf(
        "seed %llu: 3 %% too bright everywhere, 64 x 64 pixels in grey, noise of one mean a sample; wrong at the level "
        "of one check of %g\n",
        static_cast<unsigned long long>(seed + 4), check_alpha());
    Check check = noise_check();
    const auto flat = [](int, int) { return 0.2; };
    const auto bright = [](int, int) { return 0.206; };
    for (const int samples : {4, 16, 64}) {
        int one_run = 0;
        int two_runs = 0;
        for (int i = 0; i < pairs; ++i) {
            const auto run = [&] {
                return judge(check, noisy(random, 64, 64, 1, samples, bright), noisy(random, 64, 64, 1, samples, flat),
                             nullptr);
            };
            const Judgement first = run();
            one_run += first.right < 1 ? 1 : 0;
            const bool wrong = first.borderline ? judge_both(first, run()).right < 1 : first.right < 1;
            two_runs += wrong ? 1 : 0;
        }
        std::printf("  %2d samples a pixel: found %.3f in one run, %.3f with a second where it is borderline\n",
                    samples, one_run / double{pairs}, two_runs / double{pairs});
        EXPECT_GE(two_runs, pairs * (samples == 64 ? 1.0 : samples == 16 ? 0.6 : 0.0));
        EXPECT_GE(two_runs, one_run - pairs / 20) << "a second run loses nothing to speak of";
    }
}

}
}
