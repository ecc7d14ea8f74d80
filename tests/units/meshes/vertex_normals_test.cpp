#include <gtest/gtest.h>

#include <limits>
#include <meshes/support.hpp>

#include "../solution.hpp"
#include "vertex_normals_table.hpp"

using namespace umbral;
using namespace umbral::meshes;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr glm::vec3 zero(0);

/// Every test here holds for the reference and for the oracle.
class NormalsSolution : public testing::TestWithParam<const char*> {
protected:
    const tests::Normals normals = *tests::solution<const tests::Normals>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, NormalsSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::vec3& got, const glm::dvec3& exact, double tolerance = 6.1e-8)
{
    EXPECT_LE(length(glm::dvec3(got) - exact), tolerance)
        << got.x << ' ' << got.y << ' ' << got.z << ", expected " << exact.x << ' ' << exact.y << ' ' << exact.z;
}

double signed_volume(const IndexedMesh& mesh)
{
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += dot(glm::dvec3(mesh.positions[t.x]),
                      cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
                  6;
    return volume;
}

double worst_difference(const std::vector<glm::vec3>& got, const std::vector<glm::vec3>& exact)
{
    EXPECT_EQ(got.size(), exact.size());
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst,
                             std::isfinite(got[i][c]) ? std::abs(double{got[i][c]} - double{exact[i][c]}) : HUGE_VAL);
    return worst;
}

}

// Worked by hand: the corner at the origin of a tetrahedron sees three faces in the planes of coordinates; the one at
// (1,0,0) two of them and the slanted face (1,1,1)/√3, whose area is √3 times theirs. Unweighted, its sum is (0,-1,0) +
// (0,0,-1) + (1,1,1)/√3.
TEST_P(NormalsSolution, known_answers)
{
    const IndexedMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    const double third = 1 / std::sqrt(3.0);
    const std::vector<glm::vec3> faces = normals.faces(tetrahedron);
    ASSERT_EQ(faces.size(), 4U);
    EXPECT_EQ(faces[0], glm::vec3(0, 0, -1));
    EXPECT_EQ(faces[1], glm::vec3(0, -1, 0));
    EXPECT_EQ(faces[2], glm::vec3(-1, 0, 0));
    expect_near(faces[3], glm::dvec3(third));
    const std::vector<glm::vec3> vertices = normals.vertices(tetrahedron);
    ASSERT_EQ(vertices.size(), 4U);
    expect_near(vertices[0], glm::dvec3(-third));
    expect_near(vertices[1], normalize(glm::dvec3(third, third - 1, third - 1)));
}

// The pyramid of the statement.
TEST_P(NormalsSolution, worked_number_of_the_statement)
{
    const IndexedMesh roof{{{0, 0, 0}, {4, 0, 0}, {4, 0, -3}, {0, 2, 0}}, {{0, 1, 3}, {0, 2, 1}}};
    const std::vector<glm::vec3> faces = normals.faces(roof);
    EXPECT_EQ(faces[0], glm::vec3(0, 0, 1)) << "area 4";
    EXPECT_EQ(faces[1], glm::vec3(0, -1, 0)) << "area 6";
    const std::vector<glm::vec3> vertices = normals.vertices(roof);
    expect_near(vertices[0], {0, -std::sqrt(0.5), std::sqrt(0.5)});
    EXPECT_EQ(vertices[2], glm::vec3(0, -1, 0));
    EXPECT_EQ(vertices[3], glm::vec3(0, 0, 1));
}

TEST_P(NormalsSolution, degenerate_triangles_count_as_zero)
{
    const IndexedMesh mesh{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}},
                           {{0, 1, 2}, {0, 4, 3}, {0, 0, 3}, {3, 3, 3}, {0, 3, 5}}};
    const std::vector<glm::vec3> faces = normals.faces(mesh);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(faces[static_cast<std::size_t>(i)], zero) << i;
    const std::vector<glm::vec3> vertices = normals.vertices(mesh);
    EXPECT_EQ(vertices[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(vertices[1], zero);
    EXPECT_EQ(vertices[4], zero);
}

TEST_P(NormalsSolution, broken_vertices_spoil_their_triangles_only)
{
    for (const float broken : {not_a_number, infinity, -infinity}) {
        const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, broken, 1}}, {{0, 1, 2}, {1, 2, 3}, {3, 0, 1}}};
        EXPECT_EQ(normals.faces(mesh), (std::vector<glm::vec3>{{0, 0, 1}, zero, zero}));
        EXPECT_EQ(normals.vertices(mesh), (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, zero}));
    }
}

TEST_P(NormalsSolution, nothing_gives_nothing)
{
    EXPECT_TRUE(normals.faces({}).empty());
    EXPECT_TRUE(normals.vertices({}).empty());
    EXPECT_EQ(normals.vertices({{{1, 2, 3}, {4, 5, 6}}, {}}), (std::vector<glm::vec3>(2, zero)));
}

