#include <gtest/gtest.h>

#include <projections/support.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::projections;
using View = glm::mat4(const glm::vec3&, const glm::vec3&, const glm::vec3&);

namespace {

/// Every test here holds for the reference and for the oracle.
class ViewSolution : public testing::TestWithParam<const char*> {
protected:
    glm::mat4 view_of(const Placement& camera) const { return view_(camera.eye, camera.target, camera.up); }

    /// What makes a matrix a view matrix, whatever formula made it; all bounds are a few roundings of the entries.
    void expect_view_matrix(const Placement& camera) const
    {
        const glm::dmat4 view(view_of(camera));
        const glm::dmat3 rotation(view);
        const glm::dmat3 product = rotation * transpose(rotation);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 3e-7);
        EXPECT_NEAR(determinant(rotation), 1, 5e-7) << "right-handed";
        for (int column = 0; column < 4; ++column) EXPECT_EQ(view[column][3], column == 3 ? 1 : 0) << "the last row";

        const double size = length(glm::dvec3(camera.eye)) + length(glm::dvec3(camera.target));
        EXPECT_LE(length(glm::dvec3(view * glm::dvec4(camera.eye, 1))), 2e-7 * size) << "the eye goes to the origin";
        const double away = distance(glm::dvec3(camera.eye), glm::dvec3(camera.target));
        const glm::dvec3 seen(view * glm::dvec4(camera.target, 1));
        EXPECT_LE(distance(seen, glm::dvec3(0, 0, -away)), 3e-7 * size) << "the target goes to the -z axis";
    }

    View* const view_ = tests::solution<View>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, ViewSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::mat4& got, const glm::mat4& rows, double tolerance)
{
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_NEAR(got[column][row], rows[row][column], tolerance) << "row " << row << ", column " << column;
}

}

// Worked by hand; the matrices are written by rows, as on paper.
TEST_P(ViewSolution, known_answers)
{
    expect_near(view_of({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}}), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5, 0, 0, 0, 1}, 0);
    expect_near(view_of({{3, 0, 0}, {0, 0, 0}, {0, 1, 0}}), {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, -3, 0, 0, 0, 1}, 0);
    expect_near(view_of({{0, 3, 4}, {0, 0, 0}, {0, 7, 0}}),
                {1, 0, 0, 0, 0, 0.8F, -0.6F, 0, 0, 0.6F, 0.8F, -5, 0, 0, 0, 1}, 1e-7);
    // Problem 3.1, and the middle of the animation in problem 4.1.
    const float h = 0.70710678F;
    expect_near(view_of({{2.1213203F, 0.5F, 2.1213203F}, {0, 0.5F, 0}, {0, 1, 0}}),
                {h, 0, -h, 0, 0, 1, 0, -0.5F, h, 0, h, -3, 0, 0, 0, 1}, 3e-7);
    expect_near(view_of({{2.5F, 1, 2.5F}, {0, 0.5F, 0}, {0, 1, 0}}),
                {h, 0, -h, 0, -0.0990148F, 0.9901475F, -0.0990148F, -0.4950738F, 0.70014F, 0.140028F, 0.70014F,
                 -3.6407282F, 0, 0, 0, 1},
                3e-7);
}

TEST_P(ViewSolution, is_a_view_matrix)
{
    constexpr std::uint64_t seed = 20264;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        Placement camera = random_placement(random);
        if (i % 3 == 1)
            camera = with_up_near_view(camera, std::pow(10.0, -6.0 * random.uniform_double()), i % 2 == 0, random);
        if (i % 3 == 2) camera.eye *= std::pow(10.0F, random.uniform(0, 5));
        camera.up *= std::pow(10.0F, random.uniform(-20, 20));
        SCOPED_TRACE("seed " + std::to_string(seed) + ", camera " + std::to_string(i));
        expect_view_matrix(camera);
        const glm::dvec3 vertical = glm::dmat3(glm::dmat4(view_of(camera))) * normalize(glm::dvec3(camera.up));
        EXPECT_NEAR(vertical.x, 0, 3e-7) << "up appears vertical";
        if (sine_to_up(camera) > 2e-6) {
            EXPECT_GT(vertical.y, 0) << "and pointing up";
        }
        if (HasFailure()) return;
    }
}

