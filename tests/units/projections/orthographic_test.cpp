#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <projections/volumes.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "orthographic_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

/// Every test here holds for the reference and for the oracle.
class OrthographicSolution : public testing::TestWithParam<const char*> {
protected:
    const Orthographic& solution() const { return *tests::solution_table<Orthographic>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, OrthographicSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_rows(const glm::mat4& got, const glm::mat4& rows)
{
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_EQ(got[column][row], rows[row][column]) << "row " << row << ", column " << column;
}

}

// Worked by hand, and written by rows, as on paper; the second box is that of the course's slide.
TEST_P(OrthographicSolution, known_answers)
{
    expect_rows(solution().matrix({0, 4, 0, 2, 1, 9}), {0.5F, 0, 0, -1, 0, 1, 0, -1, 0, 0, -0.25F, -1.25F, 0, 0, 0, 1});
    expect_rows(solution().matrix({-4, 4, -2, 2, 1.5F, 9.5F}),
                {0.25F, 0, 0, 0, 0, 0.5F, 0, 0, 0, 0, -0.25F, -1.375F, 0, 0, 0, 1});
    expect_rows(solution().inverse({0, 4, 0, 2, 1, 9}), {2, 0, 0, 2, 0, 1, 0, 1, 0, 0, -4, -5, 0, 0, 0, 1});
    expect_rows(solution().matrix({-1, 1, -1, 1, 1, -1}), glm::mat4(1));
}

TEST_P(OrthographicSolution, sides_go_to_the_faces_of_the_cube)
{
    constexpr std::uint64_t seed = 30301;
    Random random(seed);
    for (unsigned i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", box " + std::to_string(i));
        const ViewVolume box = with_sides_exchanged(random_box(random), i % 8);
        const glm::dmat4 matrix(solution().matrix(box));
        const glm::dmat4 inverse(solution().inverse(box));
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec4 corner = side < 0 ? glm::dvec4(box.left, box.bottom, -box.near_plane, 1) :  //
                                          glm::dvec4(box.right, box.top, -box.far_plane, 1);
            const glm::dvec4 seen = matrix * corner;
            for (int axis = 0; axis < 3; ++axis) {
                // An entry is off by 6e-8 of itself, and the sum by that of both terms.
                const double size = std::abs(matrix[axis][axis] * corner[axis]) + std::abs(matrix[3][axis]);
                EXPECT_NEAR(seen[axis], side, 6e-8 * size);
                EXPECT_NEAR((inverse * glm::dvec4(side, side, side, 1))[axis], corner[axis], 2e-6);
            }
            EXPECT_EQ(seen.w, 1);
        }
        if (HasFailure()) return;
    }
}

TEST_P(OrthographicSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 30302;
    Random random(seed);
    for (unsigned i = 0; i < 2000; ++i) {
        const ViewVolume box = with_sides_exchanged(random_box(random), i % 8);
        const glm::dmat4 glm_matrix =
            glm::ortho<double>(box.left, box.right, box.bottom, box.top, box.near_plane, box.far_plane);
        const glm::dmat4 glm_inverse = glm::inverse(glm_matrix);
        const glm::mat4 matrix = solution().matrix(box);
        const glm::mat4 inverse = solution().inverse(box);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                ASSERT_NEAR(matrix[column][row], glm_matrix[column][row], 6e-8 * std::abs(glm_matrix[column][row]))
                    << "seed " << seed << ", box " << i;
                ASSERT_NEAR(inverse[column][row], glm_inverse[column][row],
                            6e-8 * std::abs(glm_inverse[column][row]) + 1e-13)
                    << "seed " << seed << ", box " << i;
            }
    }
}

TEST_P(OrthographicSolution, flat_boxes_are_refused)
{
    for (const ViewVolume& flat : {ViewVolume{2, 2, -1, 1, 1, 5}, {-1, 1, 3, 3, 1, 5}, {-1, 1, -1, 1, 4, 4}}) {
        EXPECT_THROW((void)solution().matrix(flat), std::invalid_argument);
        EXPECT_THROW((void)solution().inverse(flat), std::invalid_argument);
    }
}

TEST_P(OrthographicSolution, sums_of_sides_need_not_be_floats)
{
    const ViewVolume box{-3e38F, 3e38F, 2e38F, 3e38F, -3e38F, -2e38F};
    const glm::mat4 matrix = solution().matrix(box);
    EXPECT_NEAR(matrix[0][0] * 3e38, 1, 3e-7);
    EXPECT_NEAR(matrix[3][1], -5, 1e-6);
    EXPECT_NEAR(matrix[3][2], 5, 1e-6);
    EXPECT_EQ(solution().inverse(box)[0][0], 3e38F);
}

// The header's guarantee: 0.5 ulp is one rounding.
TEST(OrthographicAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30303;
    const Orthographic& reference = *tests::solution_table<Orthographic>(REFERENCE_MODULE);
    const Orthographic& oracle = *tests::solution_table<Orthographic>(ORACLE_MODULE);
    Random random(seed);
    int different = 0;
    for (int i = 0; i < 50'000; ++i) {
        ViewVolume box = random_box(random);
        box.left *= std::pow(10.0F, random.uniform(-15, 15));
        box.top *= std::pow(10.0F, random.uniform(-15, 15));
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                const float got = reference.matrix(box)[column][row];
                const float exact = oracle.matrix(box)[column][row];
                ASSERT_LE(tests::ulps_between(got, exact), 1) << "seed " << seed << ", box " << i;
                different += got != exact ? 1 : 0;
                ASSERT_EQ(reference.inverse(box)[column][row], oracle.inverse(box)[column][row])
                    << "seed " << seed << ", box " << i;
            }
    }
    EXPECT_LE(different, 1) << "a result within 1e-15 of the middle between two floats, one in 10^7";
}
