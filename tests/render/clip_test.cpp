#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "render/clip.hpp"
#include "render/visibility.hpp"

// What the engine adds to the unit pipeline/clip-homogeneous: a guard band, and attributes.
namespace umbral::render::test {
namespace {

/// Attributes that are a linear function of the clip coordinates, so that every cut can be checked.
ClipVertex vertex(const glm::vec4& clip)
{
    return {clip,
            {clip.x + clip.y, clip.z - clip.w, clip.w},
            {clip.x, clip.y, clip.z},
            {clip.x - clip.z, clip.y + 2 * clip.w}};
}

std::vector<ClipVertex> clipped(const std::array<ClipVertex, 3>& triangle, const glm::vec2& guard)
{
    std::vector<pipeline::ClipVertex> corners;
    std::vector<ClipVertex> polygon;
    clip_triangle(triangle, guard, corners, polygon);
    return polygon;
}

TEST(Clip, leaves_what_lies_inside_the_guard_band_bit_by_bit)
{
    const std::array<ClipVertex, 3> triangle = {vertex({-30.7F, 0, 0, 1}), vertex({1, 15.9F, 0.5F, 1}),
                                                vertex({0.3F, 1, -1, 1})};
    const std::vector<ClipVertex> polygon = clipped(triangle, {32, 16});
    ASSERT_EQ(polygon.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(outcode(triangle[i].clip, {32, 16}), 0U);
        EXPECT_EQ(polygon[i].clip, triangle[i].clip);
        EXPECT_EQ(polygon[i].uv, triangle[i].uv);
    }
}

TEST(Clip, names_each_plane_of_the_guard_band)
{
    const glm::vec2 guard(2, 4);
    EXPECT_EQ(outcode({-2.5F, 0, 0, 1}, guard), 1U);
    EXPECT_EQ(outcode({2.5F, 0, 0, 1}, guard), 2U);
    EXPECT_EQ(outcode({0, -4.5F, 0, 1}, guard), 4U);
    EXPECT_EQ(outcode({0, 4.5F, 0, 1}, guard), 8U);
    EXPECT_EQ(outcode({0, 0, -1.5F, 1}, guard), 16U);
    EXPECT_EQ(outcode({0, 0, 1.5F, 1}, guard), 32U);
    EXPECT_EQ(outcode({2, 4, 1, 1}, guard), 0U) << "on a plane is inside";
}

TEST(Clip, gives_polygons_inside_that_interpolate_linearly)
{
    constexpr std::uint64_t seed = 20240611;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const auto any = [&] {
        const glm::vec3 place = 3.0F * random.in_cube();
        return vertex({place, random.uniform(-1, 3)});
    };
    int cut = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::array<ClipVertex, 3> triangle = {any(), any(), any()};
        const glm::vec2 guard = glm::exp2(glm::vec2(random.below(3), random.below(3)));
        const std::vector<ClipVertex> polygon = clipped(triangle, guard);
        cut += polygon.size() > 3 ? 1 : 0;
        for (const ClipVertex& corner : polygon) {
            const glm::vec4& c = corner.clip;
            ASSERT_GT(c.w, 0);
            ASSERT_LE(std::abs(c.x), guard.x * c.w);
            ASSERT_LE(std::abs(c.y), guard.y * c.w);
            ASSERT_LE(std::abs(c.z), c.w);
            const ClipVertex expected = vertex(c);
            // Weights are rounded once, relative to corners of size 5.
            ASSERT_LT(distance(corner.eye, expected.eye) + distance(corner.normal, expected.normal) +
                          distance(corner.uv, expected.uv),
                      3e-5F);
        }
    }
    EXPECT_GT(cut, 500);
}

TEST(GuardBand, is_a_power_of_two_within_the_reach_of_the_rasteriser)
{
    for (const int side : {1, 2, 31, 512, 1000, 4096, 8192, 16383, 16384}) {
        const glm::vec2 guard = guard_band(side, side);
        EXPECT_EQ(std::exp2(std::round(std::log2(guard.x))), guard.x) << side;
        EXPECT_GE(guard.x, 1) << side;
        EXPECT_LE((guard.x + 1) * static_cast<float>(side) / 2, 16384) << side;
    }
}

}
}
