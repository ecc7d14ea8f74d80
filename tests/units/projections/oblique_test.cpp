#include "oblique_functions.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <projections/volumes.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

/// Every test here holds for the reference and for the oracle.
class ObliqueSolution : public testing::TestWithParam<const char*> {
protected:
    const ObliqueFunctions& solution() const { return *tests::solution_table<ObliqueFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, ObliqueSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

Lean random_lean(Random& random)
{
    const float angle = random.uniform(-720, 720);
    return {angle, random.uniform(-2, 2)};
}

}

// The course's: tan α = 1 and tan α = 2.
TEST_P(ObliqueSolution, known_answers)
{
    EXPECT_EQ(solution().foreshortening(45), 1);
    EXPECT_NEAR(solution().foreshortening(63.434949F), 0.5, 1e-7);
    EXPECT_EQ(solution().foreshortening(90), 0);
    const glm::dvec4 seen = glm::dmat4(solution().shear({0, 1})) * glm::dvec4(0, 0, -3, 1);
    EXPECT_NEAR(seen.x, 3, 1e-6);
    EXPECT_EQ(seen.z, -3);
    EXPECT_EQ(solution().shear({37, 0}), glm::mat4(1));
    EXPECT_EQ(solution().direction({37, 0}), glm::vec3(0, 0, -1));
}

TEST_P(ObliqueSolution, matrix_is_a_shear_before_glm_ortho)
{
    constexpr std::uint64_t seed = 30801;
    Random random(seed);
    for (unsigned i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", lean " + std::to_string(i));
        const Lean lean = random_lean(random);
        const ViewVolume v = with_sides_exchanged(random_box(random), i % 8);
        const double angle = glm::radians(double{lean.angle_degrees});
        glm::dmat4 shear(1);
        shear[2][0] = -lean.foreshortening * std::cos(angle);
        shear[2][1] = -lean.foreshortening * std::sin(angle);
        const glm::dmat4 expected =
            glm::ortho<double>(v.left, v.right, v.bottom, v.top, v.near_plane, v.far_plane) * shear;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                EXPECT_NEAR(solution().matrix(v, lean)[column][row], expected[column][row],
                            6e-8 * std::abs(expected[column][row]) + 1e-14);
                EXPECT_NEAR(solution().shear(lean)[column][row], shear[column][row],
                            6e-8 * std::abs(shear[column][row]) + 1e-15);
            }
        if (HasFailure()) return;
    }
}

TEST_P(ObliqueSolution, rays_appear_as_points)
{
    constexpr std::uint64_t seed = 30802;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const Lean lean = random_lean(random);
        const glm::dvec3 direction(solution().direction(lean));
        const glm::dvec3 seen = glm::dmat3(glm::dmat4(solution().shear(lean))) * direction;
        EXPECT_NEAR(length(direction), 1, 1e-7);
        EXPECT_NEAR(seen.x, 0, 3e-7);
        EXPECT_NEAR(seen.y, 0, 3e-7);
        EXPECT_LT(seen.z, 0) << "away from the viewer";
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", lean " << i;
    }
}

// The rays meet the view plane under the angle that they were given.
TEST_P(ObliqueSolution, foreshortening_belongs_to_its_angle)
{
    for (const float alpha : {1.0F, 20.0F, 45.0F, 63.4F, 89.0F, 90.0F}) {
        const glm::dvec3 direction(solution().direction({70, solution().foreshortening(alpha)}));
        EXPECT_NEAR(glm::degrees(std::asin(-direction.z)), alpha, alpha > 89.5F ? 0.02 : 1e-3);
    }
    for (const float wrong : {0.0F, -1.0F, 90.001F, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_THROW((void)solution().foreshortening(wrong), std::invalid_argument);
}

// The header's guarantees.
TEST(ObliqueAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30803;
    const ObliqueFunctions& reference = *tests::solution_table<ObliqueFunctions>(REFERENCE_MODULE);
    const ObliqueFunctions& oracle = *tests::solution_table<ObliqueFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 30'000; ++i) {
        const float rest = std::pow(10.0F, random.uniform(-4, 1.9F));
        const float tiny = std::pow(10.0F, random.uniform(-36.5F, -4));
        const float alpha = i % 4 == 0 ? rest : i % 4 == 1 ? tiny : 90 - rest;
        ASSERT_LE(tests::ulps_between(reference.foreshortening(alpha), oracle.foreshortening(alpha)), 1)
            << "seed " << seed << ", angle " << i;
        const float angle = std::pow(10.0F, random.uniform(0, 9));
        const Lean lean{i % 2 == 0 ? angle : -angle, std::pow(10.0F, random.uniform(-2, 37))};
        const glm::dvec3 column(reference.shear(lean)[2]);
        const glm::dvec3 right(oracle.shear(lean)[2]);
        const glm::dvec3 direction(reference.direction(lean));
        const glm::dvec3 right_direction(oracle.direction(lean));
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(column[k], right[k], 6.1e-8 * std::abs(right[k]) + 1e-15 * length(right)) << "lean " << i;
            ASSERT_NEAR(direction[k], right_direction[k], 6.1e-8 * std::abs(right_direction[k]) + 1e-15)
                << "lean " << i;
        }
    }
}
