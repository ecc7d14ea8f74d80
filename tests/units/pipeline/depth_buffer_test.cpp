#include <gtest/gtest.h>

#include <umbral/core/random.hpp>
#include <umbral/pipeline/depth.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using StoredDepth = float(DepthFormat, float);

namespace {

Fragment fragment(int x, float depth) { return {{x, 0}, depth, {1, 0, 0}}; }

std::vector<float> depths_left(const DepthState& state, std::vector<Fragment> fragments, Grid<float>& depths)
{
    test_depth(state, fragments, depths);
    std::vector<float> left;
    for (const Fragment& one : fragments) left.push_back(one.depth);
    return left;
}

}

TEST(DepthBuffer, functions_say_what_their_names_say)
{
    const std::array<std::array<bool, 3>, 8> table = {{{false, false, false},
                                                       {true, false, false},
                                                       {false, true, false},
                                                       {true, true, false},
                                                       {false, false, true},
                                                       {true, false, true},
                                                       {false, true, true},
                                                       {true, true, true}}};
    for (std::size_t i = 0; i < 8; ++i) {
        const auto function = static_cast<DepthFunction>(i);
        EXPECT_EQ((std::array{depth_passes(function, 0.25F, 0.5F), depth_passes(function, 0.5F, 0.5F),
                              depth_passes(function, 0.75F, 0.5F)}),
                  table[i])
            << i;
    }
}

// All codes of both formats: each is kept as it is, is less than the next, and is what the oracle makes of it.
TEST(DepthBuffer, codes_are_kept)
{
    auto* const oracle = tests::solution<StoredDepth>(ORACLE_MODULE);
    for (const auto& [format, last] : {std::pair(DepthFormat::unorm16, 65535U), {DepthFormat::unorm24, 16777215U}}) {
        float below = -1;
        for (std::uint32_t code = 0; code <= last; ++code) {
            const float depth = static_cast<float>(code / static_cast<double>(last));
            ASSERT_EQ(stored_depth(format, depth), depth) << code;
            ASSERT_GT(depth, below) << code;
            if (code % 64 == 0) {
                ASSERT_EQ(oracle(format, depth), depth) << code;
            }
            below = depth;
        }
    }
}

TEST(DepthBuffer, rounds_as_the_oracle_does)
{
    constexpr std::uint64_t seed = 20281;
    Random random(seed);
    auto* const oracle = tests::solution<StoredDepth>(ORACLE_MODULE);
    for (int i = 0; i < 1'000'000; ++i) {
        const float depth = std::exp2(-30 * random.uniform() * random.uniform());
        for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32})
            ASSERT_EQ(stored_depth(format, depth), oracle(format, depth)) << "seed " << seed << ", depth " << depth;
    }
    EXPECT_EQ(stored_depth(DepthFormat::unorm16, 0.5F), 32768 / 65535.0F);
    EXPECT_EQ(stored_depth(DepthFormat::float32, -1), 0.0F);
    EXPECT_EQ(stored_depth(DepthFormat::unorm24, 2), 1.0F);
}

TEST(DepthBuffer, each_fragment_meets_what_those_before_it_left)
{
    Grid<float> depths(2, 1, 0.5F);
    EXPECT_EQ(depths_left(
                  {}, {fragment(0, 0.4F), fragment(1, 0.6F), fragment(0, 0.45F), fragment(0, 0.3F), fragment(0, 0.3F)},
                  depths),
              (std::vector{0.4F, 0.3F}));
    EXPECT_EQ(depths.cells, (std::vector{0.3F, 0.5F}));
}

TEST(DepthBuffer, state_decides_what_is_stored)
{
    Grid<float> depths(1, 1, 0.5F);
    EXPECT_EQ(depths_left({true, DepthFunction::less, false}, {fragment(0, 0.4F), fragment(0, 0.45F)}, depths).size(),
              2U);
    EXPECT_EQ(depths_left({false, DepthFunction::never}, {fragment(0, 0.4F), fragment(0, 0.9F)}, depths).size(), 2U);
    EXPECT_EQ(depths.cells[0], 0.5F);
    EXPECT_EQ(depths_left({true, DepthFunction::always}, {fragment(0, 0.9F)}, depths).size(), 1U);
    EXPECT_EQ(depths.cells[0], 0.9F);
}

// Two surfaces less than half a code apart are one: the first wins with "less", the last with "less or equal".
TEST(DepthBuffer, rounds_before_it_compares)
{
    const float near = 1000.2F / 65535;
    const float farther = 1000.3F / 65535;
    for (const auto& [function, count] : {std::pair(DepthFunction::less, 1U), {DepthFunction::less_equal, 2U}}) {
        Grid<float> depths(1, 1, 1.0F);
        EXPECT_EQ(
            depths_left({true, function, true, DepthFormat::unorm16}, {fragment(0, farther), fragment(0, near)}, depths)
                .size(),
            count);
    }
}

TEST(DepthBuffer, layers_of_other_sizes_are_refused)
{
    const Layer source{{2, 3}, {2, 3, 1.0F}};
    Layer target{{3, 2}, {3, 2, 1.0F}};
    EXPECT_THROW(merge_layers({}, source, target), std::invalid_argument);
}
