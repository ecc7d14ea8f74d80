#include <gtest/gtest.h>

#include <map>
#include <meshes/zoo.hpp>
#include <set>
#include <umbral/meshes/euler.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The smallest label spreads over the edges until nothing changes: slow, and short enough to be believed.
int count_pieces(const std::set<Edge>& edges)
{
    std::map<std::uint32_t, std::uint32_t> label;
    for (const auto& [a, b] : edges) label[a] = a, label[b] = b;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, b] : edges) {
            const std::uint32_t least = std::min(label[a], label[b]);
            changed = changed || label[a] != least || label[b] != least;
            label[a] = label[b] = least;
        }
    }
    std::set<std::uint32_t> labels;
    for (const auto& [vertex, least] : label) labels.insert(least);
    return static_cast<int>(labels.size());
}

TopologyCounts counted_by_definition(const IndexedMesh& mesh)
{
    TopologyCounts counts{};
    std::set<std::uint32_t> vertices;
    std::multiset<Edge> sides;
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x == t.y || t.y == t.z || t.x == t.z) continue;
        ++counts.faces;
        vertices.insert({t.x, t.y, t.z});
        for (const auto& [a, b] : {Edge{t.x, t.y}, {t.y, t.z}, {t.z, t.x}})
            sides.insert({std::min(a, b), std::max(a, b)});
    }
    const std::set<Edge> edges(sides.begin(), sides.end());
    std::set<Edge> boundary;
    for (const Edge& edge : edges) {
        if (sides.count(edge) == 1) boundary.insert(edge);
        if (sides.count(edge) > 2) ++counts.non_manifold_edges;
    }
    counts.vertices = static_cast<int>(vertices.size());
    counts.isolated_vertices = static_cast<int>(mesh.positions.size() - vertices.size());
    counts.edges = static_cast<int>(edges.size());
    counts.boundary_edges = static_cast<int>(boundary.size());
    counts.boundary_loops = count_pieces(boundary);
    counts.components = count_pieces(edges);
    return counts;
}

}

TEST(EulerCounts, agrees_with_the_definition_on_the_zoo)
{
    constexpr std::uint64_t seed = 20401;
    Random random(seed);
    for (const auto& meshes : {tame_meshes(), wild_meshes()}) {
        for (const auto& [name, mesh] : meshes) {
            const TopologyCounts expected = counted_by_definition(mesh);
            EXPECT_EQ(count_topology(mesh), expected) << name;
            EXPECT_EQ(count_topology(with_mixed_winding(shuffled(mesh, random), random)), expected)
                << name << ", seed " << seed;
        }
    }
}

// Tables of random numbers are no surfaces, but they can be counted.
TEST(EulerCounts, agrees_with_the_definition_on_random_tables)
{
    constexpr std::uint64_t seed = 20402;
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const std::uint32_t count = 3 + random.below(12);
        IndexedMesh mesh{std::vector<glm::vec3>(count), {}};
        for (std::uint32_t k = random.below(15); k > 0; --k) {
            const std::uint32_t a = random.below(count);
            const std::uint32_t b = random.below(count);
            mesh.triangles.emplace_back(a, b, random.below(count));
        }
        ASSERT_EQ(count_topology(mesh), counted_by_definition(mesh)) << "seed " << seed << ", table " << i;
    }
}

TEST(EulerCounts, known_genera)
{
    const std::map<std::string, int> handles = {
        {"torus", 1}, {"plate with two holes", 2}, {"plate with three holes", 3}};
    Random random(20403);
    for (const auto& [name, mesh] : tame_meshes()) {
        const auto found = handles.find(name);
        const int expected = found == handles.end() ? 0 : found->second;
        EXPECT_EQ(genus(mesh), expected) << name;
        EXPECT_EQ(genus(shuffled(with_lonely_vertices(mesh, 2), random)), expected) << name;
    }
    EXPECT_EQ(genus(joined(torus(5, 4), plate_with_holes(2))), 3);
    EXPECT_EQ(genus({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}), 0) << "a triangle with two sides";
}

TEST(EulerCounts, no_genus)
{
    Random random(20404);
    for (const auto& [name, mesh] : wild_meshes()) {
        if (std::string(name) != "lonely vertices") {
            EXPECT_EQ(genus(shuffled(mesh, random)), std::nullopt) << name;
        }
    }
    IndexedMesh turned = torus(6, 5);
    std::swap(turned.triangles[7].x, turned.triangles[7].y);
    EXPECT_EQ(genus(turned), std::nullopt) << "one triangle the other way round";
    EXPECT_EQ(genus(cones_with_large_indices(5)), std::nullopt);
    EXPECT_EQ(genus({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}}), std::nullopt) << "no faces";
}

TEST(EulerCounts, large_indices)
{
    const TopologyCounts counts = count_topology(cones_with_large_indices(60));
    EXPECT_EQ(counts, (TopologyCounts{181, 131'072 - 181, 360, 180, 180, 0, 3, 1}));
}

// Every mesh like a sphere agrees with the formulas, from each of its counts.
TEST(EulerCounts, spheres_are_determined_by_one_count)
{
    for (std::uint32_t columns = 3; columns < 12; ++columns) {
        for (std::uint32_t rows = 2; rows < 9; ++rows) {
            const TopologyCounts counts = count_topology(ball(columns, rows));
            const ElementCounts expected{counts.vertices, counts.edges, counts.faces};
            EXPECT_EQ(sphere_from_vertices(counts.vertices), expected);
            EXPECT_EQ(sphere_from_edges(counts.edges), expected);
            EXPECT_EQ(sphere_from_faces(counts.faces), expected);
        }
    }
    for (const std::int64_t none : {-12, 0, 1, 2, 3}) EXPECT_EQ(sphere_from_vertices(none), std::nullopt);
    for (const std::int64_t none : {-12, 0, 3, 5, 7, 8}) EXPECT_EQ(sphere_from_edges(none), std::nullopt);
    for (const std::int64_t none : {-12, 0, 2, 3, 5}) EXPECT_EQ(sphere_from_faces(none), std::nullopt);
    EXPECT_EQ(sphere_from_vertices(1'000'000'000'000'000'000),
              (ElementCounts{1'000'000'000'000'000'000, 2'999'999'999'999'999'994, 1'999'999'999'999'999'996}));
}
