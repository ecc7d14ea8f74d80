#include <gtest/gtest.h>

#include <cmath>
#include <texturing/support.hpp>
#include <umbral/texturing/mipmap.hpp>

// Linked with the reference. What is expected was worked out by hand, is a mean of the texture's own texels in double,
// or follows from a law.

using namespace umbral;
using namespace umbral::texturing;

namespace {

void expect_near(glm::vec4 actual, glm::vec4 expected, float tolerance)
{
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance);
}

}

TEST(Mipmap, known_answers)
{
    EXPECT_FLOAT_EQ(level_at_distance(6, 2), std::log2(3.0F));
    EXPECT_EQ(level_at_distance(64, 2), 5);
    EXPECT_EQ(level_at_distance(1, 2), 0);
    EXPECT_FLOAT_EQ(level_of_step({0.75F, 1}, {0, 0}, {8, 8}), std::log2(10.0F));
    EXPECT_EQ(level_of_step({0, 0}, {0, 0}, {8, 8}), 0);
    EXPECT_EQ(level_of_step({0.25F, 0}, {0, 0.5F}, {64, 16}), 4);
    Grid<glm::vec4> four(2, 2);
    four.cells = {glm::vec4(1), glm::vec4(2), glm::vec4(3), glm::vec4(6)};
    const Mipmap mipmap = build_mipmap(four);
    ASSERT_EQ(mipmap.size(), 2U);
    EXPECT_EQ(mipmap[1].cells, std::vector<glm::vec4>{glm::vec4(3)});
}

// n + 1 levels, a third more texels, each the mean of the block that it covers.
TEST(Mipmap, levels_are_means_of_the_texture)
{
    constexpr std::uint64_t seed = 20321;
    Random random(seed);
    for (int n = 0; n <= 7; ++n) {
        const int size = 1 << n;
        const Grid<glm::vec4> texture = random_texture(random, size, size);
        const Mipmap mipmap = build_mipmap(texture);
        ASSERT_EQ(mipmap.size(), static_cast<std::size_t>(n) + 1);
        EXPECT_EQ(mipmap[0].cells, texture.cells);
        std::size_t texels = 0;
        for (int level = 0; level <= n; ++level) {
            const Grid<glm::vec4>& grid = mipmap[static_cast<std::size_t>(level)];
            ASSERT_EQ(grid.width, size >> level);
            ASSERT_EQ(grid.height, size >> level);
            texels += grid.cells.size();
            const int block = 1 << level;
            for (int i = 0; i < grid.width * grid.height; i += 7) {
                glm::dvec4 sum(0);
                for (int y = 0; y < block; ++y)
                    for (int x = 0; x < block; ++x)
                        sum += texture.at(i % grid.width * block + x, i / grid.width * block + y);
                expect_near(grid.cells[static_cast<std::size_t>(i)], sum / (1.0 * block * block), 5e-7F);
            }
        }
        EXPECT_EQ(texels, (4 * texture.cells.size() - 1) / 3);
    }
}

TEST(Mipmap, sizes_that_cannot_be_halved_are_refused)
{
    for (const glm::ivec2 size : {glm::ivec2(0, 0), {3, 3}, {4, 2}, {2, 4}, {12, 12}})
        EXPECT_THROW((void)build_mipmap(Grid<glm::vec4>(size.x, size.y)), std::invalid_argument);
}

// A level is left where a texel has become half a pixel: turning the step, or the pixel's axes, changes nothing.
TEST(Mipmap, steps_count_by_their_length)
{
    constexpr std::uint64_t seed = 20322;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const float length = std::exp2(random.uniform(-2, 8));
        const float angle = random.uniform(0, 6.28F);
        const glm::vec2 step = length / 32 * glm::vec2(std::cos(angle), std::sin(angle));
        const glm::vec2 other = step * random.uniform();
        const double expected = std::max(0.0, std::log2(double{length}));
        ASSERT_NEAR(level_of_step(step, other, {32, 32}), expected, 2e-6) << "seed " << seed;
        ASSERT_EQ(level_of_step(other, step, {32, 32}), level_of_step(step, other, {32, 32})) << "seed " << seed;
    }
}

// On whole levels it is a lookup, between them it is linear in the level, at the ends it stays.
TEST(Mipmap, trilinear_lies_between_lookups)
{
    constexpr std::uint64_t seed = 20323;
    constexpr Sampler blended{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    Random random(seed);
    const Mipmap mipmap = build_mipmap(random_texture(random, 16, 16));
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 uv(random.uniform(-2, 2), random.uniform(-2, 2));
        for (std::size_t level = 0; level < mipmap.size(); ++level)
            EXPECT_EQ(trilinear(mipmap, uv, static_cast<float>(level)), lookup(mipmap[level], blended, uv));
        const float level = random.uniform(0, 3);
        const float down = std::floor(level);
        expect_near(trilinear(mipmap, uv, level),
                    mix(trilinear(mipmap, uv, down), trilinear(mipmap, uv, down + 1), level - down), 3e-7F);
        EXPECT_EQ(trilinear(mipmap, uv, -1.5F), trilinear(mipmap, uv, 0));
        EXPECT_EQ(trilinear(mipmap, uv, 77), trilinear(mipmap, uv, 4));
    }
}
