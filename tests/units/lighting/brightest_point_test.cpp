#include <gtest/gtest.h>

#include <cmath>
#include <lighting/brightest-point/lit_sphere.hpp>

#include "../solution.hpp"
#include "brightest_point_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// Every test here holds for the reference and for the oracle.
class BrightestPointSolution : public testing::TestWithParam<const char*> {
protected:
    const BrightestPoint& unit = *tests::solution<BrightestPoint>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, BrightestPointSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

/// The course's diffuse term at the point with that normal, and how far r is from v there.
struct Brightness {
    double diffuse;
    double facing;
    double off_mirror;
};

Brightness brightness(const LitSphere& q, const glm::dvec3& n)
{
    const glm::dvec3 p = glm::dvec3(q.sphere.centre) + double{q.sphere.radius} * n;
    const glm::dvec3 position(q.light.position);
    const glm::dvec3 l = normalize(q.light.position.w == 0 ? position : position - p);
    const glm::dvec3 v = normalize(glm::dvec3(q.eye) - p);
    return {dot(n, l), dot(n, v), length(2 * dot(n, l) * n - l - v)};
}

glm::dvec3 normal_at(const LitSphere& q, const glm::vec3& point)
{
    return normalize(glm::dvec3(point) - glm::dvec3(q.sphere.centre));
}

}

TEST_P(BrightestPointSolution, answers_problem_3_9)
{
    const Sphere sphere;
    const Light lamp{{0, 2, 0, 1}};
    const glm::vec3 eye(2, 0, 0);
    const LitSphere q{sphere, lamp, eye};
    EXPECT_EQ(unit.brightest_diffuse(sphere, lamp), glm::vec3(0, 1, 0));
    EXPECT_FALSE(unit.is_seen(sphere, {0, 1, 0}, eye));
    EXPECT_NEAR(brightness(q, {0, 1, 0}).facing, -1 / std::sqrt(5.0), 1e-12);
    const glm::vec3 seen = unit.brightest_seen(sphere, lamp, eye).value();
    EXPECT_LT(length(seen - glm::vec3(0.5F, std::sqrt(0.75F), 0)), 1e-7F);
    EXPECT_NEAR(brightness(q, normal_at(q, seen)).diffuse, 0.5907, 5e-5);
    const glm::vec3 mirror = unit.brightest_specular(sphere, lamp, eye).value();
    EXPECT_LT(length(mirror - glm::vec3(std::sqrt(0.5F), std::sqrt(0.5F), 0)), 1e-7F);
    EXPECT_TRUE(unit.is_seen(sphere, mirror, eye));
    EXPECT_NEAR(brightness(q, normal_at(q, mirror)).diffuse, 0.2811, 5e-5);
}

// The formulas of the illumination model at many points of the sphere: none is brighter.
TEST_P(BrightestPointSolution, no_other_point_is_brighter)
{
    constexpr std::uint64_t seed = 20501;
    Random random(seed);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const LitSphere q = random_lit_sphere(random, random.uniform(0, 1.4F));
        const Brightness top = brightness(q, normal_at(q, unit.brightest_diffuse(q.sphere, q.light)));
        ASSERT_NEAR(top.diffuse, 1, 1e-6) << "seed " << seed;
        const auto seen = unit.brightest_seen(q.sphere, q.light, q.eye);
        const auto mirror = unit.brightest_specular(q.sphere, q.light, q.eye);
        ASSERT_EQ(seen.has_value(), mirror.has_value()) << "seed " << seed;
        const double best = seen ? brightness(q, normal_at(q, *seen)).diffuse : 0;
        if (seen) {
            ++found;
            ASSERT_GT(best, 0) << "seed " << seed;
            ASSERT_GT(brightness(q, normal_at(q, *seen)).facing, -1e-6) << "seed " << seed;
            const Brightness highlight = brightness(q, normal_at(q, *mirror));
            ASSERT_LT(highlight.off_mirror, 3e-6) << "seed " << seed;
            ASSERT_GT(highlight.diffuse, 0) << "seed " << seed;
        }
        for (int k = 0; k < 300; ++k) {
            const glm::dvec3 n = normalize(glm::dvec3(random.unit_vector()));
            const Brightness other = brightness(q, n);
            if (other.facing > 1e-6) {
                ASSERT_LE(other.diffuse, best + 2e-6) << "seed " << seed;
            }
            const glm::vec3 p = q.sphere.centre + q.sphere.radius * glm::vec3(n);
            if (std::abs(other.facing) > 1e-5) {
                ASSERT_EQ(unit.is_seen(q.sphere, p, q.eye), other.facing > 0) << "seed " << seed;
            }
        }
    }
    EXPECT_GT(found, 150);
    EXPECT_LT(found, 290);
}

TEST_P(BrightestPointSolution, all_on_one_line)
{
    const Sphere sphere{{1, 2, 3}, 2};
    const Light lamp{{1, 7, 3, 1}};
    const glm::vec3 top(1, 4, 3);
    EXPECT_EQ(unit.brightest_seen(sphere, lamp, {1, 9, 3}), top);
    EXPECT_EQ(unit.brightest_specular(sphere, lamp, {1, 9, 3}), top);
    EXPECT_EQ(unit.brightest_specular(sphere, {{0, 0.001F, 0, 0}}, {1, 9, 3}), top);
    EXPECT_EQ(unit.brightest_seen(sphere, lamp, {1, -9, 3}), std::nullopt);
    EXPECT_EQ(unit.brightest_specular(sphere, lamp, {1, -9, 3}), std::nullopt);
}

// The header's guarantee, also close above the surface and far away.
TEST(BrightestPointReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20502;
    const auto& reference = *tests::solution<BrightestPoint>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<BrightestPoint>(ORACLE_MODULE);
    Random random(seed);
    const auto radii = [&] { return 1 + std::pow(10.0F, random.uniform(-2.9F, 6)); };
    for (int i = 0; i < 20'000; ++i) {
        const float light_radii = i % 4 == 0 ? 0 : radii();
        const LitSphere q = lit_sphere(random, {}, random.uniform(0, 0.999F), light_radii, radii());
        const auto near = [&](const std::optional<glm::vec3>& one, const std::optional<glm::vec3>& other) {
            return one && other && length(*one - *other) <= 1.2e-7F;  // rounding to float may differ by 6e-8
        };
        ASSERT_TRUE(near(reference.brightest_diffuse(q.sphere, q.light), oracle.brightest_diffuse(q.sphere, q.light)));
        ASSERT_TRUE(
            near(reference.brightest_seen(q.sphere, q.light, q.eye), oracle.brightest_seen(q.sphere, q.light, q.eye)))
            << "seed " << seed << ", case " << i;
        ASSERT_TRUE(near(reference.brightest_specular(q.sphere, q.light, q.eye),
                         oracle.brightest_specular(q.sphere, q.light, q.eye)))
            << "seed " << seed << ", case " << i;
    }
}
