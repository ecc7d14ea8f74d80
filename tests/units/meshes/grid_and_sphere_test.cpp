#include <gtest/gtest.h>

#include <bit>
#include <numbers>
#include <umbral/meshes/builders.hpp>

using namespace umbral::meshes;

namespace {

double signed_volume(const IndexedMesh& mesh)
{
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += dot(glm::dvec3(mesh.positions.at(t.x)),
                      cross(glm::dvec3(mesh.positions.at(t.y)), glm::dvec3(mesh.positions.at(t.z)))) /
                  6;
    return volume;
}

std::size_t filled(const std::vector<std::uint8_t>& bytes)
{
    std::size_t count = 0;
    for (const std::uint8_t byte : bytes) count += static_cast<std::size_t>(std::popcount(byte));
    return count;
}

}

TEST(GridAndSphere, worked_numbers_of_the_statement)
{
    EXPECT_EQ(make_grid(1, 1).triangles, (std::vector<glm::uvec3>{{0, 1, 3}, {0, 3, 2}}));
    const IndexedMesh octahedron = make_sphere(4, 2);
    EXPECT_EQ(octahedron.positions.size(), 6U);
    EXPECT_EQ(octahedron.triangles.size(), 8U);
    EXPECT_NEAR(signed_volume(octahedron), 1.0 / 6, 1e-7);
}

// Problem 2.2: 45 vertices and 64 faces of 8 x 4 cells; the whole square, all of it facing +z.
TEST(GridAndSphere, grid_covers_the_square)
{
    const IndexedMesh grid = make_grid(8, 4);
    ASSERT_EQ(grid.positions.size(), 45U);
    ASSERT_EQ(grid.triangles.size(), 64U);
    for (const glm::uvec3& t : grid.triangles) {
        const glm::vec3 normal =
            cross(grid.positions[t.y] - grid.positions[t.x], grid.positions[t.z] - grid.positions[t.x]);
        EXPECT_EQ(normal, glm::vec3(0, 0, 1.0F / 32)) << t.x << ' ' << t.y << ' ' << t.z;
    }
}

// Every edge is walked once in each direction: closed, and one orientation. V - E + F = 2. Volume within O(1/k²) of the
// ball's: outside is outside.
TEST(GridAndSphere, sphere_is_closed_and_looks_outwards)
{
    for (const auto& [slices, stacks] : {std::pair{3U, 2U}, {4U, 3U}, {7U, 9U}, {64U, 64U}}) {
        const IndexedMesh sphere = make_sphere(slices, stacks);
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const glm::uvec3& t : sphere.triangles)
            for (int i = 0; i < 3; ++i) EXPECT_TRUE(edges.emplace(t[i], t[(i + 1) % 3]).second);
        for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
        EXPECT_EQ(sphere.positions.size() + sphere.triangles.size(), edges.size() / 2 + 2);
    }
    EXPECT_NEAR(signed_volume(make_sphere(64, 64)) / (std::numbers::pi / 6), 1 - 0.002207, 1e-6);
}

TEST(GridAndSphere, nothing_from_too_little)
{
    for (const IndexedMesh& mesh :
         {make_grid(0, 3), make_grid(3, 0), make_sphere(2, 5), make_sphere(5, 1), make_sphere(0, 0)}) {
        EXPECT_TRUE(mesh.positions.empty());
        EXPECT_TRUE(mesh.triangles.empty());
    }
}

// The header's guarantee: the formula, with 64 bits.
TEST(GridAndSphere, positions_are_rounded_once)
{
    const std::uint32_t slices = 5000;
    const std::uint32_t stacks = 21;
    const IndexedMesh sphere = make_sphere(slices, stacks);
    constexpr auto pi = std::numbers::pi_v<long double>;
    double worst = 0;
    for (std::uint32_t i = 0; i < slices * (stacks - 1); ++i) {
        const long double latitude = pi * static_cast<long double>(1 + i / slices) / stacks;
        const long double longitude = 2 * pi * (static_cast<long double>(i % slices) / slices);
        const glm::dvec3 exact(std::sin(latitude) * std::sin(longitude) / 2, std::cos(latitude) / 2,
                               std::sin(latitude) * std::cos(longitude) / 2);
        for (int axis = 0; axis < 3; ++axis)
            worst = std::max(worst, std::abs(double{sphere.positions[i + 1][axis]} - exact[axis]));
    }
    EXPECT_LT(worst, 1.6e-8);
    const IndexedMesh grid = make_grid(1000, 1);
    for (std::uint32_t i = 0; i <= 1000; ++i) ASSERT_EQ(grid.positions[i].x, static_cast<float>(i) / 1000.0F);
}

