#include <gtest/gtest.h>

#include <numeric>
#include <pipeline/support.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "scan_conversion.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using Rasterize = void(const Triangle&, int, int, std::vector<Fragment>&);
using Corners = std::array<glm::vec2, 3>;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Triangle flat(const Corners& corners)
{
    return {WindowVertex{corners[0], 0, 1}, {corners[1], 0, 1}, {corners[2], 0, 1}};
}

std::vector<Fragment> fragments_of(Rasterize* rasterize, const Triangle& triangle, int width, int height)
{
    std::vector<Fragment> fragments;
    rasterize(triangle, width, height, fragments);
    return fragments;
}

/// What is covered as rows of text, '#' and '.'.
std::string drawn(Rasterize* rasterize, const Corners& corners, int width, int height)
{
    std::string text;
    for (int y = 0; y < height; ++y) text += std::string(static_cast<std::size_t>(width), '.') + "\n";
    for (const Fragment& fragment : fragments_of(rasterize, flat(corners), width, height))
        text[static_cast<std::size_t>(fragment.pixel.y * (width + 1) + fragment.pixel.x)] = '#';
    return text;
}

/// How often each pixel is covered.
Grid<int> counted(Rasterize* rasterize, const std::vector<Corners>& triangles, int width, int height)
{
    Grid<int> counts(width, height);
    for (const Corners& corners : triangles)
        for (const Fragment& fragment : fragments_of(rasterize, flat(corners), width, height))
            ++counts.at(fragment.pixel.x, fragment.pixel.y);
    return counts;
}

/// Every test here holds for the reference and for the oracle.
class RasterizeSolution : public testing::TestWithParam<const char*> {
protected:
    Rasterize* const rasterize = tests::solution<Rasterize>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, RasterizeSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

// Drawn by hand on squared paper.
TEST_P(RasterizeSolution, known_answers)
{
    EXPECT_EQ(drawn(rasterize, {glm::vec2(1, 1), {4, 1}, {1, 4}}, 5, 5), ".....\n.##..\n.#...\n.....\n.....\n");
    EXPECT_EQ(drawn(rasterize, {glm::vec2(4, 4), {1, 4}, {4, 1}}, 5, 5), ".....\n...#.\n..##.\n.###.\n.....\n")
        << "the other half takes the diagonal";
    EXPECT_EQ(drawn(rasterize, {glm::vec2(0.5F, 0.5F), {3.5F, 0.5F}, {3.5F, 3.5F}}, 4, 4), "###.\n.##.\n..#.\n....\n")
        << "corners on centres";
    EXPECT_EQ(drawn(rasterize, {glm::vec2(0.5F, 0.5F), {0.5F, 3.5F}, {3.5F, 3.5F}}, 4, 4), "....\n#...\n##..\n....\n");
    EXPECT_EQ(drawn(rasterize, {glm::vec2(-9, -9), {20, -9}, {-9, 20}}, 2, 2), "##\n##\n");
    EXPECT_EQ(drawn(rasterize, {glm::vec2(0.75F, 0.75F), {1.25F, 0.75F}, {1, 1.25F}}, 2, 2), "..\n..\n")
        << "between the centres";
}

TEST_P(RasterizeSolution, row_by_row_in_both_orientations)
{
    const std::vector<Fragment> one = fragments_of(rasterize, flat({glm::vec2(0, 0), {5, 1}, {2, 6}}), 6, 6);
    const std::vector<Fragment> other = fragments_of(rasterize, flat({glm::vec2(0, 0), {2, 6}, {5, 1}}), 6, 6);
    ASSERT_GT(one.size(), 8U);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].pixel, other[i].pixel);
    EXPECT_TRUE(std::is_sorted(one.begin(), one.end(), [](const Fragment& a, const Fragment& b) {
        return std::pair(a.pixel.y, a.pixel.x) < std::pair(b.pixel.y, b.pixel.x);
    }));
}

TEST_P(RasterizeSolution, appends_to_what_is_there)
{
    std::vector<Fragment> fragments(1, Fragment{{7, 7}, 0.5F, glm::vec3(0)});
    rasterize(flat({glm::vec2(0, 0), {2, 0}, {0, 2}}), 4, 4, fragments);
    ASSERT_EQ(fragments.size(), 2U);
    EXPECT_EQ(fragments[0].pixel, glm::ivec2(7, 7));
}