TEST_P(NormalsSolution, opposite_sides_cancel)
{
    Random random(20261);
    IndexedMesh mesh = hills(7, 7, random);
    const std::vector<glm::uvec3> front = mesh.triangles;
    for (const glm::uvec3& t : front) mesh.triangles.emplace_back(t.z, t.y, t.x);
    EXPECT_EQ(normals.vertices(mesh), (std::vector<glm::vec3>(mesh.positions.size(), zero)));
}

// Any scale that keeps the coordinates floats gives the same normals; powers of two, so that the scaled mesh is exactly
// the same.
TEST_P(NormalsSolution, scale_does_not_count)
{
    Random random(20262);
    const IndexedMesh mesh =
        mapped(hills(6, 6, random), [](const glm::vec3& position) { return round(64.0F * position) / 64.0F; });
    const std::vector<glm::vec3> faces = normals.faces(mesh);
    const std::vector<glm::vec3> vertices = normals.vertices(mesh);
    for (const int exponent : {-140, -100, -20, 20, 100, 120}) {
        const IndexedMesh scaled = mapped(mesh, [&](const glm::vec3& position) {
            return glm::vec3(ldexp(glm::dvec3(position), glm::ivec3(exponent)));
        });
        EXPECT_EQ(normals.faces(scaled), faces) << "2^" << exponent;
        EXPECT_EQ(normals.vertices(scaled), vertices) << "2^" << exponent;
    }
}

// The knot is closed: normals point out of it, and those of its vertices lie near the exact ones of the tube.
TEST_P(NormalsSolution, knot_looks_outwards)
{
    const IndexedMesh knot = trefoil(300, 24, 0.4);
    EXPECT_GT(signed_volume(knot), 1);
    const std::vector<glm::vec3> vertices = normals.vertices(knot);
    for (std::size_t ring = 0; ring < 300; ++ring) {
        glm::vec3 centre(0);
        for (std::size_t i = 0; i < 24; ++i) centre += knot.positions[24 * ring + i] / 24.0F;
        for (std::size_t i = 24 * ring; i < 24 * ring + 24; ++i)
            ASSERT_GT(dot(vertices[i], normalize(knot.positions[i] - centre)), 0.995F);
    }
}

// The header's guarantee on slivers, folds and mixed sizes.
TEST(NormalsAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20263;
    const auto reference = *tests::solution<const tests::Normals>(REFERENCE_MODULE);
    const auto oracle = *tests::solution<const tests::Normals>(ORACLE_MODULE);
    Random random(seed);
    for (const double sine : {1.0, 1e-2, 1e-4, 1e-6, 1e-7}) {
        const IndexedMesh slivers = sliver_triangles(sine, 5000, random);
        EXPECT_LE(worst_difference(reference.faces(slivers), oracle.faces(slivers)), 6e-8)
            << "seed " << seed << ", sine " << sine;
        const IndexedMesh folds = sharp_folds(std::max(sine, 1e-5), 5000, random);
        EXPECT_LE(worst_difference(reference.vertices(folds), oracle.vertices(folds)), 6e-8)
            << "seed " << seed << ", angle " << sine;
    }
    // Corners of sizes from 1e-4 to 1e4 in one triangle.
    IndexedMesh mixed;
    const auto corner = [&] { return std::pow(10.0F, random.uniform(-4, 4)) * random.unit_vector(); };
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 a = corner();
        const glm::vec3 b = corner();
        add_triangle(mixed, a, b, corner());
    }
    EXPECT_LE(worst_difference(reference.faces(mixed), oracle.faces(mixed)), 6e-8) << "seed " << seed;
}

// The hard cases must tell the forms apart.
TEST(NormalsAccuracy, float_fails_on_slivers_and_folds)
{
    const auto naive = *tests::solution<const tests::Normals>(IN_FLOAT_MODULE);
    const auto oracle = *tests::solution<const tests::Normals>(ORACLE_MODULE);
    Random random(20264);
    const IndexedMesh slivers = sliver_triangles(1e-4, 1000, random);
    EXPECT_GT(worst_difference(naive.faces(slivers), oracle.faces(slivers)), 1e-4);
    const IndexedMesh folds = sharp_folds(1e-4, 1000, random);
    EXPECT_GT(worst_difference(naive.vertices(folds), oracle.vertices(folds)), 1e-4);
    const IndexedMesh tiny = mapped(hills(3, 3, random), [](const glm::vec3& position) { return 1e-30F * position; });
    EXPECT_GT(worst_difference(naive.faces(tiny), oracle.faces(tiny)), 0.1);
}
