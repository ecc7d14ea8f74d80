#include <gtest/gtest.h>

#include <meshes/edge-table/wireframe.hpp>
#include <meshes/zoo.hpp>
#include <set>
#include <umbral/meshes/edges.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// All pairs of vertices that some triangle has, in order.
std::vector<Pair> edges_by_definition(const IndexedMesh& mesh)
{
    std::set<Pair> edges;
    for (const glm::uvec3& t : mesh.triangles)
        if (t.x != t.y && t.y != t.z && t.x != t.z)
            for (const auto& [a, b] : {Pair{t.x, t.y}, {t.y, t.z}, {t.z, t.x}})
                edges.insert({std::min(a, b), std::max(a, b)});
    return {edges.begin(), edges.end()};
}

std::vector<Pair> in_order(const std::vector<glm::uvec2>& edges, const IndexedMesh& mesh)
{
    std::vector<Pair> pairs;
    for (const glm::uvec2& edge : canonical(edges, mesh)) pairs.emplace_back(edge.x, edge.y);
    return pairs;
}

}

TEST(EdgeTable, has_every_edge_once)
{
    constexpr std::uint64_t seed = 20501;
    Random random(seed);
    for (const auto& meshes : {tame_meshes(), wild_meshes()}) {
        for (const auto& [name, mesh] : meshes) {
            const IndexedMesh mixed = with_mixed_winding(shuffled(mesh, random), random);
            EXPECT_EQ(in_order(edge_table(mixed), mixed), edges_by_definition(mixed)) << name << ", seed " << seed;
        }
    }
    for (int i = 0; i < 300; ++i) {
        const std::uint32_t count = 1 + random.below(12);
        IndexedMesh mesh{std::vector<glm::vec3>(count), {}};
        for (std::uint32_t k = random.below(15); k > 0; --k) {
            const std::uint32_t a = random.below(count);
            const std::uint32_t b = random.below(count);
            mesh.triangles.emplace_back(a, b, random.below(count));
        }
        ASSERT_EQ(in_order(edge_table(mesh), mesh), edges_by_definition(mesh)) << "seed " << seed << ", table " << i;
    }
}

TEST(EdgeTable, closed_meshes_need_no_search)
{
    Random random(20502);
    for (const IndexedMesh& mesh : {tetrahedron(), cube(), ball(9, 6), torus(8, 6), plate_with_holes(3),
                                    cubes_at_a_corner(), trefoil(30, 7, 0.4)}) {
        const IndexedMesh any_order = shuffled(mesh, random);
        const std::vector<glm::uvec2> edges = edge_table_of_closed(any_order);
        EXPECT_EQ(2 * edges.size(), 3 * mesh.triangles.size());
        EXPECT_EQ(in_order(edges, any_order), edges_by_definition(any_order));
    }
}

// One vertex with 20,000 edges: lists that are searched would need 200 million steps.
TEST(EdgeTable, vertex_of_many_edges)
{
    const IndexedMesh mesh = disc(20'000);
    EXPECT_EQ(edge_table(mesh).size(), 40'000U);
    const IndexedMesh cones = cones_with_large_indices(60);
    EXPECT_EQ(in_order(edge_table(cones), cones), edges_by_definition(cones));
}