TEST_P(ViewSolution, degenerate_input_follows_the_rule)
{
    // Looking down along y: x and z are equally perpendicular, x is the first. So the vertical of the picture is x.
    expect_near(view_of({{0, 10, 0}, {0, 0, 0}, {0, 1, 0}}), {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, -10, 0, 0, 0, 1}, 0);
    expect_near(view_of({{0, 10, 0}, {0, 0, 0}, {0, -5, 0}}), {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, -10, 0, 0, 0, 1}, 0);
    // Along x: y is the first of the two.
    expect_near(view_of({{10, 0, 0}, {0, 0, 0}, {0, 0, 0}}), {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, -10, 0, 0, 0, 1}, 0);
    // Eye and target equal: along -z, with the given up.
    expect_near(view_of({{1, 2, 3}, {1, 2, 3}, {0, 1, 0}}), {1, 0, 0, -1, 0, 1, 0, -2, 0, 0, 1, -3, 0, 0, 0, 1}, 0);
    expect_near(view_of({{1, 2, 3}, {1, 2, 3}, {0, 0, 1}}), {0, -1, 0, 2, 1, 0, 0, -1, 0, 0, 1, -3, 0, 0, 0, 1}, 0);
    Random random(20265);
    for (int i = 0; i < 200; ++i) {
        Placement camera = random_placement(random);
        camera.up = i % 2 == 0 ? glm::vec3(0) : camera.eye - camera.target;
        expect_view_matrix(camera);
        camera.up = glm::vec3(std::numeric_limits<float>::denorm_min(), 0, 0);
        expect_view_matrix(camera);
    }
}

// The sine decides, on both sides of the threshold and at both ends of the view.
TEST_P(ViewSolution, threshold_is_a_millionth)
{
    const auto turned = [](float sine) { return Placement{{0, 0, 4}, {0, 0, 0}, {0, sine, 1}}; };
    expect_near(view_of(turned(1.01e-6F)), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -4, 0, 0, 0, 1}, 0);
    expect_near(view_of(turned(0.99e-6F)), {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, -4, 0, 0, 0, 1}, 0);
}

// The header's guarantee, and the tolerances of the hard checks.
TEST(ViewAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20266;
    View* const reference = tests::solution<View>(REFERENCE_MODULE);
    View* const oracle = tests::solution<View>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 50'000; ++i) {
        const double sine = 2e-6 * std::pow(5e5, random.uniform_double());
        Placement camera = random_placement(random);
        camera.eye *= std::pow(10.0F, random.uniform(0, 5));
        camera = with_up_near_view(camera, sine, i % 2 == 0, random);
        const glm::mat4 got = reference(camera.eye, camera.target, camera.up);
        const glm::mat4 exact = oracle(camera.eye, camera.target, camera.up);
        ASSERT_LE(tests::rotation_error(got, exact), 6e-8) << "seed " << seed << ", camera " << i;
        ASSERT_LE(tests::translation_error(got, exact), 1.2e-7 * double{length(camera.eye)})
            << "seed " << seed << ", camera " << i;
    }
}

// The hard cases must tell the forms apart.
TEST(ViewAccuracy, float_fails_near_the_parallel)
{
    View* const naive = tests::solution<View>(FLOAT_CROSS_MODULE);
    View* const oracle = tests::solution<View>(ORACLE_MODULE);
    Random random(20267);
    int wrong = 0;
    for (int i = 0; i < 1000; ++i) {
        const Placement c = with_up_near_view(random_placement(random), 1e-4, false, random);
        wrong += tests::rotation_error(naive(c.eye, c.target, c.up), oracle(c.eye, c.target, c.up)) > 1e-5 ? 1 : 0;
    }
    EXPECT_GT(wrong, 900);
}
