#include "frustum_functions.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <projections/volumes.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Every test here holds for the reference and for the oracle.
class FrustumSolution : public testing::TestWithParam<const char*> {
protected:
    const Frustum& solution() const { return *tests::solution_table<Frustum>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, FrustumSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

// All entries within `share` of the largest of their column.
void expect_near(const glm::dmat4& got, const glm::dmat4& expected, double share)
{
    for (int column = 0; column < 4; ++column) {
        double size = 0;
        for (int row = 0; row < 4; ++row) size = std::max(size, std::abs(expected[column][row]));
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(got[column][row], expected[column][row], share * size)
                << "row " << row << ", column " << column;
    }
}

}

// Worked by hand, and written by rows, as on paper. The second frustum is that of problem 3.5 for a cube of side 2.
TEST_P(FrustumSolution, known_answers)
{
    const glm::mat4 unit(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -3, 0, 0, -1, 0);
    EXPECT_EQ(solution().matrix({-1, 1, -1, 1, 1, 3}), glm::transpose(unit));
    const glm::mat4 cube(3, 0, 0, 0, 0, 3, 0, 0, 0, 0, -4, -15, 0, 0, -1, 0);
    EXPECT_EQ(solution().matrix({-1, 1, -1, 1, 3, 5}), glm::transpose(cube));
    const glm::mat4 aside(1, 0, 1, 0, 0, 2, 0, 0, 0, 0, -2, -6, 0, 0, -1, 0);
    EXPECT_EQ(solution().matrix({0, 4, -1, 1, 2, 6}), glm::transpose(aside));
    const FrustumFactors factors = solution().factors({0, 4, -1, 1, 2, 6});
    EXPECT_EQ(factors.shear[2], glm::vec4(1, 0, 1, 0));
    EXPECT_EQ(factors.scaling, glm::mat4(1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    EXPECT_EQ(factors.normalization, glm::transpose(glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -6, 0, 0, -1, 0)));
}

TEST_P(FrustumSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 30401;
    Random random(seed);
    for (unsigned i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", frustum " + std::to_string(i));
        const ViewVolume v = with_sides_exchanged(random_frustum(random), i % 8);
        expect_near(solution().matrix(v),
                    glm::frustum<double>(v.left, v.right, v.bottom, v.top, v.near_plane, v.far_plane), 6e-8);
        if (HasFailure()) return;
    }
}

TEST_P(FrustumSolution, is_the_product_of_its_factors)
{
    constexpr std::uint64_t seed = 30402;
    Random random(seed);
    for (unsigned i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", frustum " + std::to_string(i));
        ViewVolume volume = with_sides_exchanged(random_frustum(random), i % 8);
        if (i % 8 == 0) volume.far_plane = infinity;
        const FrustumFactors factors = solution().factors(volume);
        expect_near(solution().matrix(volume),
                    glm::dmat4(factors.normalization) * glm::dmat4(factors.scaling) * glm::dmat4(factors.shear), 2e-7);
        const glm::dvec4 middle(0.5 * (double{volume.left} + volume.right), 0.5 * (double{volume.bottom} + volume.top),
                                -volume.near_plane, 1);
        const glm::dvec4 centred = glm::dmat4(factors.shear) * middle;
        EXPECT_NEAR(centred.x, 0, 1e-7 * std::abs(middle.x));
        EXPECT_NEAR(centred.y, 0, 1e-7 * std::abs(middle.y));
        if (HasFailure()) return;
    }
}

