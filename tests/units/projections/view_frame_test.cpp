#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <projections/support.hpp>

#include "../solution.hpp"
#include "view_frame_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

/// Every test here holds for the reference and for the oracle.
class ViewFrameSolution : public testing::TestWithParam<const char*> {
protected:
    const ViewFrames& solution() const { return *tests::solution_table<ViewFrames>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, ViewFrameSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::dvec3& got, const glm::dvec3& expected, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], expected[axis], tolerance) << "axis " << axis;
}

/// The matrix from world to camera coordinates, by the definition of a frame.
glm::dmat4 view_matrix_of(const ViewFrame& frame)
{
    const glm::dmat3 rows = glm::transpose(glm::dmat3(frame.x, frame.y, frame.z));
    glm::dmat4 view(rows);
    view[3] = glm::dvec4(-rows * glm::dvec3(frame.origin), 1);
    return view;
}

}

// Problem 3.1 and the properties that it asks for; V is the course's.
TEST_P(ViewFrameSolution, problem_3_1)
{
    const ViewParameters view = solution().view({0, 0.5F, 0}, 3, 45, 0, 0);
    const double h = std::sqrt(0.5);
    expect_near(view.target, {0, 0.5, 0}, 0);
    expect_near(view.normal, {3 * h, 0, 3 * h}, 2e-7);
    expect_near(view.up, {0, 1, 0}, 1e-8);
    const ViewFrame frame = solution().frame(view).value();
    const glm::dmat4 matrix = view_matrix_of(frame);
    expect_near(glm::dvec3(matrix * glm::dvec4(0, 0.5, 0, 1)), {0, 0, -3}, 3e-7);
    const double rows[3][4] = {{h, 0, -h, 0}, {0, 1, 0, -0.5}, {h, 0, h, -3}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) EXPECT_NEAR(matrix[column][row], rows[row][column], 3e-7);
}

// Problem 3.2: the picture of problem 3.1, turned anticlockwise by 45 degrees.
TEST_P(ViewFrameSolution, problem_3_2)
{
    const ViewFrame upright = solution().frame(solution().view({0, 0.5F, 0}, 3, 45, 0, 0)).value();
    const ViewFrame rolled = solution().frame(solution().view({0, 0.5F, 0}, 3, 45, 0, 45)).value();
    expect_near(rolled.z, upright.z, 1e-7);
    const glm::dvec3 seen = glm::dmat3(view_matrix_of(rolled)) * glm::dvec3(0, 1, 0);
    expect_near(seen, {-std::sqrt(0.5), std::sqrt(0.5), 0}, 2e-7);
}

TEST_P(ViewFrameSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 30101;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", view " + std::to_string(i));
        const Placement camera = random_placement(random);
        const ViewParameters view{camera.target, camera.up, camera.eye - camera.target};
        const ViewFrame frame = solution().frame(view).value();
        const glm::dvec3 eye = glm::dvec3(view.target) + glm::dvec3(view.normal);
        const glm::dmat4 expected = glm::lookAt(eye, glm::dvec3(view.target), glm::dvec3(view.up));
        const glm::dmat4 got = view_matrix_of(frame);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) EXPECT_NEAR(got[column][row], expected[column][row], 5e-6);
        if (HasFailure()) return;
    }
}

// From straight above and below too, and upside down.
TEST_P(ViewFrameSolution, views_have_frames)
{
    constexpr std::uint64_t seed = 30102;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", view " + std::to_string(i));
        const float azimuth = random.uniform(-720, 720);
        const float elevation = i % 3 == 0 ? 90.0F * static_cast<float>(random.below(9)) : random.uniform(-720, 720);
        const float roll = random.uniform(-720, 720);
        const ViewParameters view = solution().view({1, 2, 3}, 4, azimuth, elevation, roll);
        EXPECT_NEAR(length(glm::dvec3(view.normal)), 4, 4e-7);
        EXPECT_NEAR(length(glm::dvec3(view.up)), 1, 1e-7);
        EXPECT_NEAR(dot(glm::dvec3(view.normal), glm::dvec3(view.up)), 0, 5e-7);
        const ViewFrame frame = solution().frame(view).value();
        expect_near(frame.y, view.up, 3e-7);
        // The world's y axis appears turned from the vertical by the roll.
        const glm::dvec2 vertical(dot(glm::dvec3(frame.x), {0, 1, 0}), dot(glm::dvec3(frame.y), {0, 1, 0}));
        const double cosine = std::cos(glm::radians(double{elevation}));
        EXPECT_NEAR(vertical.x, -std::sin(glm::radians(double{roll})) * cosine, 3e-7);
        EXPECT_NEAR(vertical.y, std::cos(glm::radians(double{roll})) * cosine, 3e-7);
        if (HasFailure()) return;
    }
}

TEST_P(ViewFrameSolution, some_views_have_none)
{
    EXPECT_FALSE(solution().frame({{1, 2, 3}, {0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(solution().frame({{1, 2, 3}, {0, 1, 0}, {0, 0, 0}}));
    EXPECT_FALSE(solution().frame({{1, 2, 3}, {0, 2, 0}, {0, -5, 0}}));
    EXPECT_FALSE(solution().frame({{0, 0, 0}, {0, 0.99e-6F, 1}, {0, 0, 4}}));
    EXPECT_TRUE(solution().frame({{0, 0, 0}, {0, 1.01e-6F, 1}, {0, 0, 4}}));
    EXPECT_TRUE(solution().frame({{0, 0, 0}, {0, 1e-30F, 0}, {0, 0, 1e-30F}})) << "short vectors have directions";
}

// The header's guarantees.
TEST(ViewFrameAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30103;
    const ViewFrames& reference = *tests::solution_table<ViewFrames>(REFERENCE_MODULE);
    const ViewFrames& oracle = *tests::solution_table<ViewFrames>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", view " + std::to_string(i));
        const double sine = 2e-6 * std::pow(5e5, random.uniform_double());
        const Placement c = with_up_near_view(random_placement(random), sine, i % 2 == 0, random);
        const ViewParameters asked{c.target, c.up, c.eye - c.target};
        const ViewFrame got = reference.frame(asked).value();
        const ViewFrame exact = oracle.frame(asked).value();
        expect_near(got.x, exact.x, 6e-8);
        expect_near(got.y, exact.y, 6e-8);
        expect_near(got.z, exact.z, 6e-8);
        expect_near(got.origin, exact.origin, 0);
        const float azimuth = random.uniform(-1e6F, 1e6F);
        const float elevation = random.uniform(-1e6F, 1e6F);
        const float roll = random.uniform(-1e6F, 1e6F);
        const ViewParameters view = reference.view({}, 1, azimuth, elevation, roll);
        const ViewParameters exact_view = oracle.view({}, 1, azimuth, elevation, roll);
        expect_near(view.up, exact_view.up, 6e-8);
        expect_near(view.normal, exact_view.normal, 6e-8);
        if (HasFailure()) return;
    }
}
