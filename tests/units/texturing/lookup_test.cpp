#include <gtest/gtest.h>

#include <texturing/support.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::texturing;
using Lookup = glm::vec4(const Grid<glm::vec4>&, const Sampler&, glm::vec2);

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr Sampler nearest_repeat{Filter::nearest, Wrap::repeat, Wrap::repeat};
constexpr Sampler nearest_clamped{Filter::nearest, Wrap::clamp_to_edge, Wrap::clamp_to_edge};
constexpr Sampler bilinear_repeat{Filter::bilinear, Wrap::repeat, Wrap::repeat};
constexpr Sampler bilinear_clamped{Filter::bilinear, Wrap::clamp_to_edge, Wrap::clamp_to_edge};

/// One row of greys.
Grid<glm::vec4> row(const std::vector<float>& greys)
{
    Grid<glm::vec4> texture(static_cast<int>(greys.size()), 1);
    for (std::size_t i = 0; i < greys.size(); ++i) texture.cells[i] = glm::vec4(greys[i]);
    return texture;
}

/// Texel i has the grey i.
Grid<glm::vec4> numbered(int count)
{
    std::vector<float> greys;
    for (int i = 0; i < count; ++i) greys.push_back(static_cast<float>(i));
    return row(greys);
}

/// Every test here holds for the reference and for the oracle.
class LookupSolution : public testing::TestWithParam<const char*> {
protected:
    Lookup* const lookup = tests::solution<Lookup>(GetParam());

