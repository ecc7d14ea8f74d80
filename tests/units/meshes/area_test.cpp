#include <gtest/gtest.h>

#include <limits>
#include <meshes/area/large_meshes.hpp>
#include <meshes/zoo.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "area_table.hpp"

using namespace umbral;
using namespace umbral::meshes;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class AreaSolution : public testing::TestWithParam<const char*> {
protected:
    const tests::Areas areas = *tests::solution<const tests::Areas>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, AreaSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

TEST_P(AreaSolution, worked_by_hand)
{
    EXPECT_EQ(areas.triangle({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 6);
    EXPECT_EQ(areas.triangle({1, 1, 1}, {1, 1, 6}, {1, 3, 1}), 5);
    EXPECT_EQ(areas.triangle({0, 0, 0}, {1, 2, 2}, {2, 4, 4}), 0) << "on one line";
    EXPECT_EQ(areas.mesh(cube_surface({{0, 0, 0}})), 6);
    EXPECT_EQ(areas.mesh(flat_sheet(8, 4)), 4);
    EXPECT_EQ(areas.mesh({}), 0);
    EXPECT_FLOAT_EQ(areas.mesh(tetrahedron()), static_cast<float>(8 * std::sqrt(3.0)));
    IndexedMesh example{
        {{0, 0, 0}, {0, 0, 2}, {0, 1.3F, 1}, {0, 1.4F, 0}, {1.1F, 0, 0}, {1, 0, 2}, {1, 0.8F, 1.5F}, {0.5F, 1, 0}}, {}};
    for (const glm::uvec4& side :
         {glm::uvec4(0, 1, 2, 3), {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
        add_quad(example, side);
    EXPECT_NEAR(areas.mesh(example), 9.086904, 1e-6) << "the PLY example of the statement";
    EXPECT_FLOAT_EQ(areas.mesh(octahedron()), static_cast<float>(4 * std::sqrt(3.0)));
}

TEST_P(AreaSolution, broken_corners_count_as_nothing)
{
    for (const float broken : {not_a_number, infinity, -infinity}) {
        const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, broken, 1}}, {{0, 1, 2}, {1, 2, 3}, {3, 0, 1}}};
        EXPECT_EQ(areas.triangle(mesh.positions[1], mesh.positions[2], mesh.positions[3]), 0);
        EXPECT_EQ(areas.mesh(mesh), 0.5F);
    }
}

// A power of two times the size is the square of it times the area, exactly.
TEST_P(AreaSolution, scales_with_the_square)
{
    Random random(20601);
    const IndexedMesh mesh = hills(6, 6, random);
    for (const int exponent : {-55, -30, 30, 55}) {
        const IndexedMesh scaled =
            mapped(mesh, [&](const glm::vec3& p) { return glm::vec3(ldexp(glm::dvec3(p), glm::ivec3(exponent))); });
        EXPECT_EQ(areas.mesh(scaled), std::ldexp(areas.mesh(mesh), 2 * exponent)) << "2^" << exponent;
    }
}

// Areas that calculus knows, approached by the square of the size of a triangle.
TEST_P(AreaSolution, approaches_the_sphere_and_the_torus)
{
    EXPECT_NEAR(areas.mesh(ball(400, 200)), 12.566370614, 1.5e-3);
    EXPECT_NEAR(areas.mesh(torus(300, 300, 1, 0.5F)), 19.739208802, 2e-3);
}

TEST(AreaAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20602;
    const auto reference = *tests::solution<const tests::Areas>(REFERENCE_MODULE);
    const auto oracle = *tests::solution<const tests::Areas>(ORACLE_MODULE);
    Random random(seed);
    for (const double sine : {1.0, 1e-2, 1e-4, 1e-6}) {
        const IndexedMesh slivers = sliver_triangles(sine, 5000, random);
        for (const glm::uvec3& t : slivers.triangles) {
            const auto area = [&](const tests::Areas& solution) {
                return solution.triangle(slivers.positions[t.x], slivers.positions[t.y], slivers.positions[t.z]);
            };
            ASSERT_LE(tests::ulps_between(area(reference), area(oracle)), 1) << "seed " << seed << ", sine " << sine;
        }
    }
    for (const IndexedMesh& mesh : {torus(700, 400), sheet_after_a_square(300), sheet_of_all_sizes(300, random)})
        EXPECT_LE(tests::ulps_between(reference.mesh(mesh), oracle.mesh(mesh)), 1) << "seed " << seed;
}

// The hard cases must tell the forms apart.
TEST(AreaAccuracy, others_fail)
{
    const auto naive = *tests::solution<const tests::Areas>(IN_FLOAT_MODULE);
    const auto heron = *tests::solution<const tests::Areas>(HERON_MODULE);
    const auto oracle = *tests::solution<const tests::Areas>(ORACLE_MODULE);
    Random random(20603);
    const IndexedMesh slivers = sliver_triangles(1e-6, 1000, random);
    EXPECT_GT(tests::ulps_between(naive.mesh(slivers), oracle.mesh(slivers)), 1000);
    double worst = 0;
    for (const glm::uvec3& t : slivers.triangles) {
        const auto area = [&](const tests::Areas& solution) {
            return solution.triangle(slivers.positions[t.x], slivers.positions[t.y], slivers.positions[t.z]);
        };
        worst = std::max(worst, tests::ulps_between(area(heron), area(oracle)));
    }
    EXPECT_GT(worst, 100);
    EXPECT_GT(tests::ulps_between(naive.mesh(torus(700, 700)), oracle.mesh(torus(700, 700))), 10);
}
