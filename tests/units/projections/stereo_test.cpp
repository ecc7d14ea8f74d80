#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "stereo_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class StereoSolution : public testing::TestWithParam<const char*> {
protected:
    const StereoFunctions& solution() const { return *tests::solution_table<StereoFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, StereoSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

StereoScreen random_screen(Random& random)
{
    const float near_plane = random.uniform(0.05F, 3);
    const float width = random.uniform(0.2F, 9);
    const float height = random.uniform(0.2F, 9);
    const float distance = random.uniform(0.2F, 9);
    return {width, height, distance, random.uniform(0.01F, 3), near_plane, near_plane * random.uniform(1.5F, 900)};
}

void expect_near(const glm::mat4& got, const glm::dmat4& expected)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(got[column][row], expected[column][row], 7e-8 * std::abs(expected[column][row]) + 1e-14)
                << "column " << column << ", row " << row;
}

/// The same camera by GLM's functions: its frustum through the borders of a window `distance` before it, the middle of
/// the window `aside` from the axis.
glm::dmat4 glm_frustum(const StereoScreen& s, double distance, double aside)
{
    const double scale = s.near_plane / distance;
    return glm::frustum((aside - s.width / 2.0) * scale, (aside + s.width / 2.0) * scale, -s.height / 2.0 * scale,
                        s.height / 2.0 * scale, double{s.near_plane}, double{s.far_plane});
}

}

TEST_P(StereoSolution, known_answers)
{
    const StereoScreen screen{4, 2, 4, 6, 1, 3};
    const StereoPair off_axis = solution().off_axis(screen);
    EXPECT_EQ(off_axis.left.view[3], glm::vec4(3, 0, 0, 1));
    EXPECT_EQ(off_axis.left.projection[0], glm::vec4(2, 0, 0, 0));
    EXPECT_EQ(off_axis.left.projection[2], glm::vec4(1.5F, 0, -2, -1));
    EXPECT_EQ(off_axis.right.projection[2], glm::vec4(-1.5F, 0, -2, -1));
    EXPECT_EQ(off_axis.right.projection[3], glm::vec4(0, 0, -3, 0));
    const StereoPair toe_in = solution().toe_in(screen);
    EXPECT_EQ(toe_in.left.view[0], glm::vec4(0.8F, 0, -0.6F, 0));
    EXPECT_EQ(toe_in.left.view[2], glm::vec4(0.6F, 0, 0.8F, 0));
    EXPECT_EQ(toe_in.left.projection[0].x, 2.5F);
    EXPECT_EQ(solution().parallax({4, 3, 2, 0.5F, 1, 9}, 4), 0.25F);
    EXPECT_EQ(solution().parallax({4, 3, 2, 0.5F, 1, 9}, infinity), 0.5F);
    EXPECT_EQ(solution().distance({4, 3, 2, 0.5F, 1, 9}, 0.25F), 4.0F);
    EXPECT_EQ(solution().distance({4, 3, 2, 0.5F, 1, 9}, 0.5F), infinity);
    EXPECT_EQ(solution().distance({4, 3, 2, 0.5F, 1, 9}, 0.75F), std::nullopt);
}

TEST_P(StereoSolution, pairs_are_those_of_glm_in_double)
{
    constexpr std::uint64_t seed = 30901;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", screen " + std::to_string(i));
        const StereoScreen s = random_screen(random);
        const StereoPair off_axis = solution().off_axis(s);
        const StereoPair toe_in = solution().toe_in(s);
        const glm::dvec3 up(0, 1, 0);
        for (const double side : {-1.0, 1.0}) {
            const double x = side * s.eye_separation / 2;
            const EyeMatrices& parallel = side < 0 ? off_axis.left : off_axis.right;
            const EyeMatrices& convergent = side < 0 ? toe_in.left : toe_in.right;
            expect_near(parallel.view, glm::lookAt(glm::dvec3(x, 0, 0), glm::dvec3(x, 0, -1), up));
            expect_near(parallel.projection, glm_frustum(s, s.distance, -x));
            expect_near(convergent.view, glm::lookAt(glm::dvec3(x, 0, 0), glm::dvec3(0, 0, -s.distance), up));
            expect_near(convergent.projection, glm_frustum(s, std::hypot(s.distance, x), 0));
        }
        if (HasFailure()) return;
    }
}

// The parallax as the course explains it, the matrices, and the disparity tell the same.
TEST_P(StereoSolution, disparity_of_an_off_axis_pair_is_the_parallax)
{
    constexpr std::uint64_t seed = 30902;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const StereoScreen s = random_screen(random);
        const float depth = s.distance * random.uniform(0.3F, 9);
        const glm::vec3 point(random.uniform(-3, 3), random.uniform(-3, 3), -depth);
        const glm::vec2 seen = solution().disparity(solution().off_axis(s), point).value();
        EXPECT_NEAR(seen.x * s.width / 2, solution().parallax(s, depth),
                    1e-6 * (s.eye_separation + 10) * (1 + s.distance / depth));
        EXPECT_EQ(seen.y, 0) << "no vertical parallax";
        EXPECT_NEAR(solution().distance(s, solution().parallax(s, depth)).value(), depth,
                    1e-5 * depth * (1 + depth / s.distance));
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", screen " << i;
    }
}