    [[nodiscard]] float grey(const Grid<glm::vec4>& texture, const Sampler& sampler, float u) const
    {
        return lookup(texture, sampler, {u, 0.5F}).x;
    }
};
INSTANTIATE_TEST_SUITE_P(Solutions, LookupSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

TEST_P(LookupSolution, lower_left_corner_is_the_origin)
{
    Grid<glm::vec4> texture(2, 2);  // red, green above blue, white
    texture.cells = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    EXPECT_EQ(lookup(texture, nearest_repeat, {0, 0}), glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(lookup(texture, nearest_repeat, {0.75F, 0.25F}), glm::vec4(1, 1, 1, 1));
    EXPECT_EQ(lookup(texture, nearest_repeat, {0.25F, 0.75F}), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(lookup(texture, nearest_clamped, {1, 1}), glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(lookup(texture, bilinear_clamped, {0.5F, 0.5F}), glm::vec4(0.5F, 0.5F, 0.5F, 1));
    EXPECT_EQ(lookup(texture, bilinear_clamped, {0.25F, 0.5F}), glm::vec4(0.5F, 0, 0.5F, 1));
}

// The statement's numbers.
TEST_P(LookupSolution, known_answers)
{
    const Grid<glm::vec4> texture = row({0, 0.25F, 0.5F, 1});
    EXPECT_EQ(grey(texture, nearest_repeat, 0.4375F), 0.25F);
    EXPECT_EQ(grey(texture, bilinear_repeat, 0.4375F), 0.3125F);
    EXPECT_EQ(grey(texture, bilinear_clamped, 0), 0);
    EXPECT_EQ(grey(texture, bilinear_repeat, 0), 0.5F);
    EXPECT_EQ(grey(texture, bilinear_repeat, 1), 0.5F);
    EXPECT_EQ(grey(texture, bilinear_repeat, -0.5625F), 0.3125F) << "once round";
}

TEST_P(LookupSolution, borders_belong_to_the_texel_after_them)
{
    const Grid<glm::vec4> texture = numbered(8);
    for (int i = 0; i < 8; ++i) {
        const float border = static_cast<float>(i) / 8;
        EXPECT_EQ(grey(texture, nearest_repeat, border), static_cast<float>(i));
        EXPECT_EQ(grey(texture, nearest_repeat, std::nextafter(border, -1.0F)), static_cast<float>((i + 7) % 8));
        EXPECT_EQ(grey(texture, nearest_clamped, std::nextafter(border, -1.0F)),
                  static_cast<float>(std::max(i - 1, 0)));
        EXPECT_EQ(grey(texture, bilinear_repeat, border + 1.0F / 16), static_cast<float>(i))
            << "a centre is its texel's own";
    }
    EXPECT_EQ(grey(texture, nearest_repeat, 1), 0);
    EXPECT_EQ(grey(texture, nearest_clamped, 1), 7);
}

// With three texels no border is a float: on which side a float lies, exact arithmetic says (3 * u against whole
// numbers, in double).
TEST_P(LookupSolution, floats_beside_borders_that_are_none)
{
    for (const int count : {3, 5, 7, 100, 300, 1000, 16383}) {
        const Grid<glm::vec4> texture = numbered(count);
        for (int i = 1; i < count; i += 1 + count / 64) {
            const auto near = static_cast<float>(static_cast<double>(i) / count);
            for (const float u : {std::nextafter(near, 0.0F), near, std::nextafter(near, 1.0F)}) {
                const float expected = double{u} * count < i ? static_cast<float>(i - 1) : static_cast<float>(i);
                ASSERT_EQ(grey(texture, nearest_repeat, u), expected) << u << " of " << count;
                ASSERT_EQ(grey(texture, nearest_clamped, u), expected) << u << " of " << count;
            }
        }
    }
}

TEST_P(LookupSolution, what_lies_far_out)
{
    const Grid<glm::vec4> texture = numbered(256);
    EXPECT_EQ(grey(texture, nearest_repeat, 1e6F + 0.3125F), 80);  // 0.3125 * 256
    EXPECT_EQ(grey(texture, bilinear_repeat, 1e6F + 0.3125F), 79.5F);
    EXPECT_EQ(grey(texture, nearest_repeat, -1e6F - 0.3125F), 176);
    EXPECT_EQ(grey(texture, nearest_repeat, 3e38F), 0) << "a whole number, as all floats of that size";
    EXPECT_EQ(grey(texture, nearest_clamped, 3e38F), 255);
    for (const float tiny : {1e-10F, 1e-20F, 1e-45F}) {
        EXPECT_EQ(grey(texture, nearest_repeat, -tiny), 255) << "just below 0 lies the last texel";
        EXPECT_EQ(grey(texture, nearest_repeat, tiny), 0);
        EXPECT_NEAR(grey(texture, bilinear_repeat, -tiny), 127.5F, 1e-4F);
    }
}

TEST_P(LookupSolution, nonsense_counts_as_zero)
{
    const Grid<glm::vec4> texture = numbered(4);
    for (const Sampler& sampler : {nearest_repeat, nearest_clamped, bilinear_repeat, bilinear_clamped}) {
        EXPECT_EQ(grey(texture, sampler, not_a_number), grey(texture, sampler, 0));
        EXPECT_EQ(lookup(texture, sampler, {0.6F, not_a_number}), lookup(texture, sampler, {0.6F, 0}));
    }
    EXPECT_EQ(grey(texture, nearest_repeat, infinity), 0);
    EXPECT_EQ(grey(texture, nearest_repeat, -infinity), 0);
    EXPECT_EQ(grey(texture, nearest_clamped, infinity), 3);
    EXPECT_EQ(grey(texture, nearest_clamped, -infinity), 0);
}

TEST_P(LookupSolution, one_texel_is_everywhere)
{
    const Grid<glm::vec4> texture(1, 1, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    for (const Sampler& sampler : {nearest_repeat, nearest_clamped, bilinear_repeat, bilinear_clamped})
        for (const float u : {-3.7F, -1.0F, 0.0F, 0.3F, 1.0F, 12.9F})
            for (int channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(lookup(texture, sampler, {u, -u})[channel], texture.cells[0][channel], 6e-8F) << "at " << u;
}

// A repeated texture has no edges: a blend changes by little over a small step, wherever it is, and is the same one
// turn further.
TEST_P(LookupSolution, blends_are_continuous_and_periodic)
{
    constexpr std::uint64_t seed = 20266;
    Random random(seed);
    const Grid<glm::vec4> texture = random_texture(random, 5, 7);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec2 uv(random.uniform(-2, 2), random.uniform(-2, 2));
        const glm::vec4 here = lookup(texture, bilinear_repeat, uv);
        const glm::vec4 beside = lookup(texture, bilinear_repeat, uv + glm::vec2(1e-4F, -1e-4F));
        const glm::vec4 around = lookup(texture, bilinear_repeat, uv + glm::vec2(1, -1));
        for (int channel = 0; channel < 4; ++channel) {
            ASSERT_NEAR(here[channel], beside[channel], 12 * 1.2e-4F)
                << "seed " << seed << ", at " << uv.x << ", " << uv.y;
            ASSERT_NEAR(here[channel], around[channel], 1e-5F) << "seed " << seed << ", at " << uv.x << ", " << uv.y;
        }
    }
}

TEST(LookupReference, refuses_a_texture_without_texels)
{
    const auto lookup = tests::solution<Lookup>(REFERENCE_MODULE);
    EXPECT_THROW(lookup(Grid<glm::vec4>(0, 3), nearest_repeat, {0, 0}), std::invalid_argument);
}

// The header's guarantee, with sizes and coordinates of all magnitudes: the same texels, and fractions off by at most
// half an ulp of 1.
TEST(LookupAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20267;
    const auto reference = tests::solution<Lookup>(REFERENCE_MODULE);
    const auto oracle = tests::solution<Lookup>(ORACLE_MODULE);
    Random random(seed);
    const std::vector<Grid<glm::vec4>> textures = {random_texture(random, 1, 16384), random_texture(random, 300, 77),
                                                   random_texture(random, 13, 4)};
    for (int i = 0; i < 300'000; ++i) {
        const Grid<glm::vec4>& texture = textures[random.below(3)];
        glm::vec2 uv(0);
        for (int axis = 0; axis < 2; ++axis)
            uv[axis] = std::exp2(random.uniform(-60, 24)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        Sampler sampler{Filter::nearest, random_wrap(random), random_wrap(random)};
        ASSERT_EQ(reference(texture, sampler, uv), oracle(texture, sampler, uv))
            << "seed " << seed << ", at " << uv.x << ", " << uv.y;
        sampler.filter = Filter::bilinear;
        const glm::vec4 error = abs(reference(texture, sampler, uv) - oracle(texture, sampler, uv));
        ASSERT_LE(std::max(std::max(error.x, error.y), std::max(error.z, error.w)), 3e-7F)
            << "seed " << seed << ", at " << uv.x << ", " << uv.y;
    }
}

// The hard cases must tell the forms apart.
TEST(LookupAccuracy, multiplying_first_fails_far_out)
{
    const auto naive = tests::solution<Lookup>(FLOAT_PRODUCT_MODULE);
    const auto oracle = tests::solution<Lookup>(ORACLE_MODULE);
    const Grid<glm::vec4> texture = numbered(300);
    Random random(20268);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 uv(random.uniform(-1e6F, 1e6F), 0.5F);
        wrong += naive(texture, bilinear_repeat, uv) == oracle(texture, bilinear_repeat, uv) ? 0 : 1;
    }
    EXPECT_GT(wrong, 1000) << "of 2000";
}