TEST_P(RasterizeSolution, positions_are_rounded_to_even_ties)
{
    // A left edge at 2.5 is covered, one at 2.5 + 1/256 is not; 2/1024 lies between them and goes to the even one, 2.5
    // = 640/256.
    const auto covers = [&](float left) {
        return !fragments_of(rasterize, flat({glm::vec2(left, 0), {left, 9}, {3.25F, 4}}), 3, 8).empty();
    };
    EXPECT_TRUE(covers(2.5F));
    EXPECT_TRUE(covers(2.5F + 2.0F / 1024));
    EXPECT_FALSE(covers(2.5F + 3.0F / 1024));
    EXPECT_TRUE(covers(2.5F - 2.0F / 1024));
}

TEST_P(RasterizeSolution, nonsense_leaves_no_trace)
{
    const Triangle good = flat({glm::vec2(0, 0), {8, 0}, {0, 8}});
    ASSERT_FALSE(fragments_of(rasterize, good, 8, 8).empty());
    for (std::size_t i = 0; i < 3; ++i) {
        const auto without = [&](auto change) {
            Triangle bad = good;
            change(bad[i]);
            return fragments_of(rasterize, bad, 8, 8).empty();
        };
        EXPECT_TRUE(without([](WindowVertex& v) { v.position.x = not_a_number; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.position.y = not_a_number; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.position.y = std::numeric_limits<float>::infinity(); }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.position.x = -16385; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.depth = not_a_number; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.inverse_w = not_a_number; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.inverse_w = 0; }));
        EXPECT_TRUE(without([](WindowVertex& v) { v.inverse_w = -2; }));
    }
    EXPECT_TRUE(fragments_of(rasterize, flat({glm::vec2(0.5F, 0.5F), {3.5F, 3.5F}, {7.5F, 7.5F}}), 8, 8).empty())
        << "a line through centres";
    EXPECT_TRUE(fragments_of(rasterize, flat({glm::vec2(0.5F, 2.5F), {3.5F, 2.5F}, {7.5F, 2.5F}}), 8, 8).empty());
    EXPECT_TRUE(fragments_of(rasterize, flat({glm::vec2(2.5F, 2.5F), {2.5F, 2.5F}, {2.5F, 2.5F}}), 8, 8).empty());
    EXPECT_TRUE(fragments_of(rasterize, good, 0, 8).empty());
    EXPECT_TRUE(fragments_of(rasterize, good, 8, 0).empty());
}

// Whatever the mesh, every pixel of the square belongs to exactly one triangle.
TEST_P(RasterizeSolution, partitions_cover_each_pixel_once)
{
    constexpr std::uint64_t seed = 20269;
    Random random(seed);
    for (int round = 0; round < 100; ++round) {
        const Grid<int> counts = counted(rasterize, random_partition(random, 6), 26, 26);
        for (int y = 0; y < 26; ++y)
            for (int x = 0; x < 26; ++x)
                ASSERT_EQ(counts.at(x, y), x < 24 && y < 24 ? 1 : 0)
                    << "seed " << seed << ", round " << round << ", " << x << ", " << y;
    }
}

TEST_P(RasterizeSolution, fans_cover_each_pixel_once)
{
    Random random(20270);
    for (const glm::vec2 centre : {glm::vec2(12.5F, 12.5F), {12, 12}, {12.5F, 12}, {12.25F, 12.625F}}) {
        const Grid<int> counts = counted(rasterize, fan(random, centre, 9), 25, 25);
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 25; ++x) {
                const glm::vec2 off = glm::vec2(x, y) + 0.5F - centre;
                const bool inside = off.x >= -9 && off.x < 9 && off.y >= -9 && off.y < 9;
                ASSERT_EQ(counts.at(x, y), inside ? 1 : 0)
                    << x << ", " << y << " round " << centre.x << ", " << centre.y;
            }
    }
}

// Corners in halves, quarters … 1/256 of a pixel: from nearly all on ties to nearly none.
TEST_P(RasterizeSolution, agrees_with_scan_conversion_in_rational_numbers)
{
    constexpr std::uint64_t seed = 20271;
    Random random(seed);
    for (int round = 0; round < 20'000; ++round) {
        const int parts = 1 << (1 + round % 8);
        Corners corners{};
        for (glm::vec2& corner : corners) {
            corner.x = on_grid(random, -6, 18, parts);
            corner.y = on_grid(random, -6, 18, parts);
        }
        const Grid<int> expected = tests::scan_converted(corners, 12, 12);
        const Grid<int> got = counted(rasterize, {corners}, 12, 12);
        ASSERT_EQ(got.cells, expected.cells) << "seed " << seed << ", round " << round;
    }
}

