#include <gtest/gtest.h>

#include <umbral/core/random.hpp>
#include <umbral/pipeline/clip.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using Clip = void(const std::array<glm::vec4, 3>&, std::vector<ClipVertex>&);
using Triangle = std::array<glm::vec4, 3>;

namespace {

std::vector<ClipVertex> polygon_of(Clip* clip, const Triangle& triangle)
{
    std::vector<ClipVertex> polygon;
    clip(triangle, polygon);
    return polygon;
}

// Corners before, beside and behind the camera; sides up to `ratio` times as long as others.
Triangle random_triangle(Random& random, float ratio)
{
    Triangle triangle{};
    for (glm::vec4& corner : triangle) {
        const float size = std::pow(ratio, random.uniform());
        const glm::vec3 place = size * 1.5F * random.in_cube();
        corner = glm::vec4(place, size * random.uniform(-0.7F, 1));
    }
    return triangle;
}

// How far a point of the triangle lies inside the view volume, relative to its corners.
double inside_volume(const Triangle& triangle, const glm::dvec3& weights)
{
    const glm::dvec4 p =
        weights.x * glm::dvec4(triangle[0]) + weights.y * glm::dvec4(triangle[1]) + weights.z * glm::dvec4(triangle[2]);
    double size = 0;
    for (int k = 0; k < 3; ++k)
        size = std::max(size, weights[k] * double{length(triangle[static_cast<std::size_t>(k)])});
    return (p.w - std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})) / size;
}

// The same, of the polygon in the plane of the weights: positive inside if it turns as the triangle does.
double inside_polygon(const std::vector<ClipVertex>& polygon, const glm::dvec3& weights)
{
    double least = polygon.empty() ? -1 : 1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i].weights);
        const glm::dvec2 b(polygon[(i + 1) % polygon.size()].weights);
        const glm::dvec2 p(weights);
        least = std::min(least, (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
    }
    return least;
}

class ClipSolution : public testing::TestWithParam<bool> {
protected:
    Clip* const clip = GetParam() ? &clip_triangle : tests::solution<Clip>(ORACLE_MODULE);
};
INSTANTIATE_TEST_SUITE_P(Solutions, ClipSolution, testing::Values(true, false),
                         [](const auto& solution) { return solution.param ? "reference" : "oracle"; });

}

// The polygon holds exactly those points of the triangle that lie in the volume, and turns as the triangle does.
TEST_P(ClipSolution, keeps_what_is_inside)
{
    constexpr std::uint64_t seed = 20271;
    Random random(seed);
    std::size_t inside = 0;
    std::size_t outside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Triangle triangle = random_triangle(random, 4);
        const std::vector<ClipVertex> polygon = polygon_of(clip, triangle);
        for (int k = 0; k < 8; ++k) {
            const double u = random.uniform_double();
            const double v = random.uniform_double();
            const glm::dvec3 weights = u + v < 1 ? glm::dvec3(u, v, 1 - u - v) : glm::dvec3(1 - u, 1 - v, u + v - 1);
            const double margin = inside_volume(triangle, weights);
            if (std::abs(margin) < 1e-4) continue;
            const double in_polygon = inside_polygon(polygon, weights);
            ASSERT_TRUE(margin > 0 ? in_polygon > -1e-6 : in_polygon < 1e-6) << "seed " << seed << ", triangle " << i;
            (margin > 0 ? inside : outside) += 1;
        }
    }
    EXPECT_GT(inside, 10'000U);
    EXPECT_GT(outside, 50'000U);
}

TEST_P(ClipSolution, corners_lie_in_the_volume_exactly)
{
    constexpr std::uint64_t seed = 20272;
    Random random(seed);
    std::size_t most = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Triangle triangle = random_triangle(random, i % 2 == 0 ? 2.0F : 1e6F);
        const std::vector<ClipVertex> polygon = polygon_of(clip, triangle);
        most = std::max(most, polygon.size());
        ASSERT_TRUE(polygon.empty() || (polygon.size() >= 3 && polygon.size() <= 9))
            << polygon.size() << " corners; seed " << seed << ", triangle " << i;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const auto& [p, weights] = polygon[k];
            ASSERT_EQ(outside_planes(p), 0U) << "seed " << seed << ", triangle " << i;
            ASSERT_NE(p, polygon[(k + 1) % polygon.size()].position) << "seed " << seed << ", triangle " << i;
            ASSERT_NEAR(double{weights.x} + double{weights.y} + double{weights.z}, 1, 2e-7);
            const bool corner = std::max({weights.x, weights.y, weights.z}) == 1;
            const float farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            ASSERT_TRUE(corner || farthest == p.w) << "a new corner lies on a plane; seed " << seed;
        }
    }
    EXPECT_GE(most, 8U);
}

