#include <gtest/gtest.h>

#include <pipeline/clip-polygon/shapes.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using Clip = Polygon(const Polygon&, const Polygon&);

namespace {

double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

double signed_area(const Polygon& polygon)
{
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += 0.5 * cross({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
    return area;
}

bool inside(const Polygon& polygon, glm::dvec2 p)
{
    bool in = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i]);
        const glm::dvec2 b(polygon[(i + 1) % polygon.size()]);
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
    }
    return in;
}

class ClipPolygonSolution : public testing::TestWithParam<bool> {
protected:
    Clip* const clip = GetParam() ? &clip_polygon : tests::solution<Clip>(ORACLE_MODULE);
};
INSTANTIATE_TEST_SUITE_P(Solutions, ClipPolygonSolution, testing::Values(true, false),
                         [](const auto& solution) { return solution.param ? "reference" : "oracle"; });

}

// A point is in what is left if it is in both; corners lie in the window; and the orientation stays.
TEST_P(ClipPolygonSolution, is_the_intersection)
{
    constexpr std::uint64_t seed = 20301;
    Random random(seed);
    std::size_t in_both = 0;
    for (int i = 0; i < 6'000; ++i) {
        const Polygon polygon = random_polygon(random, 3 + random.below(12), i % 3 == 0 ? 0.0F : 1.0F);
        const Polygon window = random_window(random, 3 + random.below(6));
        const Polygon left = clip(polygon, window);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 p(2 * random.uniform_double() - 1, 2 * random.uniform_double() - 1);
            const bool both = inside(polygon, p) && inside(window, p);
            in_both += both ? 1 : 0;
            ASSERT_EQ(inside(left, p), both) << "seed " << seed << ", polygon " << i;
        }
        for (const glm::vec2& corner : left)
            for (std::size_t k = 0; k < window.size(); ++k)
                ASSERT_GT(cross(window[k], window[(k + 1) % window.size()], corner), -1e-6) << "seed " << seed;
        if (std::abs(signed_area(left)) > 1e-6) {
            ASSERT_GT(signed_area(left) * signed_area(polygon), 0) << "seed " << seed << ", polygon " << i;
        }
    }
    EXPECT_GT(in_both, 10'000U);
}

// Two windows that share a side divide what one window holds.
TEST_P(ClipPolygonSolution, two_windows_share_the_area)
{
    constexpr std::uint64_t seed = 20302;
    Random random(seed);
    for (int i = 0; i < 3'000; ++i) {
        const Polygon polygon = random_polygon(random, 3 + random.below(12), 1);
        const float split = random.uniform(-0.5F, 0.5F);
        const Polygon whole = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        const Polygon left = {{-1, -1}, {split, -1}, {split, 1}, {-1, 1}};
        const Polygon right = {{split, -1}, {1, -1}, {1, 1}, {split, 1}};
        ASSERT_NEAR(signed_area(clip(polygon, left)) + signed_area(clip(polygon, right)),
                    signed_area(clip(polygon, whole)), 2e-6)
            << "seed " << seed;
    }
}

TEST_P(ClipPolygonSolution, nothing_comes_of_nothing)
{
    const Polygon square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Polygon& polygon :
         {Polygon{}, Polygon{{1, 1}}, Polygon{{1, 1}, {2, 2}}, Polygon{{8, 4}, {11, 6}, {12, 1}},
          Polygon{{8, 2}, {8, 6}, {12, 3}}, Polygon{{1, 1}, {nan, 2}, {4, 4}}})
        EXPECT_TRUE(clip(polygon, square).empty());
    EXPECT_TRUE(clip(square, {}).empty());
    EXPECT_EQ(clip(square, square).size(), 4U);
}

// The header's guarantee.
TEST(ClipPolygonAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20303;
    Random random(seed);
    Clip* const oracle = tests::solution<Clip>(ORACLE_MODULE);
    double worst = 0;
    for (int i = 0; i < 30'000; ++i) {
        Polygon polygon = random_polygon(random, 3 + random.below(8), i % 2 == 0 ? 0.0F : 1.0F);
        const float size = std::exp2(19 * random.uniform());
        for (glm::vec2& corner : polygon) corner *= size;
        const Polygon window = random_window(random, 3 + random.below(6));
        const Polygon got = clip_polygon(polygon, window);
        const Polygon exact = oracle(polygon, window);
        ASSERT_EQ(got.size(), exact.size()) << "seed " << seed << ", polygon " << i;
        // The oracle begins elsewhere: each corner has one of its own within reach.
        for (const glm::vec2& corner : got) {
            double nearest = 1;
            for (const glm::vec2& other : exact) nearest = std::min(nearest, double{distance(corner, other)});
            worst = std::max(worst, nearest / 0x1p-23);
        }
    }
    RecordProperty("ulps", std::to_string(worst));
    EXPECT_LE(worst, 1) << "seed " << seed;
}
