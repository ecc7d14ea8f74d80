#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "viewport_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

/// Every test here holds for the reference and for the oracle.
class ViewportSolution : public testing::TestWithParam<const char*> {
protected:
    const ViewportFunctions& solution() const { return *tests::solution_table<ViewportFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, ViewportSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

int below(Random& random, int count) { return static_cast<int>(random.below(static_cast<std::uint32_t>(count))); }

Viewport random_viewport(Random& random)
{
    const int left = below(random, 1000) - 100;
    const int bottom = below(random, 1000) - 100;
    const int width = 1 + below(random, 2000);
    return {left, bottom, width, 1 + below(random, 2000)};
}

}

// Worked by hand.
TEST_P(ViewportSolution, known_answers)
{
    const glm::mat4 matrix = solution().matrix({10, 20, 101, 55});
    EXPECT_EQ(matrix, glm::mat4(50.5F, 0, 0, 0, 0, 27.5F, 0, 0, 0, 0, 0.5F, 0, 60.5F, 47.5F, 0.5F, 1));
    EXPECT_EQ(solution().matrix({0, 0, 2, 2, 1, 0})[2][2], -0.5F);
    EXPECT_EQ(solution().back({10, 20, 101, 55}, {60.5F, 20, 1}), glm::vec3(0, -1, 1));
    EXPECT_EQ(solution().pixel({0, 0, 8, 4}, {0.24F, 0.5F}), glm::ivec2(4, 3));
    EXPECT_EQ(solution().pixel({0, 0, 8, 4}, {0.25F, 0.49F}), glm::ivec2(5, 2));
    EXPECT_EQ(solution().centre({0, 0, 8, 4}, {0, 3}), glm::vec2(-0.875F, 0.75F));
}

// glm::project with identities is the course's matrix, and unProject its inverse.
TEST_P(ViewportSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 30701;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", viewport " + std::to_string(i));
        const Viewport v = random_viewport(random);
        const glm::dvec4 rectangle(v.left, v.bottom, v.width, v.height);
        const glm::dvec3 ndc(random.in_cube());
        const glm::dvec3 window = glm::project(ndc, glm::dmat4(1), glm::dmat4(1), rectangle);
        const glm::dvec3 got(glm::dmat4(solution().matrix(v)) * glm::dvec4(ndc, 1));
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], window[axis], 1e-9);
        const glm::vec3 asked(window);
        const glm::dvec3 back = glm::unProject(glm::dvec3(asked), glm::dmat4(1), glm::dmat4(1), rectangle);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(solution().back(v, asked)[axis], back[axis], 6e-8 * std::max(1.0, std::abs(back[axis])));
        if (HasFailure()) return;
    }
}

TEST_P(ViewportSolution, the_middle_of_a_pixel_lies_in_it)
{
    constexpr std::uint64_t seed = 30702;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const Viewport v = random_viewport(random);
        const int column = v.left + below(random, v.width);
        const glm::ivec2 pixel(column, v.bottom + below(random, v.height));
        const glm::vec2 centre = solution().centre(v, pixel);
        ASSERT_EQ(solution().pixel(v, centre), pixel) << "seed " << seed << ", viewport " << i;
        const glm::dvec2 window(glm::dmat4(solution().matrix(v)) * glm::dvec4(centre, 0, 1));
        ASSERT_NEAR(window.x, pixel.x + 0.5, 1e-4);
        ASSERT_NEAR(window.y, pixel.y + 0.5, 1e-4);
    }
}

// Every border is the first place of one pixel, and the float before it the last one of another.
TEST_P(ViewportSolution, pixels_are_half_open)
{
    const Viewport v{3, 5, 1024, 512};  // whose borders are floats
    for (int border = 0; border < v.width; ++border) {
        const float x = static_cast<float>(2 * border - v.width) / static_cast<float>(v.width);
        EXPECT_EQ(solution().pixel(v, {x, -1}), glm::ivec2(v.left + border, v.bottom));
        if (border > 0 && x != 0) {
            EXPECT_EQ(solution().pixel(v, {std::nextafter(x, -2.0F), -1}), glm::ivec2(v.left + border - 1, v.bottom));
        }
    }
    EXPECT_EQ(solution().pixel(v, {std::nextafter(1.0F, 0.0F), 0}), glm::ivec2(v.left + 1023, v.bottom + 256));
    const float no_number = std::numeric_limits<float>::quiet_NaN();
    for (const float outside : {1.0F, -1.0000001F, 7.0F, -1e30F, INFINITY, no_number}) {
        EXPECT_FALSE(solution().pixel(v, {outside, 0}));
        EXPECT_FALSE(solution().pixel(v, {0, outside}));
    }
}

// The header's guarantee, and how many of the hard cases float gets wrong: the number in the statement.
TEST(ViewportAccuracy, reference_finds_the_right_pixel)
{
    constexpr std::uint64_t seed = 30703;
    const ViewportFunctions& reference = *tests::solution_table<ViewportFunctions>(REFERENCE_MODULE);
    const ViewportFunctions& oracle = *tests::solution_table<ViewportFunctions>(ORACLE_MODULE);
    Random random(seed);
    int wrong_in_float = 0;
    constexpr int places = 100'000;
    for (int i = 0; i < places; ++i) {
        const Viewport v{below(random, 1000), 0, 500 + below(random, 7500), 1};
        auto x = static_cast<float>((2.0 * (1 + below(random, v.width - 1)) - v.width) / v.width);
        x = std::nextafter(x, i % 2 == 0 ? -2.0F : 2.0F);
        if (std::abs(x) < 1e-4F) continue;
        const std::optional<glm::ivec2> exact = oracle.pixel(v, {x, 0});
        ASSERT_EQ(reference.pixel(v, {x, 0}), exact) << "seed " << seed << ", place " << i;
        const int naive = v.left + static_cast<int>(std::floor((x + 1) * static_cast<float>(v.width) / 2));
        wrong_in_float += naive != exact->x ? 1 : 0;
    }
    RecordProperty("wrong_in_float", wrong_in_float);
    EXPECT_NEAR(100.0 * wrong_in_float / places, 26.3, 1);
}
