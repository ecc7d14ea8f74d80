#include <gtest/gtest.h>

#include <set>
#include <umbral/meshes/sizes.hpp>

using namespace umbral::meshes;

// Problem 2.1: 512 B and 8832 B for k = 16, 128 MB and 35.98 MB for k = 1024.
TEST(RepresentationSize, sphere_of_the_course)
{
    EXPECT_EQ(voxel_bytes(16), 512U);
    EXPECT_EQ(voxel_bytes(1024), std::uint64_t{128} << 20U);
    EXPECT_EQ(voxel_bytes(3), 4U);
    EXPECT_EQ(sphere_mesh_bytes(16), 8832U);
    EXPECT_EQ(sphere_mesh_bytes(1024), 37'724'160U);
    EXPECT_EQ(crossover_resolution(), 288U);
}

// Problems 2.2 and 2.3: 592,908 B and 397,316 B for 128 x 128 cells.
TEST(RepresentationSize, grid_of_the_course)
{
    const GridBytes bytes = grid_bytes(128, 128);
    EXPECT_EQ(bytes.isolated, 1'179'648U);
    EXPECT_EQ(bytes.indexed, 592'908U);
    EXPECT_EQ(bytes.strips, 397'316U);
    EXPECT_EQ(bytes.indexed_strips, 332'816U);
    EXPECT_EQ(grid_work(128, 128).strips, 33'024U);
    const GridCounts counts = grid_counts(8, 4);
    EXPECT_EQ(counts.vertices, 45U);
    EXPECT_EQ(counts.edges, 108U);
    EXPECT_EQ(counts.triangles, 64U);
}

// Against a grid that is really built.
TEST(RepresentationSize, counts_of_a_built_grid)
{
    for (const auto& [columns, rows] : {std::pair{1U, 1U}, {1U, 6U}, {5U, 3U}, {17U, 9U}}) {
        std::set<std::uint32_t> vertices;
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        std::uint64_t triangles = 0;
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column) {
                const auto at = [&](std::uint32_t right, std::uint32_t up) {
                    return (row + up) * 1000 + column + right;
                };
                for (const auto& [a, b, c] :
                     {std::array{at(0, 0), at(1, 0), at(1, 1)}, {at(0, 0), at(1, 1), at(0, 1)}}) {
                    ++triangles;
                    vertices.insert({a, b, c});
                    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
                        edges.insert(std::minmax(from, to));
                }
            }
        const GridCounts counts = grid_counts(columns, rows);
        EXPECT_EQ(counts.vertices, vertices.size());
        EXPECT_EQ(counts.edges, edges.size());
        EXPECT_EQ(counts.triangles, triangles);
    }
}

// The closed form is what a search finds, and nothing smaller does.
TEST(RepresentationSize, crossover_is_the_first)
{
    for (const std::uint64_t vertex : {1U, 2U, 12U, 44U, 300U})
        for (const std::uint64_t index : {1U, 2U, 4U, 8U, 97U}) {
            const EntryBytes bytes{vertex, index, 8};
            std::uint64_t k = 2;
            while (sphere_mesh_bytes(k, bytes) >= voxel_bytes(k)) ++k;
            EXPECT_EQ(crossover_resolution(bytes), k) << vertex << ' ' << index;
            EXPECT_LT(sphere_mesh_bytes(k + 1, bytes), voxel_bytes(k + 1));
        }
}
