#include <gtest/gtest.h>

#include <raytracing/reflect-refract/glances.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "reflect_refract_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

/// Every test here holds for the reference and for the oracle.
class ReflectRefractSolution : public testing::TestWithParam<const char*> {
protected:
    const ReflectRefractFunctions& solution() const
    {
        return *tests::solution_table<ReflectRefractFunctions>(GetParam());
    }
    std::optional<glm::vec3> refracted(const SurfaceGlance& glance) const
    {
        return solution().refracted(glance.v, glance.n, glance.outside, glance.inside);
    }
};
INSTANTIATE_TEST_SUITE_P(Solutions, ReflectRefractSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::vec3& got, const glm::dvec3& expected, double tolerance = 1e-7)
{
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], tolerance) << "coordinate " << i;
}

}

// The course's numbers: at 45° into glass, and the critical angles of glass and water.
TEST_P(ReflectRefractSolution, known_answers_of_the_course)
{
    const glm::vec3 up(0, 1, 0);
    const auto t = refracted({{1, 1, 0}, up, 1, 1.5F});
    ASSERT_TRUE(t);
    expect_near(*t, {-0.4714045208, -0.8819171037, 0});
    EXPECT_NEAR(*solution().critical_angle(1.5F, 1) * 180 / 3.14159265358979, 41.8103, 1e-4);
    EXPECT_NEAR(*solution().critical_angle(1.33F, 1) * 180 / 3.14159265358979, 48.7535, 1e-4);
    EXPECT_EQ(solution().critical_angle(1, 1.5F), std::nullopt);
    EXPECT_EQ(solution().critical_angle(1.5F, 1.5F), std::nullopt);
    expect_near(solution().mirrored({0.6F, 0.8F, 0}, up), {-0.6, 0.8, 0});
    expect_near(solution().mirrored({0.6F, -0.8F, 0}, up), {-0.6, -0.8, 0});
}

TEST_P(ReflectRefractSolution, light_along_the_surface_arrives_from_outside)
{
    const glm::vec3 up(0, 1, 0);
    EXPECT_TRUE(refracted({{1, 0, 0}, up, 1, 1.5F}));
    EXPECT_FALSE(refracted({{1, 0, 0}, up, 1.5F, 1}));
    const auto same = refracted({{1, 0, 0}, up, 1.5F, 1.5F});
    ASSERT_TRUE(same);
    expect_near(*same, {-1, 0, 0});
}

// Against GLM in double, which takes directions that arrive, and normals on their side.
TEST_P(ReflectRefractSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 26001;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", glance " + std::to_string(i));
        const SurfaceGlance glance = i % 4 == 0 ? total_glance(random) : refracted_glance(random);
        const glm::dvec3 arriving = -normalize(glm::dvec3(glance.v));
        glm::dvec3 normal = normalize(glm::dvec3(glance.n));
        double ratio = double{glance.outside} / double{glance.inside};
        if (dot(arriving, normal) > 0) {
            normal = -normal;
            ratio = 1 / ratio;
        }
        const glm::dvec3 expected = glm::refract(arriving, normal, ratio);
        const auto got = refracted(glance);
        ASSERT_EQ(got.has_value(), expected != glm::dvec3(0));
        ASSERT_EQ(got.has_value(), i % 4 != 0);
        if (got) expect_near(*got, expected);
        expect_near(solution().mirrored(glance.v, glance.n), glm::reflect(arriving, normal));
    }
}

// Light takes the same way back; what Snell's law says of the sines holds; all lies in one plane.
TEST_P(ReflectRefractSolution, refraction_can_be_turned_round)
{
    constexpr std::uint64_t seed = 26002;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", glance " + std::to_string(i));
        const SurfaceGlance glance = refracted_glance(random);
        const auto onwards = refracted(glance);
        ASSERT_TRUE(onwards);
        const auto back = refracted({*onwards, glance.n, glance.outside, glance.inside});
        ASSERT_TRUE(back);
        expect_near(*back, glance.v, 3e-6);

        const glm::dvec3 normal(glance.n);
        const bool enters = dot(glance.v, glance.n) >= 0;
        const double from = enters ? glance.outside : glance.inside;
        const double into = enters ? glance.inside : glance.outside;
        ASSERT_NEAR(from * length(cross(glm::dvec3(glance.v), normal)),
                    into * length(cross(glm::dvec3(*onwards), normal)), 1e-6);
        ASSERT_NEAR(dot(cross(glm::dvec3(glance.v), normal), glm::dvec3(*onwards)), 0, 1e-6);
        ASSERT_NEAR(length(glm::dvec3(*onwards)), 1, 1e-7);
    }
}

