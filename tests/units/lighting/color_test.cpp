#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <umbral/core/random.hpp>
#include <vector>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "color_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class ColorSolution : public testing::TestWithParam<const char*> {
protected:
    const ColorFunctions& unit = *tests::solution<ColorFunctions>(GetParam());

    [[nodiscard]] int code(float light) const { return unit.to_pixel(glm::vec3(light)).x; }
};
INSTANTIATE_TEST_SUITE_P(Solutions, ColorSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

// The other way round: bisection of the decoding curve, whose power is taken by fifth roots in long double.
long double encoded_by_bisection(long double light)
{
    const auto decoded = [](long double v) {
        if (v <= 0.04045L) return v / 12.92L;
        const long double base = (v + 0.055L) / 1.055L;
        return base * base * std::exp(0.4L * std::log(base));
    };
    long double low = 0;
    long double high = 1;
    for (int i = 0; i < 80; ++i) {
        const long double middle = (low + high) / 2;
        (decoded(middle) < light ? low : high) = middle;
    }
    return low;
}

}

// The course's mixtures, and the statement's numbers.
TEST_P(ColorSolution, known_answers)
{
    const std::vector<Lamp> all = {{{1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, 0, 1}, 1}};
    EXPECT_EQ(unit.add_lights(all), glm::vec3(1));
    EXPECT_EQ(unit.add_lights(std::span(all).first(2)), glm::vec3(1, 1, 0));
    EXPECT_EQ(unit.add_lights(std::span(all).last(2)), glm::vec3(0, 1, 1));
    EXPECT_EQ(unit.add_lights({}), glm::vec3(0));
    EXPECT_NEAR(unit.encode_srgb(0.5F), 0.73536, 5e-6);
    EXPECT_NEAR(unit.encode_srgb(0.002F), 0.02584, 5e-6);
    EXPECT_NEAR(unit.decode_srgb(0.5F), 0.21404, 5e-6);
    EXPECT_EQ(unit.to_pixel({0.5F, 0.002F, 1}), glm::u8vec3(188, 7, 255));
    EXPECT_EQ(unit.mean_pixel(std::vector<glm::u8vec3>{{0, 0, 0}, {255, 255, 255}}), glm::u8vec3(188));
    EXPECT_EQ(unit.mean_pixel({}), glm::u8vec3(0));
}

TEST_P(ColorSolution, all_codes_come_back)
{
    for (int code = 0; code < 256; ++code) {
        const glm::u8vec3 pixel(code, 255 - code, 37 * code % 256);
        EXPECT_EQ(unit.to_pixel(unit.to_light(pixel)), pixel);
        EXPECT_EQ(unit.mean_pixel(std::vector<glm::u8vec3>(3, pixel)), pixel);
    }
}

TEST_P(ColorSolution, what_no_screen_shows)
{
    for (const float dark : {-1e-30F, -0.5F, -infinity, not_a_number}) {
        EXPECT_EQ(unit.encode_srgb(dark), 0);
        EXPECT_EQ(unit.decode_srgb(dark), 0);
        EXPECT_EQ(unit.to_pixel({dark, 0.5F, dark}), glm::u8vec3(0, 188, 0));
    }
    for (const float bright : {1.0F, 1.5F, 1e30F, infinity}) {
        EXPECT_EQ(unit.encode_srgb(bright), 1);
        EXPECT_EQ(unit.decode_srgb(bright), 1);
        EXPECT_EQ(unit.to_pixel({0.5F, bright, 0}), glm::u8vec3(188, 255, 0));
    }
    EXPECT_EQ(unit.add_lights(std::vector<Lamp>{{{3, 0, 0}, 4}}), glm::vec3(12, 0, 0)) << "light is not clamped";
}

TEST_P(ColorSolution, the_curve_is_what_bisection_finds)
{
    constexpr std::uint64_t seed = 20411;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        const float light = std::exp2(random.uniform(-12, 0));
        // At the joint the standard's two pieces differ by 2e-8.
        EXPECT_NEAR(unit.encode_srgb(light), static_cast<double>(encoded_by_bisection(light)), 1.2e-7)
            << "seed " << seed << ", light " << light;
    }
}

// With the oracle's exactness at the borders and a curve that only climbs, each float has its nearest code.
TEST_P(ColorSolution, codes_climb_and_change_at_the_borders)
{
    int last = 0;
    for (int i = 0; i <= 100'000; ++i) {
        const int now = code(static_cast<float>(i) * 1e-5F);
        ASSERT_TRUE(now == last || now == last + 1) << "at " << i;
        last = now;
    }
    EXPECT_EQ(last, 255);
}

TEST(ColorReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20412;
    const auto& reference = *tests::solution<ColorFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<ColorFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 100'000; ++i) {
        const float x = std::exp2(random.uniform(-30, 0));
        ASSERT_LE(tests::ulps_between(reference.encode_srgb(x), oracle.encode_srgb(x)), 1) << "seed " << seed;
        ASSERT_LE(tests::ulps_between(reference.decode_srgb(x), oracle.decode_srgb(x)), 1) << "seed " << seed;
    }
    for (int code = 0; code < 255; ++code) {
        float light = oracle.decode_srgb((static_cast<float>(code) + 0.5F) / 255);
        for (int step = 0; step < 40; ++step) light = std::nextafter(light, 0.0F);
        for (int step = 0; step < 80; ++step, light = std::nextafter(light, 1.0F))
            ASSERT_EQ(reference.to_pixel(glm::vec3(light)), oracle.to_pixel(glm::vec3(light))) << "code " << code;
    }
}

TEST(ColorReference, sums_of_many_lamps)
{
    constexpr std::uint64_t seed = 20413;
    const auto& reference = *tests::solution<ColorFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<ColorFunctions>(ORACLE_MODULE);
    const auto& in_float = *tests::solution<ColorFunctions>(IN_FLOAT_MODULE);
    Random random(seed);
    std::vector<Lamp> lamps(20'000);
    for (Lamp& lamp : lamps) lamp = {0.5F + 0.5F * random.in_cube(), 1e-4F * random.uniform()};
    lamps.front() = {glm::vec3(9000), 1};
    const glm::vec3 exact = oracle.add_lights(lamps);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(tests::ulps_between(reference.add_lights(lamps)[i], exact[i]), 1) << "seed " << seed;
        EXPECT_GT(tests::ulps_between(in_float.add_lights(lamps)[i], exact[i]), 20) << "the hard case tells them apart";
    }
}

// Halving a picture: the mean of the light, by sums in long double and the curve by bisection.
TEST_P(ColorSolution, mean_pixel_is_the_mean_of_light)
{
    constexpr std::uint64_t seed = 20414;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        std::vector<glm::u8vec3> pixels(1 + random.below(9));
        long double green = 0;
        for (glm::u8vec3& pixel : pixels) {
            const std::uint32_t bits = random.bits();
            pixel = {bits & 255U, bits >> 8U & 255U, bits >> 16U & 255U};
            green += unit.to_light(pixel).g;
        }
        const long double expected = 255 * encoded_by_bisection(green / static_cast<long double>(pixels.size()));
        EXPECT_NEAR(unit.mean_pixel(pixels).g, static_cast<double>(expected), 0.5001) << "seed " << seed;
    }
}
