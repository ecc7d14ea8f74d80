#include <gtest/gtest.h>

#include <functional>
#include <raytracing/cylinder-cone/exact.hpp>
#include <raytracing/cylinder-cone/shots.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "cylinder_cone_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

/// Every test here holds for the reference and for the oracle.
class CylinderConeSolution : public testing::TestWithParam<const char*> {
protected:
    const CylinderConeFunctions& solution() const { return *tests::solution_table<CylinderConeFunctions>(GetParam()); }
    std::optional<float> cylinder(const Ray& ray) const { return solution().intersect_cylinder(ray); }
    std::optional<float> cone(const Ray& ray) const { return solution().intersect_cone(ray); }
    std::optional<float> intersect(Quadric quadric, const Ray& ray) const
    {
        return quadric == Quadric::cylinder ? cylinder(ray) : cone(ray);
    }
};
INSTANTIATE_TEST_SUITE_P(Solutions, CylinderConeSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

double field(Quadric quadric, const glm::dvec3& p)
{
    const double radius = quadric == Quadric::cylinder ? 1 : 1 - p.y;
    return p.x * p.x + p.z * p.z - radius * radius;
}

/// Where a ray first crosses the surface, by steps and bisection; NaN where no step sees it change sides.
double bisected(Quadric quadric, const Ray& ray)
{
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const auto at = [&](double t) { return origin + t * direction; };
    constexpr double step = 1.0 / 256;
    for (double t = 0; t < 16; t += step) {
        double low = t;
        double high = t + step;
        const bool side = field(quadric, at(low)) > 0;
        if (side == (field(quadric, at(high)) > 0)) continue;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (side == (field(quadric, at(middle)) > 0) ? low : high) = middle;
        }
        if (at(low).y >= 0 && at(low).y <= 1) return low;
    }
    return not_a_number;
}

}

// The course's own numbers (problem 5.3), whose directions are unit.
TEST_P(CylinderConeSolution, known_answers_of_the_course)
{
    const glm::vec3 down = normalize(glm::vec3(0, -0.8F, -2));
    ASSERT_TRUE(cylinder({{0, 2.1F, 3}, down}));
    EXPECT_NEAR(*cylinder({{0, 2.1F, 3}, down}), 4.3081318, 1e-6) << "through the open top";
    EXPECT_EQ(cylinder({{0.5F, 3, 0}, {0, -1, 0}}), std::nullopt) << "parallel to the axis";
    EXPECT_EQ(cone({{0, 0.5F, 3}, {0, 0, -1}}), 2.5F);
    EXPECT_EQ(cone({{0, 1.5F, 3}, {0, 0, -1}}), std::nullopt) << "the other half";
    EXPECT_EQ(cone({{0.5F, 3, 0}, {0, -1, 0}}), 2.5F);
    ASSERT_TRUE(cone({{0, 1.5F, 2}, normalize(glm::vec3(0, -1, -1))}));
    EXPECT_NEAR(*cone({{0, 1.5F, 2}, normalize(glm::vec3(0, -1, -1))}), 1.7677670, 1e-6) << "a = 0";
}

TEST_P(CylinderConeSolution, fields_are_zero_on_the_surfaces_and_negative_inside)
{
    EXPECT_EQ(solution().cylinder_field({0, 7, 1}), 0.0F);
    EXPECT_EQ(solution().cylinder_field({0.5F, 0, 0}), -0.75F);
    EXPECT_EQ(solution().cylinder_field({2, 0, 1}), 4.0F);
    EXPECT_EQ(solution().cone_field({0, 1, 0}), 0.0F);
    EXPECT_EQ(solution().cone_field({0, 0.25F, 0.75F}), 0.0F);
    EXPECT_EQ(solution().cone_field({0, 3, 2}), 0.0F) << "the other half";
    EXPECT_EQ(solution().cone_field({0, 0, 0}), -1.0F);
    EXPECT_EQ(solution().cone_field({1, 0.5F, 1}), 1.75F);
}

TEST_P(CylinderConeSolution, rims_apex_and_tangents_count)
{
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        Random random(53001);
        const std::vector<Ray> rays = at_the_rims(quadric, random);
        for (std::size_t i = 0; i < rays.size(); i += 2)
            ASSERT_NE(intersect(quadric, rays[i]).has_value(), intersect(quadric, rays[i + 1]).has_value()) << i;
    }
    EXPECT_EQ(cone({{0, 3, 0}, {0, -1, 0}}), 2.0F) << "down the axis";
    EXPECT_EQ(cylinder({{3, 0.5F, 1}, {-1, 0, 0}}), 3.0F) << "touches";
}

TEST_P(CylinderConeSolution, interval_is_open)
{
    const Ray level{{3, 0.5F, 0}, {-1, 0, 0}};
    const auto in = [&](float t_min, float t_max) { return Ray{level.origin, level.direction, t_min, t_max}; };
    EXPECT_EQ(cylinder(in(0, 2)), std::nullopt);
    EXPECT_EQ(cylinder(in(2, 4)), std::nullopt);
    EXPECT_EQ(cylinder(in(2, 5)), 4.0F);
    EXPECT_EQ(cone(in(2.5F, 3.5F)), std::nullopt);
    EXPECT_EQ(cone(in(2.25F, 3.5F)), 2.5F);
    EXPECT_EQ(cone({{3, 0.5F, 0}, {1, 0, 0}, -endless}), -3.5F) << "the smallest t, behind the origin";
}

