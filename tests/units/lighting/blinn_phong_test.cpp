#include <gtest/gtest.h>

#include <cmath>
#include <lighting/highlights.hpp>

#include "../solution.hpp"
#include "blinn_phong_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// Every test here holds for the reference and for the oracle.
class BlinnSolution : public testing::TestWithParam<const char*> {
protected:
    const BlinnPhong& unit = *tests::solution<BlinnPhong>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, BlinnSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

// The statement's numbers.
TEST_P(BlinnSolution, known_answers)
{
    const glm::vec3 up(0, 0, 1);
    const glm::vec3 l(0, 0.6F, 0.8F);
    EXPECT_NEAR(unit.blinn_highlight(up, l, up, 4), 0.81, 1e-7);
    EXPECT_EQ(unit.half_vector({0, 3, 0}, {0, 0, 0.25F}), glm::vec3(0, std::sqrt(0.5F), std::sqrt(0.5F)));
    EXPECT_EQ(unit.half_vector({2, 1, 2}, {-2, -1, 2}), up);
    EXPECT_EQ(unit.blinn_highlight(up, l, {1, 0, 0}, 0), 1);
    EXPECT_EQ(unit.blinn_highlight(up, {1, 0, 0}, {-1, 0, 1}, 1), 0) << "light that grazes exactly";
    EXPECT_EQ(unit.blinn_highlight(up, {0, 1, -0.1F}, up, 1), 0) << "light from behind";
    EXPECT_EQ(unit.blinn_highlight(up, l, {0, -0.6F, -0.9F}, 2), 0) << "n·h below 0, with an even exponent";
}

TEST_P(BlinnSolution, where_there_is_no_half_vector)
{
    constexpr std::uint64_t seed = 20441;
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 l = random.unit_vector();
        for (const glm::vec3& v : {-l, -4.0F * l, -0.125F * l, glm::vec3(0)}) {
            EXPECT_EQ(unit.half_vector(l, v), std::nullopt) << "seed " << seed;
            EXPECT_EQ(unit.half_vector(v, l), std::nullopt) << "seed " << seed;
            EXPECT_EQ(unit.blinn_highlight(l, l, v, 0), 0) << "seed " << seed;
        }
        EXPECT_EQ(unit.blinn_highlight({0, 0, 0}, l, l, 0), 0);
        EXPECT_TRUE(unit.half_vector(l, 4.0F * l).has_value()) << "seed " << seed;
    }
}

// h is unit, and encloses the same angle with both: seen in the plane of l and v, the sum of both angles is theirs.
TEST_P(BlinnSolution, halves_angles)
{
    constexpr std::uint64_t seed = 20442;
    Random random(seed);
    const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
        return 2 * std::atan2(length(normalize(a) - normalize(b)), length(normalize(a) + normalize(b)));
    };
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 l = std::pow(10.0F, random.uniform(-3, 3)) * random.unit_vector();
        const glm::vec3 v = std::pow(10.0F, random.uniform(-3, 3)) * random.unit_vector();
        const auto h = unit.half_vector(l, v);
        ASSERT_TRUE(h);
        ASSERT_NEAR(length(*h), 1, 1.5e-7) << "seed " << seed;
        ASSERT_NEAR(angle(*h, l), 0.5 * angle(l, v), 3e-7) << "seed " << seed;
        ASSERT_NEAR(angle(*h, v), 0.5 * angle(l, v), 3e-7) << "seed " << seed;
    }
}

// A surface whose normal is h mirrors the light to the viewer: 2 (h·l) h - l = v.
TEST_P(BlinnSolution, mirrors_at_the_half_vector)
{
    constexpr std::uint64_t seed = 20443;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 l = random.unit_vector();
        const glm::vec3 v = random.unit_vector();
        const glm::dvec3 h(*unit.half_vector(l, v));
        const glm::dvec3 mirrored = 2 * dot(h, glm::dvec3(l)) * h - glm::dvec3(l);
        ASSERT_LE(length(normalize(mirrored) - normalize(glm::dvec3(v))), 4e-7) << "seed " << seed;
        ASSERT_NEAR(unit.blinn_highlight(glm::vec3(h), l, v, 50), 1, 1e-6) << "seed " << seed;
    }
}

// Four times the exponent makes Blinn's highlight Phong's, near its middle.
TEST_P(BlinnSolution, four_times_the_exponent_of_phong)
{
    const glm::dvec3 up(0, 0, 1);
    for (int i = 1; i < 12; ++i) {
        const double angle = 0.01 * i;
        const glm::vec3 v(std::sin(angle), 0, std::cos(angle));
        const double phong = std::pow(std::cos(angle), 80);
        EXPECT_NEAR(unit.blinn_highlight(glm::vec3(up), glm::vec3(up), v, 320), phong, 2e-3) << angle;
    }
}

// The header's guarantees: nearly opposite vectors, all lengths, large exponents.
TEST(BlinnReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20444;
    const auto& reference = *tests::solution<BlinnPhong>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<BlinnPhong>(ORACLE_MODULE);
    const auto& in_float = *tests::solution<BlinnPhong>(IN_FLOAT_MODULE);
    Random random(seed);
    int wrong_in_float = 0;
    for (int i = 0; i < 30'000; ++i) {
        const glm::vec3 l = random.unit_vector();
        const glm::vec3 aside = normalize(cross(l, random.unit_vector()));
        const glm::vec3 v = std::pow(10.0F, random.uniform(-9, 0)) * aside - l;
        const auto exact = oracle.half_vector(l, v);
        const auto got = reference.half_vector(l, v);
        ASSERT_EQ(got.has_value(), exact.has_value()) << "seed " << seed;
        if (!exact) continue;
        ASSERT_LE(length(*got - *exact), 1.8e-7F) << "seed " << seed << ", case " << i;
        const auto rough = in_float.half_vector(l, v);
        wrong_in_float += !rough || length(*rough - *exact) > 1e-5F ? 1 : 0;

        Glance g = random_glance(random, 1, 10'000);
        g.l *= std::pow(10.0F, random.uniform(-30, 30));
        g.v *= std::pow(10.0F, random.uniform(-30, 30));
        ASSERT_NEAR(reference.blinn_highlight(g.normal, g.l, g.v, g.e), oracle.blinn_highlight(g.normal, g.l, g.v, g.e),
                    1e-7F)
            << "seed " << seed;
    }
    EXPECT_GT(wrong_in_float, 10'000) << "the hard cases tell them apart";
}

// Directions that float can hardly tell from opposite ones.
TEST(BlinnReference, tells_opposite_from_nearly_opposite)
{
    const auto& reference = *tests::solution<BlinnPhong>(REFERENCE_MODULE);
    EXPECT_EQ(reference.half_vector({1, 0, 0}, {-1, 1e-30F, 0}).value_or(glm::vec3(0)).y, 1);
    EXPECT_EQ(reference.half_vector({3e38F, 0, 0}, {-1e-38F, 0, 1e-45F}).value_or(glm::vec3(0)).z > 0.9F, true);
    EXPECT_EQ(reference.half_vector({3e38F, 0, 0}, {-1e-38F, 0, 0}), std::nullopt);
    // The sum of unit vectors would leave 1e-16 of x and y.
    EXPECT_LE(length(reference.half_vector({3, 4, 0}, {-6, -8, 1e-20F}).value_or(glm::vec3(0)) - glm::vec3(0, 0, 1)),
              1e-15F);
}