TEST_P(ClipSolution, nine_corners_at_most)
{
    const Triangle triangle = {
        glm::vec4(-1.875F, 1.8125F, 0.0625F, 1), {0, -1.875F, 1.8125F, 1}, {1.8125F, 0.03125F, -1.875F, 1}};
    EXPECT_EQ(polygon_of(clip, triangle).size(), 9U);
}

// Two triangles at one side, begun at any corner and turned either way: what lies on the side has the same bits.
TEST_P(ClipSolution, no_cracks)
{
    constexpr std::uint64_t seed = 20273;
    Random random(seed);
    std::size_t crossings = 0;
    for (int i = 0; i < 15'000; ++i) {
        const Triangle triangle = random_triangle(random, i % 2 == 0 ? 2.0F : 1e6F);
        const Triangle other = random_triangle(random, 2);
        const auto on_side = [&](const Triangle& t, int opposite) {
            std::vector<std::array<float, 4>> points;
            for (const auto& [p, weights] : polygon_of(clip, t))
                if (weights[opposite] == 0) points.push_back({p.x, p.y, p.z, p.w});
            std::sort(points.begin(), points.end());
            return points;
        };
        const auto here = on_side(triangle, 2);
        ASSERT_EQ(here, on_side({triangle[1], triangle[0], triangle[2]}, 2)) << "seed " << seed << ", triangle " << i;
        const auto there = on_side({other[0], triangle[1], triangle[0]}, 0);
        if (here.size() != 2 || there.size() != 2) continue;  // the side may lie in a corner that rounding empties
        ASSERT_EQ(here, there) << "seed " << seed << ", triangle " << i;
        ++crossings;
    }
    EXPECT_GT(crossings, 1'000U);
}

// What the header promises to those who clip at a guard band.
TEST_P(ClipSolution, guard_band_by_scaling)
{
    const Triangle far_away = {glm::vec4(-3, 0, 0, 1), {7, -6, 0, 1}, {0, 7.5F, 0.5F, 1}};
    Triangle scaled = far_away;
    for (glm::vec4& corner : scaled) corner = {corner.x / 8, corner.y / 8, corner.z, corner.w};
    const std::vector<ClipVertex> polygon = polygon_of(clip, scaled);
    ASSERT_EQ(polygon.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(polygon[i].position * glm::vec4(8, 8, 1, 1), far_away[i]);
}

// The header's guarantee.
TEST(ClipAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20274;
    Random random(seed);
    Clip* const oracle = tests::solution<Clip>(ORACLE_MODULE);
    double worst_position = 0;
    double worst_weight = 0;
    for (int i = 0; i < 30'000; ++i) {
        const Triangle triangle = random_triangle(random, i % 3 == 0 ? 2.0F : i % 3 == 1 ? 1e3F : 1e6F);
        const std::vector<ClipVertex> got = polygon_of(&clip_triangle, triangle);
        const std::vector<ClipVertex> exact = polygon_of(oracle, triangle);
        ASSERT_EQ(got.size(), exact.size()) << "seed " << seed << ", triangle " << i;
        for (std::size_t k = 0; k < got.size(); ++k) {
            const glm::dvec4 off = glm::dvec4(got[k].position) - glm::dvec4(exact[k].position);
            const double ulp = std::ldexp(1.0, std::ilogb(exact[k].position.w) - 23);
            for (int c = 0; c < 4; ++c) worst_position = std::max(worst_position, std::abs(off[c]) / ulp);
            for (int c = 0; c < 3; ++c)
                worst_weight =
                    std::max(worst_weight, std::abs(double{got[k].weights[c]} - double{exact[k].weights[c]}) / 0x1p-24);
        }
    }
    RecordProperty("ulps", std::to_string(worst_position) + " " + std::to_string(worst_weight));
    EXPECT_LE(worst_position, 2) << "seed " << seed;
    EXPECT_LE(worst_weight, 2) << "seed " << seed;
}
