#include <gtest/gtest.h>

#include <umbral/core/random.hpp>
#include <umbral/pipeline/clip_line.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using Clip = std::optional<LineSegment>(const ClipWindow&, const LineSegment&);

namespace {

constexpr ClipWindow unit{{-1, -1}, {1, 1}};

bool inside(const ClipWindow& window, const glm::vec2& p)
{
    return glm::all(glm::lessThanEqual(window.low, p)) && glm::all(glm::lessThanEqual(p, window.high));
}

bool on_border(const ClipWindow& window, const glm::vec2& p)
{
    return p.x == window.low.x || p.x == window.high.x || p.y == window.low.y || p.y == window.high.y;
}

// Small whole numbers, so that touching happens.
glm::vec2 on_lattice(Random& random, int reach)
{
    const auto coordinate = [&] {
        return static_cast<float>(random.below(static_cast<std::uint32_t>(2 * reach + 1))) - static_cast<float>(reach);
    };
    const float x = coordinate();
    return {x, coordinate()};
}

// Exact: the window is convex, so a segment meets it if it meets both of its intervals and has corners on both sides,
// or on it.
bool meets(const ClipWindow& window, const LineSegment& s)
{
    for (int axis = 0; axis < 2; ++axis)
        if (std::max(s.from[axis], s.to[axis]) < window.low[axis] ||
            std::min(s.from[axis], s.to[axis]) > window.high[axis])
            return false;
    bool left = false;
    bool right = false;
    for (const glm::vec2& corner :
         {window.low, glm::vec2(window.low.x, window.high.y), window.high, glm::vec2(window.high.x, window.low.y)}) {
        const glm::dvec2 d = glm::dvec2(s.to) - glm::dvec2(s.from);
        const glm::dvec2 c = glm::dvec2(corner) - glm::dvec2(s.from);
        const double side = d.x * c.y - d.y * c.x;
        left = left || side >= 0;
        right = right || side <= 0;
    }
    return left && right;
}

class ClipLineSolution : public testing::TestWithParam<bool> {
protected:
    Clip* const clip = GetParam() ? &clip_segment : tests::solution<Clip>(ORACLE_MODULE);
};
INSTANTIATE_TEST_SUITE_P(Solutions, ClipLineSolution, testing::Values(true, false),
                         [](const auto& solution) { return solution.param ? "reference" : "oracle"; });

}

TEST(ClipLine, codes_of_the_nine_regions)
{
    EXPECT_EQ(region_code(unit, {-2, 0}), 1U);
    EXPECT_EQ(region_code(unit, {2, 0}), 2U);
    EXPECT_EQ(region_code(unit, {0, -2}), 4U);
    EXPECT_EQ(region_code(unit, {0, 2}), 8U);
    EXPECT_EQ(region_code(unit, {2, 2}), 10U);
    EXPECT_EQ(region_code(unit, {1, -1}), 0U);
}

// On a lattice every decision can be made exactly.
TEST_P(ClipLineSolution, lattice_segments)
{
    constexpr std::uint64_t seed = 20291;
    Random random(seed);
    std::size_t hits = 0;
    for (int i = 0; i < 200'000; ++i) {
        const glm::vec2 a = on_lattice(random, 4);
        const glm::vec2 b = on_lattice(random, 4);
        const ClipWindow window{glm::min(a, b), glm::max(a, b)};
        const glm::vec2 from = on_lattice(random, 9);
        const LineSegment segment{from, on_lattice(random, 9)};
        const std::optional<LineSegment> left = clip(window, segment);
        ASSERT_EQ(left.has_value(), meets(window, segment)) << "seed " << seed << ", segment " << i;
        if (!left) continue;
        ++hits;
        for (const auto& [end, original] : {std::pair(left->from, segment.from), {left->to, segment.to}}) {
            ASSERT_TRUE(inside(window, end)) << "seed " << seed << ", segment " << i;
            ASSERT_TRUE(inside(window, original) ? end == original : on_border(window, end))
                << "seed " << seed << ", segment " << i;
        }
        ASSERT_GE(dot(left->to - left->from, segment.to - segment.from), 0)
            << "the direction stays; seed " << seed << ", segment " << i;
        const std::optional<LineSegment> back = clip(window, {segment.to, segment.from});
        ASSERT_TRUE(back && back->from == left->to && back->to == left->from) << "seed " << seed << ", segment " << i;
    }
    EXPECT_GT(hits, 30'000U);
}

TEST_P(ClipLineSolution, nonsense_gives_nothing)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        for (const LineSegment& segment :
             {LineSegment{{bad, 0}, {0, 0}}, {{0, bad}, {0, 0}}, {{0, 0}, {bad, 0}}, {{0, 0}, {-bad, -bad}}})
            EXPECT_EQ(clip(unit, segment).has_value(), false);
}

// The header's guarantee: from ends a million windows away, for windows anywhere.
TEST(ClipLineAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20292;
    Random random(seed);
    Clip* const oracle = tests::solution<Clip>(ORACLE_MODULE);
    double worst = 0;
    std::size_t hits = 0;
    for (int i = 0; i < 300'000; ++i) {
        const glm::vec2 middle = std::exp2(10 * random.uniform()) * glm::vec2(random.in_cube());
        const ClipWindow window{middle - random.uniform(0.1F, 1), middle + random.uniform(0.1F, 1)};
        const float largest = std::max(length(window.low), length(window.high));
        const glm::vec2 through = middle + 1.5F * glm::vec2(random.in_cube());
        const glm::vec2 along(random.in_cube());
        const float reach = largest * std::exp2(19 * random.uniform());
        const LineSegment segment{through - reach * random.uniform() * along,
                                  through + reach * random.uniform() * along};
        const std::optional<LineSegment> got = clip_segment(window, segment);
        const std::optional<LineSegment> exact = oracle(window, segment);
        ASSERT_EQ(got.has_value(), exact.has_value()) << "seed " << seed << ", segment " << i;
        if (!got) continue;
        ++hits;
        const double ulp = std::ldexp(1.0, std::ilogb(std::max({std::abs(window.low.x), std::abs(window.low.y),
                                                                std::abs(window.high.x), std::abs(window.high.y)})) -
                                               23);
        worst =
            std::max({worst, double{length(got->from - exact->from)} / ulp, double{length(got->to - exact->to)} / ulp});
    }
    RecordProperty("ulps", std::to_string(worst));
    EXPECT_LE(worst, 1) << "seed " << seed;
    EXPECT_GT(hits, 100'000U);
}