// Counts that an independent program found in double.
TEST(GridAndSphere, voxel_counts)
{
    for (const auto& [k, count] :
         {std::pair{8U, 280U}, {16U, 2176U}, {32U, 17'256U}, {64U, 137'376U}, {128U, 1'099'136U}}) {
        const std::vector<std::uint8_t> bytes = make_voxel_sphere(k);
        EXPECT_EQ(bytes.size(), k * k * k / 8);
        EXPECT_EQ(filled(bytes), count);
    }
    EXPECT_EQ(make_voxel_sphere(1), std::vector<std::uint8_t>{1});
    EXPECT_EQ(make_voxel_sphere(3).size(), 4U);
}

// The largest cube: 3 (2^30)² has 62 bits. Along an axis through the middle the ball ends with its cube.
TEST(GridAndSphere, voxels_of_the_largest_cube)
{
    const std::uint32_t k = 1U << 30U;
    EXPECT_FALSE(voxel_is_inside(k, {0, 0, 0}));
    EXPECT_FALSE(voxel_is_inside(k, {k - 1, k - 1, k - 1}));
    EXPECT_TRUE(voxel_is_inside(k, {k / 2, k / 2, k / 2}));
    // (2x + 1 - k)² + 1 + 1 <= k² holds for the outermost cell of the middle row, since (k - 1)² + 2 < k².
    EXPECT_TRUE(voxel_is_inside(k, {k - 1, k / 2, k / 2}));
}

// The statement's tables: what adding up steps costs, and how much of the ball's volume meshes and voxels have.
TEST(GridAndSphere, errors_of_the_statement)
{
    struct Column {
        int count;
        double grid, sphere;
    };
    for (const auto& [count, grid, sphere] :
         {Column{10, 1e-7, 3e-7}, {100, 7e-7, 1e-6}, {1000, 9e-6, 3e-5}, {10'000, 5e-5, 2e-4}, {100'000, 1e-3, 4e-3}}) {
        const float angle_step = 2 * std::numbers::pi_v<float> / static_cast<float>(count);
        float x = 0;
        float angle = 0;
        glm::dvec2 worst(0);
        for (int i = 0; i <= count; ++i) {
            const double share = i / static_cast<double>(count);
            const glm::dvec2 error(double{x} - share,
                                   double{0.5F * std::sin(angle)} - 0.5 * std::sin(2 * std::numbers::pi * share));
            worst = max(worst, abs(error));
            x += 1 / static_cast<float>(count);
            angle += angle_step;
        }
        EXPECT_NEAR(worst.x, grid, 0.25 * grid) << count;
        EXPECT_NEAR(worst.y, sphere, 0.25 * sphere) << count;
    }
}

TEST(GridAndSphere, volumes_of_the_statement)
{
    struct Column {
        std::uint32_t k;
        double voxels, mesh;
    };
    for (const auto& [k, voxels, mesh] : {Column{8, 4.4, -13},
                                          {16, 1.5, -3.5},
                                          {32, 0.58, -0.88},
                                          {64, 0.086, -0.22},
                                          {128, 0.097, -0.055},
                                          {256, -0.008, -0.014}}) {
        const double ball = std::numbers::pi / 6;
        const double cubes = static_cast<double>(filled(make_voxel_sphere(k))) / (double(k) * k * k);
        EXPECT_NEAR(100 * (cubes / ball - 1), voxels, std::max(0.0005, 0.06 * std::abs(voxels)));
        EXPECT_NEAR(100 * (signed_volume(make_sphere(k, k)) / ball - 1), mesh, 0.05 * std::abs(mesh));
    }
}
