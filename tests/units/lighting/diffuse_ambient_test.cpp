#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <lighting/random.hpp>
#include <vector>

#include "../solution.hpp"
#include "diffuse_ambient_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// Every test here holds for the reference and for the oracle.
class DiffuseSolution : public testing::TestWithParam<const char*> {
protected:
    const DiffuseAmbient& unit = *tests::solution<DiffuseAmbient>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, DiffuseSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::vec3& got, const glm::vec3& expected, float tolerance, const char* what)
{
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], tolerance) << what << ", channel " << i;
}

}

// The statement's numbers.
TEST_P(DiffuseSolution, known_answers)
{
    const Material material{{0.125F, 0, 0.25F}, {0.25F, 0.5F, 0.125F}, {0.5F, 0.25F, 1}};
    const SurfacePoint at{{0, 0, 1}, {0, 0, 1}};
    const std::vector<Light> sun = {{{0, 0.6F, 0.8F, 0}, {1, 0.5F, 2}}};
    expect_near(unit.matt_reflection(at, material, sun, glm::vec3(0.2F)), {0.825F, 0.45F, 2.125F}, 2e-7F, "sun");
    expect_near(unit.matt_reflection(at, material, {}, glm::vec3(0.2F)), {0.175F, 0.1F, 0.275F}, 2e-7F, "no light");
    EXPECT_EQ(unit.direction_to_light({{4, 5, 2, 1}}, {1, 1, 2}), glm::vec3(0.6F, 0.8F, 0));
    EXPECT_EQ(unit.direction_to_light({{3, 0, 4, 0}}, {7, -2, 1}), glm::vec3(0.6F, 0, 0.8F));
}

// Problem 3.9 of the course: the unit sphere, a lamp at (0, 2, 0). A purely diffuse sphere is brightest at (0, 1, 0),
// where its light is 1, and falls with the cosine from there; below the lamp's horizon it is dark.
TEST_P(DiffuseSolution, sphere_of_problem_3_9)
{
    const Material white{{}, {}, glm::vec3(1)};
    const std::vector<Light> lamp = {{{0, 2, 0, 1}}};
    const auto at = [&](double polar) {
        const glm::vec3 place(std::sin(polar), std::cos(polar), 0);
        return unit.matt_reflection({place, place}, white, lamp, glm::vec3(0)).x;
    };
    EXPECT_EQ(at(0), 1);
    for (int i = 1; i < 100; ++i) EXPECT_LT(at(0.01 * i), at(0.01 * (i - 1)));
    EXPECT_NEAR(at(glm::radians(30.0)), 0.5907, 5e-5) << "the brightest point that the observer at (2, 0, 0) sees";
    EXPECT_NEAR(at(glm::radians(60.0)), 0, 1e-6) << "the lamp's horizon";
    EXPECT_EQ(at(glm::radians(61.0)), 0);
}

// What does not change the light: the distance of a lamp, the length of a normal, a turn of everything.
TEST_P(DiffuseSolution, invariances)
{
    constexpr std::uint64_t seed = 20421;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const SurfacePoint at{3.0F * random.in_cube(), random.unit_vector()};
        const Material material = random_material(random);
        std::vector<Light> lights = {random_light(random, at, 0.1F)};
        const glm::vec3 ambient = random_color(random);
        const glm::vec3 here = unit.matt_reflection(at, material, lights, ambient);
        SurfacePoint longer = at;
        longer.normal *= 8.0F;
        expect_near(unit.matt_reflection(longer, material, lights, ambient), here, 2e-6F, "a longer normal");
        const glm::vec3 l = unit.direction_to_light(lights[0], at.position);
        ASSERT_NEAR(length(l), 1, 2e-7) << "seed " << seed;
        lights[0].position = glm::vec4(16.0F * l, 0);
        expect_near(unit.matt_reflection(at, material, lights, ambient), here, 5e-6F, "a direction for a place");
    }
}

TEST_P(DiffuseSolution, without_a_direction_only_ambient_light_is_left)
{
    const Material material{glm::vec3(0.5F), glm::vec3(0.25F), glm::vec3(1)};
    const std::vector<Light> inside = {{{1, 2, 3, 1}, glm::vec3(2)}};
    const std::vector<Light> nowhere = {{{0, 0, 0, 0}, glm::vec3(2)}};
    EXPECT_EQ(unit.direction_to_light(inside[0], {1, 2, 3}), glm::vec3(0));
    EXPECT_EQ(unit.direction_to_light(nowhere[0], {1, 2, 3}), glm::vec3(0));
    EXPECT_EQ(unit.matt_reflection({{1, 2, 3}, {0, 1, 0}}, material, inside, glm::vec3(1)), glm::vec3(1.25F));
    EXPECT_EQ(unit.matt_reflection({{1, 2, 3}, {0, 1, 0}}, material, nowhere, glm::vec3(1)), glm::vec3(1.25F));
    EXPECT_EQ(unit.matt_reflection({{5, 5, 5}, {0, 0, 0}}, material, inside, glm::vec3(1)), glm::vec3(1.25F));
}

TEST_P(DiffuseSolution, lengths_of_all_sizes)
{
    constexpr std::uint64_t seed = 20422;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const float size = std::pow(10.0F, random.uniform(-37, 37));
        const glm::vec3 way = random.unit_vector();
        expect_near(unit.direction_to_light({glm::vec4(size * way, 0)}, {}), way, 2e-7F, "a direction");
        expect_near(unit.direction_to_light({glm::vec4(size * way, 1)}, {}), way, 2e-7F, "a place");
    }
}

// The header's guarantees, with all terms of the sum at work and light that may graze.
TEST(DiffuseReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20423;
    const auto& reference = *tests::solution<DiffuseAmbient>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<DiffuseAmbient>(ORACLE_MODULE);
    const auto& in_float = *tests::solution<DiffuseAmbient>(IN_FLOAT_MODULE);
    Random random(seed);
    int wrong_in_float = 0;
    for (int i = 0; i < 50'000; ++i) {
        const SurfacePoint at{100.0F * random.in_cube(), random.unit_vector()};
        Material material = random_material(random);
        if (i % 2 == 0) material = {{}, {}, material.diffuse};
        const glm::vec3 n = at.normal;
        const glm::vec3 aside = normalize(cross(n, random.unit_vector()));
        const std::vector<Light> lights = {
            light_towards(at, aside + std::pow(10.0F, random.uniform(-5, 0)) * n, true, random.uniform(10, 100))};
        const glm::vec3 got = reference.matt_reflection(at, material, lights, glm::vec3(0));
        const glm::vec3 exact = oracle.matt_reflection(at, material, lights, glm::vec3(0));
        const glm::vec3 rough = in_float.matt_reflection(at, material, lights, glm::vec3(0));
        for (int k = 0; k < 3; ++k)
            ASSERT_LE(std::abs(got[k] - exact[k]), 2e-7F * exact[k]) << "seed " << seed << ", case " << i;
        wrong_in_float += std::abs(rough.x - exact.x) > 1e-6F * exact.x ? 1 : 0;
    }
    EXPECT_GT(wrong_in_float, 10'000) << "the hard cases tell them apart";
}