TEST_P(FrustumSolution, corners_go_to_the_corners_of_the_cube)
{
    constexpr std::uint64_t seed = 30403;
    Random random(seed);
    for (unsigned i = 0; i < 500; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", frustum " + std::to_string(i));
        const ViewVolume v = with_sides_exchanged(random_frustum(random), i % 8);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const float distance = (corner & 4U) != 0 ? v.far_plane : v.near_plane;
            const float along = distance / v.near_plane;
            const glm::vec3 point(along * ((corner & 1U) != 0 ? v.right : v.left),
                                  along * ((corner & 2U) != 0 ? v.top : v.bottom), -distance);
            const std::optional<glm::vec3> seen = solution().point(solution().matrix(v), point);
            ASSERT_TRUE(seen.has_value());
            // Entries are rounded by 6e-8, and the windows lie up to ten half sizes off the axis.
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR((*seen)[axis], ((corner >> static_cast<unsigned>(axis)) & 1U) != 0 ? 1 : -1, 1e-5);
        }
        if (HasFailure()) return;
    }
}

TEST_P(FrustumSolution, infinity_is_the_limit)
{
    const ViewVolume endless{-1, 2, -1, 1, 0.5F, infinity};
    const glm::mat4 matrix = solution().matrix(endless);
    EXPECT_EQ(matrix[2][2], -1);
    EXPECT_EQ(matrix[3][2], -1);
    ViewVolume far = endless;
    far.far_plane = std::numeric_limits<float>::max();
    EXPECT_EQ(solution().matrix(far), matrix);
    EXPECT_EQ(solution().factors(endless).normalization[3], glm::vec4(0, 0, -1, 0));
}

TEST_P(FrustumSolution, what_is_no_frustum_is_refused)
{
    for (const ViewVolume& bad : {ViewVolume{1, 1, -1, 1, 1, 2},
                                  {-1, 1, 2, 2, 1, 2},
                                  {-1, 1, -1, 1, 2, 2},
                                  {-1, 1, -1, 1, 0, 2},
                                  {-1, 1, -1, 1, -1, 2},
                                  {-1, 1, -1, 1, 1, 0},
                                  {-1, 1, -1, 1, 1, -2}}) {
        EXPECT_THROW((void)solution().matrix(bad), std::invalid_argument);
        EXPECT_THROW((void)solution().factors(bad), std::invalid_argument);
    }
}

TEST_P(FrustumSolution, nothing_behind_the_eye_is_shown)
{
    const glm::mat4 matrix = solution().matrix({-1, 1, -1, 1, 1, 3});
    for (const float z : {0.0F, -0.0F, 1e-30F, 2.0F}) EXPECT_FALSE(solution().point(matrix, {1, 1, z}).has_value());
    EXPECT_EQ(solution().point(matrix, {2, -1, -2}), glm::vec3(1, -0.5F, 0.5F));
    EXPECT_TRUE(solution().point(glm::mat4(1), {0, 0, 5}).has_value()) << "w = 1 in an orthographic projection";
}

// The header's guarantees.
TEST(FrustumAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30404;
    const Frustum& reference = *tests::solution_table<Frustum>(REFERENCE_MODULE);
    const Frustum& oracle = *tests::solution_table<Frustum>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 30'000; ++i) {
        ViewVolume volume = random_frustum(random);
        volume.far_plane = volume.near_plane * (1 + std::pow(10.0F, random.uniform(-6, 9)));
        const glm::mat4 got = reference.matrix(volume);
        const glm::mat4 exact = oracle.matrix(volume);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                ASSERT_LE(tests::ulps_between(got[column][row], exact[column][row]), 1)
                    << "seed " << seed << ", frustum " << i;
        volume.left = 5 * volume.near_plane;
        volume.right = volume.left * (1 + std::pow(10.0F, random.uniform(-6, -1)));
        const glm::mat4 narrow = oracle.matrix(volume);
        const glm::vec3 point(5 + random.uniform(-1, 1) * 1e-3F, random.uniform(-1, 1), -1);
        const glm::vec3 seen = reference.point(narrow, point).value();
        const glm::vec3 right = oracle.point(narrow, point).value();
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(seen[axis], right[axis], 1e-15 * (1e7 + 10) + 6e-8 * std::abs(right[axis]))
                << "seed " << seed << ", frustum " << i;
    }
}
