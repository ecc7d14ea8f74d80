#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <transforms/support.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "axis_rotation_table.hpp"

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class RotationSolution : public testing::TestWithParam<const char*> {
protected:
    const tests::Rotations rotate = *tests::solution<const tests::Rotations>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, RotationSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::vec3& got, const glm::dvec3& exact, double tolerance = 1.3e-7)
{
    EXPECT_LE(length(glm::dvec3(got) - exact), tolerance)
        << got.x << ' ' << got.y << ' ' << got.z << ", expected " << exact.x << ' ' << exact.y << ' ' << exact.z;
}

/// The largest entry of MᵀM - I, in double.
double off_orthonormal(const glm::mat4& matrix)
{
    const glm::dmat3 rotation{glm::dmat4(matrix)};
    const glm::dmat3 rest = transpose(rotation) * rotation - glm::dmat3(1);
    double worst = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) worst = std::max(worst, std::abs(rest[column][row]));
    return worst;
}

double largest_difference(const glm::mat4& one, const glm::mat4& other)
{
    double worst = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            worst = std::max(worst, std::abs(double{one[column][row]} - double{other[column][row]}));
    return worst;
}

}

TEST_P(RotationSolution, known_answers)
{
    expect_near(rotate.vector({1, 0, 0}, {{0, 0, 1}, pi / 2}), {0, 1, 0});
    expect_near(rotate.vector({0, 1, 0}, {{1, 0, 0}, pi / 2}), {0, 0, 1});
    expect_near(rotate.vector({0, 0, 1}, {{0, 1, 0}, pi / 2}), {1, 0, 0});
    expect_near(rotate.vector({1, 2, 3}, {{1, 1, 1}, 2 * pi / 3}), {3, 1, 2}, 1e-6);
    expect_near(rotate.vector({0, 5, 0}, {{0, 3, 4}, pi}), {0, -1.4, 4.8}, 1e-6);
    EXPECT_EQ(rotate.vector({1, 2, 3}, {{2, 4, 6}, 2}), glm::vec3(1, 2, 3)) << "along the axis";
}

