#include <gtest/gtest.h>

#include <cmath>
#include <lighting/highlights.hpp>

#include "../solution.hpp"
#include "phong_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// Every test here holds for the reference and for the oracle.
class PhongSolution : public testing::TestWithParam<const char*> {
protected:
    const Phong& unit = *tests::solution<Phong>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, PhongSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

// The statement's numbers.
TEST_P(PhongSolution, known_answers)
{
    const glm::vec3 up(0, 0, 1);
    const glm::vec3 l(0, 0.6F, 0.8F);
    EXPECT_EQ(unit.mirrored_direction({1, 2, 3}, {0, 1, 0}), glm::vec3(-1, 2, -3));
    EXPECT_EQ(unit.mirrored_direction(l, up), glm::vec3(0, -0.6F, 0.8F));
    EXPECT_FLOAT_EQ(unit.phong_highlight(up, l, {0, -3, 4}, 2), 1);
    EXPECT_FLOAT_EQ(unit.phong_highlight(up, l, up, 2), 0.64F);
    EXPECT_EQ(unit.phong_highlight(up, l, {1, 0, 0}, 0), 1) << "0^0";
    EXPECT_EQ(unit.phong_highlight(up, {1, 0, 0}, {-1, 0, 0}, 1), 0) << "light that grazes exactly";
    EXPECT_EQ(unit.phong_highlight(up, {0, 0.6F, -0.8F}, {0, -0.6F, -0.8F}, 1), 0) << "light from behind";
}

// Problem 3.9 of the course: the unit sphere, a lamp at (0, 2, 0), an observer at (2, 0, 0).
TEST_P(PhongSolution, sphere_of_problem_3_9)
{
    const auto at = [&](double angle, float e) {
        const glm::vec3 p(std::cos(angle), std::sin(angle), 0);
        return unit.phong_highlight(p, glm::vec3(0, 2, 0) - p, glm::vec3(2, 0, 0) - p, e);
    };
    EXPECT_NEAR(at(glm::radians(45.0), 50), 1, 1e-5);
    for (int i = 1; i < 14; ++i) {
        EXPECT_LT(at(glm::radians(45.0 + i), 50), at(glm::radians(44.0 + i), 50));
        EXPECT_NEAR(at(glm::radians(45.0 + i), 50), at(glm::radians(45.0 - i), 50), 1e-5) << "the picture is symmetric";
    }
    const glm::dvec3 p(std::sqrt(0.5), std::sqrt(0.5), 0);
    EXPECT_NEAR(dot(p, normalize(glm::dvec3(0, 2, 0) - p)), 0.2811, 5e-5) << "lit, and as much seen";
}

// A mirror keeps lengths, sends light back where it came from, and has the normal halfway.
TEST_P(PhongSolution, mirrors)
{
    constexpr std::uint64_t seed = 20431;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 l = std::pow(10.0F, random.uniform(-3, 3)) * random.unit_vector();
        const glm::vec3 n = random.uniform(0.1F, 10) * random.unit_vector();
        const glm::vec3 r = unit.mirrored_direction(l, n);
        ASSERT_NEAR(length(r) / length(l), 1, 1e-6) << "seed " << seed;
        ASSERT_LE(length(unit.mirrored_direction(r, n) - l), 1e-6F * length(l)) << "seed " << seed;
        ASSERT_LE(length(cross(r + l, n)), 3e-6F * length(l) * length(n)) << "seed " << seed;
    }
    EXPECT_EQ(unit.mirrored_direction({1, 2, 3}, {0, 0, 0}), glm::vec3(0));
}

// The angle between r and v by its half, from the lengths of their sum and difference, instead of its cosine.
TEST_P(PhongSolution, highlights_by_angles)
{
    constexpr std::uint64_t seed = 20432;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const Glance g = random_glance(random, 1, 1000);
        const glm::dvec3 n = normalize(glm::dvec3(g.normal));
        const glm::dvec3 l = normalize(glm::dvec3(g.l));
        const glm::dvec3 v = normalize(glm::dvec3(g.v));
        // Turning l by half a turn about n mirrors it.
        const glm::dvec3 r = dot(n, l) * n - cross(n, cross(l, n));
        const double angle = 2 * std::atan2(length(r - v), length(r + v));
        ASSERT_NEAR(unit.phong_highlight(g.normal, g.l, g.v, g.e), std::pow(std::cos(angle), g.e), 1e-7)
            << "seed " << seed << ", case " << i;
    }
}

TEST_P(PhongSolution, null_vectors_make_no_highlight)
{
    const glm::vec3 up(0, 0, 1);
    const glm::vec3 null(0);
    for (const float e : {0.0F, 1.0F, 7.5F}) {
        EXPECT_EQ(unit.phong_highlight(null, up, up, e), 0);
        EXPECT_EQ(unit.phong_highlight(up, null, up, e), 0);
        EXPECT_EQ(unit.phong_highlight(up, up, null, e), 0);
        EXPECT_EQ(unit.phong_highlight(up, up, up, e), 1);
    }
}

// The header's guarantees, with vectors of all lengths.
TEST(PhongReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20433;
    const auto& reference = *tests::solution<Phong>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<Phong>(ORACLE_MODULE);
    const auto& in_float = *tests::solution<Phong>(IN_FLOAT_MODULE);
    Random random(seed);
    float worst_in_float = 0;
    for (int i = 0; i < 50'000; ++i) {
        Glance g = random_glance(random, 1, 10'000);
        const glm::vec3 l = g.l;
        const glm::vec3 v = g.v;
        g.l *= std::pow(10.0F, random.uniform(-30, 30));
        g.v *= std::pow(10.0F, random.uniform(-30, 30));
        const float exact = oracle.phong_highlight(g.normal, g.l, g.v, g.e);
        ASSERT_LE(std::abs(reference.phong_highlight(g.normal, g.l, g.v, g.e) - exact), 1e-7F) << "seed " << seed;
        worst_in_float = std::max(worst_in_float, std::abs(in_float.phong_highlight(g.normal, l, v, g.e) -
                                                           oracle.phong_highlight(g.normal, l, v, g.e)));
        const glm::vec3 error = reference.mirrored_direction(l, g.normal) - oracle.mirrored_direction(l, g.normal);
        ASSERT_LE(length(error), 2e-7F) << "seed " << seed;
    }
    EXPECT_GT(worst_in_float, 1e-4F) << "the hard cases tell them apart";
}