// What the statement says: up to 3.1 % of the picture's height, at the corners.
TEST_P(StereoSolution, toe_in_has_vertical_parallax_at_the_corners)
{
    const StereoScreen screen{4, 2, 4, 0.5F, 1, 9};
    const StereoPair pair = solution().toe_in(screen);
    EXPECT_NEAR(solution().disparity(pair, {0, 0, -4}).value().x, 0, 1e-6);
    EXPECT_NEAR(solution().disparity(pair, {0, 1, -4}).value().y, 0, 1e-6);
    const float corner = solution().disparity(pair, {2, 1, -4}).value().y;
    EXPECT_NEAR(50 * std::abs(corner), 3.12, 0.01);
}

TEST_P(StereoSolution, nothing_behind_an_eye)
{
    const StereoPair pair = solution().toe_in({4, 2, 4, 6, 1, 9});
    EXPECT_TRUE(solution().disparity(pair, {0, 0, -1}));
    EXPECT_FALSE(solution().disparity(pair, {20, 0, -1})) << "behind the right eye";
    EXPECT_FALSE(solution().disparity(pair, {-20, 0, -1})) << "behind the left eye";
    EXPECT_FALSE(solution().disparity(pair, {0, 0, 9}));
}

TEST_P(StereoSolution, what_is_no_screen_is_refused)
{
    const StereoScreen good{4, 3, 2, 0.5F, 1, infinity};
    EXPECT_EQ(solution().off_axis(good).left.projection[3].z, -2);
    for (const float wrong : {0.0F, -1.0F, no_number})
        for (float StereoScreen::*const member :
             {&StereoScreen::width, &StereoScreen::height, &StereoScreen::distance, &StereoScreen::eye_separation,
              &StereoScreen::near_plane, &StereoScreen::far_plane}) {
            StereoScreen bad = good;
            bad.*member = wrong;
            EXPECT_THROW((void)solution().off_axis(bad), std::invalid_argument);
            EXPECT_THROW((void)solution().toe_in(bad), std::invalid_argument);
            EXPECT_THROW((void)solution().parallax(good, wrong), std::invalid_argument);
        }
}

// Greys stay as they are in all three kinds; luminances by IEC 61966-2-1 on paper.
TEST_P(StereoSolution, anaglyphs_of_known_pixels)
{
    const auto mix = [&](const glm::u8vec4& left, const glm::u8vec4& right, AnaglyphColors colors) {
        return solution().anaglyph(Image(1, 1, left), Image(1, 1, right), colors).at(0, 0);
    };
    for (int code = 0; code < 256; ++code)
        for (const AnaglyphColors colors : {AnaglyphColors::full, AnaglyphColors::half, AnaglyphColors::gray}) {
            const auto gray = static_cast<std::uint8_t>(code);
            const auto other = static_cast<std::uint8_t>(255 - code);
            EXPECT_EQ(mix({gray, gray, gray, 9}, {other, other, other, 0}, colors),
                      glm::u8vec4(gray, other, other, 255));
        }
    EXPECT_EQ(mix({255, 0, 0, 255}, {0, 0, 255, 255}, AnaglyphColors::full), glm::u8vec4(255, 0, 255, 255));
    EXPECT_EQ(mix({255, 0, 0, 255}, {0, 0, 255, 255}, AnaglyphColors::half), glm::u8vec4(127, 0, 255, 255));
    EXPECT_EQ(mix({0, 255, 0, 255}, {0, 0, 255, 255}, AnaglyphColors::gray), glm::u8vec4(220, 76, 76, 255));
    EXPECT_THROW((void)solution().anaglyph(Image(2, 3), Image(3, 2), AnaglyphColors::full), std::invalid_argument);
}

// The header's guarantee.
TEST(StereoAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30903;
    const StereoFunctions& reference = *tests::solution_table<StereoFunctions>(REFERENCE_MODULE);
    const StereoFunctions& oracle = *tests::solution_table<StereoFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 30'000; ++i) {
        const StereoScreen s = random_screen(random);
        const float aside = random.uniform(-1, 1) * std::pow(10.0F, random.uniform(-6, 0));
        const float depth = s.distance * (1 + 0.99F * aside);
        ASSERT_LE(tests::ulps_between(reference.parallax(s, depth), oracle.parallax(s, depth)), 1)
            << "seed " << seed << ", screen " << i;
        const float parallax = s.eye_separation * (1 - std::abs(aside) - 1e-6F);
        ASSERT_LE(tests::ulps_between(*reference.distance(s, parallax), *oracle.distance(s, parallax)), 1)
            << "seed " << seed << ", screen " << i;
    }
}