TEST_P(CylinderConeSolution, nonsense_hits_nothing)
{
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        const Ray good{{3, 0.5F, 0.25F}, {-1, 0, 0}};
        ASSERT_TRUE(intersect(quadric, good));
        for (int axis = 0; axis < 3; ++axis) {
            Ray ray = good;
            ray.origin[axis] = not_a_number;
            EXPECT_EQ(intersect(quadric, ray), std::nullopt);
            ray = good;
            ray.direction[axis] = not_a_number;
            EXPECT_EQ(intersect(quadric, ray), std::nullopt);
        }
        for (const glm::vec3& place : {glm::vec3(1, 0.5F, 0), {0, 1, 0}, {0, 0, 0}, {3, 0.5F, 0}})
            EXPECT_EQ(intersect(quadric, {place, {0, 0, 0}, -endless}), std::nullopt);
        EXPECT_EQ(intersect(quadric, {good.origin, good.direction, not_a_number}), std::nullopt);
        EXPECT_EQ(intersect(quadric, {good.origin, good.direction, 0, not_a_number}), std::nullopt);
    }
    EXPECT_EQ(cylinder({{1, 3, 0}, {0, -1, 0}, -endless}), std::nullopt) << "in the cylinder";
    EXPECT_EQ(cone({{2, 3, 0}, {-1, -1, 0}, -endless}), std::nullopt) << "in the cone";
}

// An answer found in another way: where the field changes its sign.
TEST_P(CylinderConeSolution, agrees_with_bisection)
{
    constexpr std::uint64_t seed = 53002;
    Random random(seed);
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        const std::vector<Ray> rays = random_pairs(quadric, random, 400);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", ray " + std::to_string(i));
            const std::optional<float> got = intersect(quadric, rays[i]);
            const double expected = bisected(quadric, rays[i]);
            ASSERT_EQ(got.has_value(), !std::isnan(expected));
            if (got) {
                ASSERT_NEAR(*got, expected, 1e-6);
            }
        }
    }
}

// The inputs are what their names say.
TEST_P(CylinderConeSolution, pairs_are_a_hit_and_a_miss)
{
    constexpr std::uint64_t seed = 53003;
    Random random(seed);
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        const auto expect_pairs = [&](const std::vector<Ray>& rays, const char* what) {
            for (std::size_t i = 0; i < rays.size(); i += 2)
                ASSERT_NE(intersect(quadric, rays[i]).has_value(), intersect(quadric, rays[i + 1]).has_value())
                    << what << ", seed " << seed << ", pair " << i / 2 << (quadric == Quadric::cone ? ", cone" : "");
        };
        expect_pairs(random_pairs(quadric, random, 3000), "random");
        expect_pairs(open_pairs(quadric, random, 3000), "open ends");
        expect_pairs(parallel(quadric, random), "parallel");
        expect_pairs(at_the_ends(quadric, random), "ends");
        expect_pairs(far_pairs(quadric, random, 1e3, 1000), "far");
        expect_pairs(nearly_parallel_pairs(quadric, random, 1000), "nearly parallel");
    }
    const std::vector<Ray> cylinders = cylinder_by_hand();
    const std::vector<Ray> cones = cone_by_hand();
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        EXPECT_EQ(cylinder(cylinders[i]).has_value(), i % 2 == 0) << i;
        EXPECT_EQ(cone(cones[i]).has_value(), i % 2 == 0) << i;
    }
}

// The header's guarantee.
TEST(CylinderConeAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 53004;
    const auto& reference = *tests::solution_table<CylinderConeFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution_table<CylinderConeFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        const auto intersect = [&](const CylinderConeFunctions& solution, const Ray& ray) {
            return quadric == Quadric::cylinder ? solution.intersect_cylinder(ray) : solution.intersect_cone(ray);
        };
        std::vector<Ray> rays = nearly_parallel_pairs(quadric, random, 10'000);
        for (const double distance : {10.0, 1e3, 1e5}) {
            const std::vector<Ray> more = far_pairs(quadric, random, distance, 10'000);
            rays.insert(rays.end(), more.begin(), more.end());
        }
        for (std::size_t i = 0; i < rays.size(); ++i) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", ray " + std::to_string(i));
            rays[i].direction *= std::pow(10.0F, random.uniform(-6, 6));
            const std::optional<float> got = intersect(reference, rays[i]);
            const std::optional<float> exact = intersect(oracle, rays[i]);
            ASSERT_EQ(got.has_value(), exact.has_value());
            if (got) {
                ASSERT_LE(tests::ulps_between(*got, *exact), 1);
            }
        }
    }
}

TEST(CylinderConeAccuracy, float_fails_from_far_away)
{
    const auto& in_float = *tests::solution_table<CylinderConeFunctions>(IN_FLOAT_MODULE);
    const auto& oracle = *tests::solution_table<CylinderConeFunctions>(ORACLE_MODULE);
    Random random(53005);
    int right = 0;
    for (const Ray& ray : far_pairs(Quadric::cylinder, random, 1e4, 1000)) {
        const std::optional<float> got = in_float.intersect_cylinder(ray);
        const std::optional<float> exact = oracle.intersect_cylinder(ray);
        right += got && exact && tests::ulps_between(*got, *exact) <= 2 ? 1 : 0;
    }
    EXPECT_LT(right, 500) << "of 1000 hits";
}