TEST_P(ReflectRefractSolution, no_light_comes_through_beyond_the_critical_angle)
{
    constexpr std::uint64_t seed = 26003;
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", media " + std::to_string(i));
        const auto [rare, dense] = random_indices(random);
        const auto critical = solution().critical_angle(dense, rare);
        ASSERT_TRUE(critical);
        EXPECT_TRUE(refracted({{std::sin(*critical - 1e-5F), std::cos(*critical - 1e-5F), 0}, {0, 1, 0}, dense, rare}));
        EXPECT_FALSE(
            refracted({{std::sin(*critical + 1e-5F), std::cos(*critical + 1e-5F), 0}, {0, 1, 0}, dense, rare}));
    }
}

TEST_P(ReflectRefractSolution, lengths_do_not_matter)
{
    constexpr std::uint64_t seed = 26004;
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        SurfaceGlance glance = refracted_glance(random);
        const auto t = refracted(glance);
        const glm::vec3 r = solution().mirrored(glance.v, glance.n);
        glance.v *= std::exp2(static_cast<float>(static_cast<int>(random.below(40)) - 20));
        glance.n *= std::exp2(static_cast<float>(static_cast<int>(random.below(40)) - 20));
        EXPECT_EQ(refracted(glance), t) << "seed " << seed << ", glance " << i;
        EXPECT_EQ(solution().mirrored(glance.v, glance.n), r) << "seed " << seed << ", glance " << i;
    }
}

// The header's guarantee.
TEST(ReflectRefractAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 26005;
    const auto& reference = *tests::solution_table<ReflectRefractFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution_table<ReflectRefractFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 50'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", glance " + std::to_string(i));
        const double near = std::pow(10.0, -9 * random.uniform_double());
        SurfaceGlance g =
            i % 2 == 0 ? critical_glance(i % 4 == 0 ? near : -0.1 * near, random) : refracted_glance(random);
        g.v *= std::pow(10.0F, random.uniform(-6, 5));
        g.n *= std::pow(10.0F, random.uniform(-6, 5));
        const auto got = reference.refracted(g.v, g.n, g.outside, g.inside);
        const auto exact = oracle.refracted(g.v, g.n, g.outside, g.inside);
        ASSERT_EQ(got.has_value(), exact.has_value());
        if (got) expect_near(*got, *exact);
        expect_near(reference.mirrored(g.v, g.n), oracle.mirrored(g.v, g.n));
        const auto angle = reference.critical_angle(g.outside, g.inside);
        const auto exact_angle = oracle.critical_angle(g.outside, g.inside);
        ASSERT_EQ(angle.has_value(), exact_angle.has_value());
        if (angle) {
            ASSERT_LE(tests::ulps_between(*angle, *exact_angle), 1);
        }
    }
}

// What the hard checks ask: sin² differs from 1 by 1e-13 or more, and not through rounding.
TEST(ReflectRefractAccuracy, reference_knows_rays_at_the_critical_angle_and_along_the_surface)
{
    constexpr std::uint64_t seed = 26007;
    const auto& reference = *tests::solution_table<ReflectRefractFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution_table<ReflectRefractFunctions>(ORACLE_MODULE);
    Random random(seed);
    int reflected = 0;
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", glance " + std::to_string(i));
        const SurfaceGlance g = i % 2 == 0 ? exactly_critical_glance(random) : grazing_glance(random);
        const auto got = reference.refracted(g.v, g.n, g.outside, g.inside);
        const auto exact = oracle.refracted(g.v, g.n, g.outside, g.inside);
        ASSERT_EQ(got.has_value(), exact.has_value());
        if (got) expect_near(*got, *exact);
        if (i % 2 == 1) continue;
        reflected += got ? 0 : 1;
        if (got) {
            ASSERT_LT(std::abs(dot(glm::dvec3(*got), normalize(glm::dvec3(g.n)))), 1e-4);
        }
    }
    EXPECT_NEAR(reflected, 5000, 300);
}

TEST(ReflectRefractAccuracy, float_fails_near_the_critical_angle)
{
    const auto& in_float = *tests::solution_table<ReflectRefractFunctions>(IN_FLOAT_MODULE);
    const auto& oracle = *tests::solution_table<ReflectRefractFunctions>(ORACLE_MODULE);
    Random random(26006);
    int right = 0;
    for (const SurfaceGlance& g : critical_glances(random, 1000)) {
        const auto got = in_float.refracted(g.v, g.n, g.outside, g.inside);
        const auto exact = oracle.refracted(g.v, g.n, g.outside, g.inside);
        right += got && exact && length(glm::dvec3(*got) - glm::dvec3(*exact)) < 2e-7 ? 1 : 0;
    }
    EXPECT_LT(right, 300) << "of some 667 that come through";
}