// Laid out by rows, as one writes it: Rot_z[θ] = [c -s 0; s c 0; 0 0 1].
TEST_P(RotationSolution, matrix_has_its_entries_in_place)
{
    const glm::mat4 m = rotate.matrix({{0, 0, 5}, 0.5F});
    EXPECT_FLOAT_EQ(m[0][0], 0.87758256F);
    EXPECT_FLOAT_EQ(m[1][0], -0.47942554F);
    EXPECT_FLOAT_EQ(m[0][1], 0.47942554F);
    EXPECT_FLOAT_EQ(m[1][1], 0.87758256F);
    EXPECT_EQ(m[2], glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(m[3], glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(m[0][2], 0);
}

TEST_P(RotationSolution, nothing_is_turned_by_no_turn)
{
    for (const AxisAngle& turn : {AxisAngle{{0, 0, 0}, 1},
                                  {{1, 0, 0}, 0},
                                  {{1, 0, 0}, not_a_number},
                                  {{0, 1, 0}, -infinity},
                                  {{infinity, 0, 0}, 1},
                                  {{infinity, infinity, 0}, 1},
                                  {{0, not_a_number, 1}, 1}}) {
        EXPECT_EQ(rotate.matrix(turn), glm::mat4(1));
        EXPECT_EQ(rotate.vector({1, -2, 3}, turn), glm::vec3(1, -2, 3));
        EXPECT_EQ(rotate.chain(std::span(&turn, 1)), glm::mat4(1));
    }
    EXPECT_EQ(rotate.chain({}), glm::mat4(1));
}

// The three functions agree, keep lengths and angles, and leave the axis alone.
TEST_P(RotationSolution, is_a_rotation)
{
    constexpr std::uint64_t seed = 20261;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        AxisAngle turn = random_turn(random);
        turn.axis *= std::pow(10.0F, random.uniform(-37, 37));
        turn.angle *= std::pow(10.0F, random.uniform(-8, 4));
        const glm::mat4 matrix = rotate.matrix(turn);
        ASSERT_LE(off_orthonormal(matrix), 3e-7) << "seed " << seed << ", turn " << i;
        const glm::vec3 vector = random.in_cube();
        ASSERT_LE(
            length(glm::dvec3(rotate.vector(vector, turn)) - glm::dvec3(glm::dmat4(matrix) * glm::dvec4(vector, 0))),
            3e-7)
            << "seed " << seed << ", turn " << i;
        ASSERT_EQ(rotate.chain(std::span(&turn, 1)), matrix) << "seed " << seed << ", turn " << i;
        const glm::dvec3 axis = normalize(glm::dvec3(turn.axis));
        ASSERT_LE(length(glm::dmat3(glm::dmat4(matrix)) * axis - axis), 2e-7) << "seed " << seed << ", turn " << i;
    }
}

// A tiny turn by hand: for an axis in the xy-plane, the entry (0, 1) is (1 - cosθ) e.x e.y = θ²/2 · e.x e.y, but for θ²
// of itself.
TEST_P(RotationSolution, tiny_turns_keep_their_second_order)
{
    for (const float angle : {1e-3F, 1e-5F, 1e-8F, 1e-15F}) {
        const glm::mat4 matrix = rotate.matrix({{3, 4, 0}, angle});
        const double second_order = double{angle} * double{angle} / 2 * 0.48;
        EXPECT_NEAR(double{matrix[1][0]} / second_order, 1, 1e-6) << angle;
        EXPECT_NEAR(double{matrix[0][1]} / second_order, 1, 1e-6) << angle;
        EXPECT_NEAR(double{matrix[0][2]} / (-0.8 * double{angle}), 1, 1e-6) << angle;
    }
}

TEST_P(RotationSolution, first_turn_is_the_first)
{
    const AxisAngle turns[] = {{{1, 0, 0}, pi / 2}, {{0, 1, 0}, pi / 2}};
    // (0,1,0) becomes (0,0,1), which becomes (1,0,0).
    expect_near(glm::vec3(rotate.chain(std::span(turns)) * glm::vec4(0, 1, 0, 0)), {1, 0, 0});
    expect_near(glm::vec3(rotate.chain(std::span(turns)) * glm::vec4(0, 0, 1, 0)), {0, -1, 0});
}

// A chain about one axis is one turn by the sum of the angles, which is computed here from the float that the angle
// really is.
TEST_P(RotationSolution, long_chain_turns_by_the_sum)
{
    const AxisAngle step{{0, 0, 2}, 1e-4F};
    const std::vector<AxisAngle> chain(3'600'000, step);
    const glm::mat4 matrix = rotate.chain(chain);
    const double angle = 3.6e6 * double{step.angle};
    EXPECT_LE(off_orthonormal(matrix), 2e-7);
    EXPECT_NEAR(double{matrix[0][0]}, std::cos(angle), 6e-8);
    EXPECT_NEAR(double{matrix[0][1]}, std::sin(angle), 6e-8);
    EXPECT_EQ(matrix[2], glm::vec4(0, 0, 1, 0));
}

// The header's guarantees.
TEST(RotationAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20262;
    const auto reference = *tests::solution<const tests::Rotations>(REFERENCE_MODULE);
    const auto oracle = *tests::solution<const tests::Rotations>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const AxisAngle turn{std::pow(10.0F, random.uniform(-37, 37)) * clear_axis(i % 2 == 0, random),
                             std::pow(10.0F, random.uniform(-15, 0))};
        const glm::mat4 got = reference.matrix(turn);
        const glm::mat4 exact = oracle.matrix(turn);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                ASSERT_LE(tests::ulps_between(got[column][row], exact[column][row]), 1)
                    << "seed " << seed << ", turn " << i;
    }
    for (const float angle : {1e-7F, 1e-4F, 1e-1F, 3.0F}) {
        const std::vector<AxisAngle> chain = wandering_turns(random.unit_vector(), angle, 200'000, random);
        EXPECT_LE(largest_difference(reference.chain(chain), oracle.chain(chain)), 6e-8)
            << "seed " << seed << ", angles " << angle;
    }
}

// The hard cases must tell the forms apart.
TEST(RotationAccuracy, float_fails)
{
    const auto naive = *tests::solution<const tests::Rotations>(IN_FLOAT_MODULE);
    EXPECT_EQ(naive.matrix({{3, 4, 0}, 1e-4F})[1][0], 0) << "1 - cosθ is 0";
    EXPECT_EQ(naive.matrix({{0, 0, 1e-30F}, 1}), glm::mat4(1)) << "the square of the axis is 0";
    const std::vector<AxisAngle> chain(3'600'000, {{1, -2, 2}, 1e-4F});
    EXPECT_GT(off_orthonormal(naive.chain(chain)), 1e-3);
}
