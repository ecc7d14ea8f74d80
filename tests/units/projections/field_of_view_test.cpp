#include "field_of_view_functions.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class FieldOfViewSolution : public testing::TestWithParam<const char*> {
protected:
    const FieldOfView& solution() const { return *tests::solution_table<FieldOfView>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, FieldOfViewSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

Lens random_lens(Random& random)
{
    const float near_plane = std::pow(10.0F, random.uniform(-2, 1));
    return {random.uniform(1, 179), random.uniform(0.4F, 3), near_plane,
            near_plane * std::pow(10.0F, random.uniform(0.2F, 5))};
}

}

// Worked by hand.
TEST_P(FieldOfViewSolution, known_answers)
{
    const glm::mat4 wide(0.5F, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0);
    EXPECT_EQ(solution().matrix({90, 2, 1, 3}), wide);
    const glm::mat4 reversed(0.5F, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5F, -1, 0, 0, 1.5F, 0);
    EXPECT_EQ(solution().reversed({90, 2, 1, 3}), reversed);
    EXPECT_NEAR(solution().matrix({60, 1, 1, 3})[1][1], std::sqrt(3.0), 1e-7);
    EXPECT_NEAR(solution().fovy(90, 2), 53.13010235, 4e-6);
    EXPECT_EQ(solution().fovy(90, 1), 90);
    EXPECT_EQ(solution().fovy(60, 1), 60);
}

TEST_P(FieldOfViewSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 30501;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const Lens lens = random_lens(random);
        const glm::dmat4 forward = glm::perspective<double>(glm::radians(double{lens.fovy_degrees}), lens.aspect,
                                                            lens.near_plane, lens.far_plane);
        const glm::dmat4 reversed = glm::perspectiveRH_ZO<double>(glm::radians(double{lens.fovy_degrees}), lens.aspect,
                                                                  lens.far_plane, lens.near_plane);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                ASSERT_NEAR(solution().matrix(lens)[column][row], forward[column][row],
                            6.1e-8 * std::abs(forward[column][row]))
                    << "seed " << seed << ", lens " << i;
                ASSERT_NEAR(solution().reversed(lens)[column][row], reversed[column][row],
                            6.1e-8 * std::abs(reversed[column][row]))
                    << "seed " << seed << ", lens " << i;
            }
    }
}

TEST_P(FieldOfViewSolution, planes_have_their_depths)
{
    constexpr std::uint64_t seed = 30502;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const Lens lens = random_lens(random);
        const auto depth = [&](const glm::mat4& matrix, float distance) {
            const glm::dvec4 clip = glm::dmat4(matrix) * glm::dvec4(0, 0, -distance, 1);
            // Entries are rounded by 6e-8 of themselves, and so are the terms of the sum.
            const double size = std::abs(double{matrix[2][2]}) + std::abs(double{matrix[3][2]}) / distance;
            return std::pair(clip.z / clip.w, 6e-8 * size);
        };
        const auto expect_depth = [](const std::pair<double, double>& got, double expected) {
            EXPECT_NEAR(got.first, expected, got.second);
        };
        expect_depth(depth(solution().matrix(lens), lens.near_plane), -1);
        expect_depth(depth(solution().matrix(lens), lens.far_plane), 1);
        expect_depth(depth(solution().reversed(lens), lens.near_plane), 1);
        expect_depth(depth(solution().reversed(lens), lens.far_plane), 0);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", lens " << i;
    }
}

TEST_P(FieldOfViewSolution, infinity_is_the_limit)
{
    EXPECT_EQ(solution().matrix({90, 1, 0.5F, infinity})[2], glm::vec4(0, 0, -1, -1));
    EXPECT_EQ(solution().matrix({90, 1, 0.5F, infinity})[3], glm::vec4(0, 0, -1, 0));
    EXPECT_EQ(solution().reversed({90, 1, 0.5F, infinity})[2], glm::vec4(0, 0, 0, -1));
    EXPECT_EQ(solution().reversed({90, 1, 0.5F, infinity})[3], glm::vec4(0, 0, 0.5F, 0));
}

// A picture that is turned on its side has its angles exchanged.
TEST_P(FieldOfViewSolution, angles_lead_back)
{
    constexpr std::uint64_t seed = 30503;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const float fovx = random.uniform(1, 170);
        const float aspect = std::exp2(static_cast<float>(random.below(5)) - 2);
        const float fovy = solution().fovy(fovx, aspect);
        // An angle rounded by 6e-8 moves the other by its derivative, at most 4 times as much.
        EXPECT_NEAR(solution().fovy(fovy, 1 / aspect), fovx, 1e-4) << "seed " << seed << ", angle " << i;
    }
}

TEST_P(FieldOfViewSolution, what_is_no_lens_is_refused)
{
    for (const Lens& bad : {Lens{0, 1, 1, 2},
                            {180, 1, 1, 2},
                            {-90, 1, 1, 2},
                            {no_number, 1, 1, 2},
                            {90, 0, 1, 2},
                            {90, -1, 1, 2},
                            {90, no_number, 1, 2},
                            {90, 1, 0, 2},
                            {90, 1, -1, 2},
                            {90, 1, 2, 2},
                            {90, 1, 2, 1},
                            {90, 1, 1, no_number}}) {
        EXPECT_THROW((void)solution().matrix(bad), std::invalid_argument);
        EXPECT_THROW((void)solution().reversed(bad), std::invalid_argument);
    }
    EXPECT_THROW((void)solution().fovy(180, 1), std::invalid_argument);
    EXPECT_THROW((void)solution().fovy(90, 0), std::invalid_argument);
}

// The header's guarantees.
TEST(FieldOfViewAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30504;
    const FieldOfView& reference = *tests::solution_table<FieldOfView>(REFERENCE_MODULE);
    const FieldOfView& oracle = *tests::solution_table<FieldOfView>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 30'000; ++i) {
        Lens lens = random_lens(random);
        const float rest = std::pow(10.0F, random.uniform(-4, 2));
        lens.fovy_degrees = i % 2 == 0 ? rest : 180 - rest;
        for (const auto entry : {&FieldOfView::matrix, &FieldOfView::reversed})
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row)
                    ASSERT_LE(
                        tests::ulps_between((reference.*entry)(lens)[column][row], (oracle.*entry)(lens)[column][row]),
                        1)
                        << "seed " << seed << ", lens " << i;
        const float aspect = std::pow(10.0F, random.uniform(-5, 5));
        ASSERT_LE(
            tests::ulps_between(reference.fovy(lens.fovy_degrees, aspect), oracle.fovy(lens.fovy_degrees, aspect)), 1)
            << "seed " << seed << ", lens " << i;
    }
}