// Worked by hand: w = 1 and w = 10 at the ends of an edge. In the middle of the screen the far end has the weight 1/11,
// the depth is halfway.
TEST_P(RasterizeSolution, weights_in_perspective)
{
    const Triangle triangle = {WindowVertex{{0.5F, 0.5F}, 0.25F, 1}, {{8.5F, 0.5F}, 0.75F, 0.1F}, {{0.5F, 8.5F}, 1, 1}};
    for (const auto& [pixel, depth, weights] : fragments_of(rasterize, triangle, 9, 9)) {
        EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1.2e-7F);
        if (pixel == glm::ivec2(4, 0)) {
            EXPECT_NEAR(weights[1], 1.0F / 11, 1e-7F);
            EXPECT_EQ(depth, 0.5F);
        }
        if (pixel == glm::ivec2(0, 0)) {
            EXPECT_EQ(weights, glm::vec3(1, 0, 0));
            EXPECT_EQ(depth, 0.25F);
        }
    }
}

// The header's guarantee: the same pixels as the oracle, weights and depth within one ulp; inside the picture, far
// outside, in slivers.
TEST(RasterizeAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20272;
    const auto reference = tests::solution<Rasterize>(REFERENCE_MODULE);
    const auto oracle = tests::solution<Rasterize>(ORACLE_MODULE);
    Random random(seed);
    std::size_t fragments = 0;
    for (int round = 0; round < 4000; ++round) {
        Corners corners = unrounded_triangle(random, 24);
        if (round % 4 == 1) corners = needle(random, 40, 24, 1 << (round % 14), round % 8 == 1);
        if (round % 4 >= 2) corners = huge_triangle(random, 40, 24, round % 4 == 2);
        Triangle triangle = random_attributes(random, corners);
        triangle[random.below(3)].inverse_w *= std::exp2(random.uniform(-20, 20));
        const std::vector<Fragment> got = fragments_of(reference, triangle, 40, 24);
        const std::vector<Fragment> exact = fragments_of(oracle, triangle, 40, 24);
        ASSERT_EQ(got.size(), exact.size()) << "seed " << seed << ", round " << round;
        fragments += got.size();
        for (std::size_t i = 0; i < got.size(); ++i) {
            ASSERT_EQ(got[i].pixel, exact[i].pixel) << "seed " << seed << ", round " << round;
            ASSERT_LE(tests::ulps_between(got[i].depth, exact[i].depth), 1) << "seed " << seed << ", round " << round;
            for (int k = 0; k < 3; ++k)
                ASSERT_LE(tests::ulps_between(got[i].weights[k], exact[i].weights[k]), 1)
                    << "seed " << seed << ", round " << round;
        }
    }
    EXPECT_GT(fragments, 100'000U);
}

// Needles are what their name says: the centre that they are aimed at is covered, or passed, by less than 1e-6 pixel.
TEST(RasterizeInputs, needles_pass_a_centre_closely)
{
    constexpr std::uint64_t seed = 20274;
    Random random(seed);
    for (int round = 0; round < 2000; ++round) {
        const bool covers = round % 2 == 0;
        const Corners corners = needle(random, 40, 24, 16000, covers);
        const Grid<int> covered = tests::scan_converted(corners, 40, 24);
        const int count = std::accumulate(covered.cells.begin(), covered.cells.end(), 0);
        ASSERT_LE(count, 2) << "seed " << seed << ", round " << round;
        ASSERT_GE(count, covers ? 1 : 0) << "seed " << seed << ", round " << round;
        for (const glm::vec2& corner : corners) ASSERT_LE(std::max(std::abs(corner.x), std::abs(corner.y)), 16384);
    }
}

// The hard cases must tell the forms apart: edge functions in float get most needles wrong.
TEST(RasterizeAccuracy, float_fails_on_needles)
{
    const auto naive = tests::solution<Rasterize>(FLOAT_EDGES_MODULE);
    const auto oracle = tests::solution<Rasterize>(ORACLE_MODULE);
    Random random(20273);
    int wrong = 0;
    for (int round = 0; round < 400; ++round) {
        const Corners corners = needle(random, 40, 24, 16000, round % 2 == 0);
        wrong += counted(naive, {corners}, 40, 24).cells == counted(oracle, {corners}, 40, 24).cells ? 0 : 1;
    }
    EXPECT_GT(wrong, 100) << "of 400";
}
