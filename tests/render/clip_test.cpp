#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "render/clip.hpp"

namespace umbral::render::test {
namespace {

/// Attributes that are a linear function of the clip coordinates, so that every cut can be checked.
ClipVertex vertex(const glm::vec4& clip)
{
    return {clip, {clip.x + clip.y, clip.z - clip.w, clip.w}, {clip.x, clip.y, clip.z}, {clip.x - clip.z, clip.y + 2 * clip.w}};
}

/// Twice the signed area of a polygon on the screen, in double.
double area(const ClipPolygon& polygon)
{
    double sum = 0;
    const auto at = [&](std::size_t i) { return glm::dvec2(polygon.corners[i].clip) / double{polygon.corners[i].clip.w}; };
    for (std::size_t i = 2; i < polygon.size; ++i) {
        const glm::dvec2 a = at(i - 1) - at(0);
        const glm::dvec2 b = at(i) - at(0);
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

unsigned codes(const std::array<ClipVertex, 3>& triangle, const glm::vec2& guard)
{
    return outcode(triangle[0].clip, guard) | outcode(triangle[1].clip, guard) | outcode(triangle[2].clip, guard);
}

TEST(Clip, leaves_what_lies_inside)
{
    const std::array<ClipVertex, 3> triangle = {vertex({0, 0, 0, 1}), vertex({1, 0, 0.5F, 1}), vertex({0, 1, -1, 1})};
    EXPECT_EQ(codes(triangle, {1, 1}), 0U);
    const ClipPolygon polygon = clip_triangle(triangle, 63, {1, 1});
    ASSERT_EQ(polygon.size, 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(polygon.corners[i].clip, triangle[i].clip);
}

TEST(Clip, halves_an_edge_at_the_near_plane)
{
    // z + w goes from -1 to 1 along both edges that leave the first corner.
    const std::array<ClipVertex, 3> triangle = {vertex({0, 0, -2, 1}), vertex({1, 0, 0, 1}), vertex({0, 1, 0, 1})};
    EXPECT_EQ(outcode(triangle[0].clip, {1, 1}), 1U << 4U);
    const ClipPolygon polygon = clip_triangle(triangle, codes(triangle, {1, 1}), {1, 1});
    ASSERT_EQ(polygon.size, 4U);
    EXPECT_EQ(polygon.corners[0].clip, glm::vec4(0.5F, 0, -1, 1));
    EXPECT_EQ(polygon.corners[3].clip, glm::vec4(0, 0.5F, -1, 1));
}

TEST(Clip, names_each_plane)
{
    const glm::vec2 guard(2, 3);
    EXPECT_EQ(outcode({-2.5F, 0, 0, 1}, guard), 1U);
    EXPECT_EQ(outcode({2.5F, 0, 0, 1}, guard), 2U);
    EXPECT_EQ(outcode({0, -3.5F, 0, 1}, guard), 4U);
    EXPECT_EQ(outcode({0, 3.5F, 0, 1}, guard), 8U);
    EXPECT_EQ(outcode({0, 0, -1.5F, 1}, guard), 16U);
    EXPECT_EQ(outcode({0, 0, 1.5F, 1}, guard), 32U);
    EXPECT_EQ(outcode({2, 3, 1, 1}, guard), 0U) << "on a plane is inside";
    EXPECT_NE(outcode({0, 0, 0, -1}, guard), 0U) << "behind the camera";
}

TEST(Clip, gives_polygons_inside_that_interpolate_linearly_and_keep_their_side)
{
    constexpr std::uint64_t seed = 20240611;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const auto any = [&] {
        const glm::vec3 place = 3.0F * random.in_cube();
        return vertex({place, random.uniform(-1, 3)});
    };
    int cut = 0;
    int empty = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<ClipVertex, 3> triangle = {any(), any(), any()};
        const glm::vec2 guard(random.uniform(1, 2), random.uniform(1, 2));
        const ClipPolygon polygon = clip_triangle(triangle, codes(triangle, guard), guard);
        ASSERT_TRUE(polygon.size == 0 || (polygon.size >= 3 && polygon.size <= 9));
        cut += polygon.size > 3 ? 1 : 0;
        empty += polygon.size == 0 ? 1 : 0;
        for (std::size_t j = 0; j < polygon.size; ++j) {
            const ClipVertex& corner = polygon.corners[j];
            const glm::vec4& c = corner.clip;
            // Each cut rounds once relative to corners of size 5.
            const float slack = 4e-6F;
            ASSERT_GE(c.w, -slack);
            ASSERT_LE(std::abs(c.x), guard.x * c.w + slack);
            ASSERT_LE(std::abs(c.y), guard.y * c.w + slack);
            ASSERT_LE(std::abs(c.z), c.w + slack);
            const ClipVertex expected = vertex(c);
            ASSERT_LT(distance(corner.eye, expected.eye) + distance(corner.normal, expected.normal) + distance(corner.uv, expected.uv), 3e-5F);
        }
        const bool all_in_front = triangle[0].clip.w > 0.1F && triangle[1].clip.w > 0.1F && triangle[2].clip.w > 0.1F;
        if (!all_in_front || polygon.size == 0) continue;
        ClipPolygon whole;
        for (const ClipVertex& corner : triangle) whole.add(corner);
        const double before = area(whole);
        const double after = area(polygon);
        ASSERT_LE(std::abs(after), std::abs(before) + 1e-3);
        if (std::abs(after) > 1e-3) {
            ASSERT_EQ(after > 0, before > 0);
        }
    }
    EXPECT_GT(cut, 2000);
    EXPECT_GT(empty, 1000);
}

TEST(Clip, makes_the_same_vertex_of_an_edge_from_both_its_ends)
{
    const ClipVertex a = vertex({0.1F, 0.2F, -3.1F, 0.7F});
    const ClipVertex b = vertex({0.5F, -0.3F, 0.4F, 1.9F});
    const ClipPolygon left = clip_triangle({a, b, vertex({2, 0.3F, 0.1F, 2.5F})}, 16, {2, 2});
    const ClipPolygon right = clip_triangle({b, a, vertex({-2, 0.2F, 0.3F, 2.2F})}, 16, {2, 2});
    int shared = 0;
    for (std::size_t i = 0; i < left.size; ++i)
        for (std::size_t j = 0; j < right.size; ++j)
            if (left.corners[i].clip == right.corners[j].clip && left.corners[i].clip != b.clip) ++shared;
    EXPECT_EQ(shared, 1);
}

TEST(Clip, survives_numbers_that_are_none)
{
    const float nan = std::nanf("");
    const float inf = INFINITY;
    for (const glm::vec4& odd : {glm::vec4(nan), glm::vec4(inf), glm::vec4(-inf, inf, nan, 0), glm::vec4(0), glm::vec4(3e38F)}) {
        const std::array<ClipVertex, 3> triangle = {vertex(odd), vertex({0, 0, -2, 1}), vertex({1, 0, 0, 1})};
        EXPECT_LE(clip_triangle(triangle, 63, {1, 1}).size, 12U);
    }
}

}
}
