#include <gtest/gtest.h>

#include <meshes/orientation/cases.hpp>
#include <umbral/meshes/orientation.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

std::map<Ends, std::vector<std::size_t>> triangles_at_edges(const std::vector<glm::uvec3>& triangles)
{
    std::map<Ends, std::vector<std::size_t>> edges;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) edges[std::minmax(triangles[i][k], triangles[i][(k + 1) % 3])].push_back(i);
    return edges;
}

bool is_manifold(const IndexedMesh& mesh)
{
    const ManifoldFaults faults = manifold_faults(mesh);
    return faults.crowded_edges.empty() && faults.lonely_vertices.empty() && faults.torn_vertices.empty();
}

bool runs_along(const glm::uvec3& t, std::uint32_t a, std::uint32_t b)
{
    return (t.x == a && t.y == b) || (t.y == a && t.z == b) || (t.z == a && t.x == b);
}

bool is_coherent(const std::vector<glm::uvec3>& triangles)
{
    for (const auto& [ends, at] : triangles_at_edges(triangles))
        if (at.size() == 2 && runs_along(triangles[at[0]], ends.first, ends.second) ==
                                  runs_along(triangles[at[1]], ends.first, ends.second))
            return false;
    return true;
}

/// Six volumes of the whole mesh, in integers of a grid.
__extension__ using Exact = __int128;
Exact exact_volume(const IndexedMesh& mesh, const std::vector<glm::uvec3>& triangles, double grid)
{
    const auto at = [&](std::uint32_t vertex, int axis) {
        return static_cast<Exact>(static_cast<double>(mesh.positions[vertex][axis]) / grid);
    };
    Exact sum = 0;
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3;
            const int m = (k + 2) % 3;
            sum += at(t.x, k) * (at(t.y, l) * at(t.z, m) - at(t.y, m) * at(t.z, l));
        }
    return sum;
}

}

TEST(Orientation, known_faults)
{
    for (const Sample& sample : tame_meshes()) EXPECT_TRUE(is_manifold(sample.mesh)) << sample.name;
    EXPECT_EQ(manifold_faults(book(3)).crowded_edges, (std::vector<glm::uvec2>{{0, 1}}));
    EXPECT_TRUE(manifold_faults(book(3)).torn_vertices.empty());
    EXPECT_EQ(manifold_faults(bow_tie()).torn_vertices, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(manifold_faults(hourglass(4)).torn_vertices, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(manifold_faults(cubes_at_an_edge()).crowded_edges.size(), 1U);
    EXPECT_TRUE(manifold_faults(cubes_at_an_edge()).torn_vertices.empty());
    EXPECT_EQ(manifold_faults(cubes_at_a_corner()).torn_vertices.size(), 1U);
    EXPECT_EQ(manifold_faults(with_lonely_vertices(octahedron(), 2)).lonely_vertices,
              (std::vector<std::uint32_t>{6, 7}));
    for (const IndexedMesh& mesh : {moebius(7), klein_bottle(6, 5), projective_plane()}) EXPECT_TRUE(is_manifold(mesh));
}

TEST(Orientation, coherent_or_nothing)
{
    constexpr std::uint64_t seed = 20278;
    Random random(seed);
    for (int round = 0; round < 20; ++round) {
        for (const Sample& sample : tame_meshes()) {
            const IndexedMesh mesh = with_mixed_winding(shuffled(sample.mesh, random), random);
            const auto triangles = coherent_triangles(mesh);
            ASSERT_TRUE(triangles) << sample.name << ", seed " << seed;
            EXPECT_TRUE(is_coherent(*triangles)) << sample.name;
            EXPECT_EQ((*triangles)[0], mesh.triangles[0]);
        }
        for (const IndexedMesh& mesh :
             {moebius(7), moebius(6, 2), klein_bottle(6, 5), projective_plane(), joined(cube(), moebius(3))})
            EXPECT_FALSE(coherent_triangles(with_mixed_winding(shuffled(mesh, random), random)));
    }
    // The course's example: (2,3,7) and (4,7,3) agree.
    const auto pair = coherent_triangles({std::vector<glm::vec3>(8), {{2, 3, 7}, {4, 3, 7}}});
    ASSERT_TRUE(pair);
    EXPECT_TRUE(is_coherent(*pair));
}

TEST(Orientation, outward_wherever_the_body_lies)
{
    constexpr std::uint64_t seed = 20279;
    Random random(seed);
    for (const auto& [distance, step] : {std::pair(1.0, -16), {1e3, -14}, {1e5, -7}, {1e6, -4}, {1e7, 0}}) {
        for (const IndexedMesh& body : {ball(8, 5), torus(7, 5), plate_with_holes(3), tetrahedron()}) {
            for (int i = 0; i < 50; ++i) {
                const IndexedMesh mesh = shuffled(far_body(body, distance, step, random), random);
                const double grid = std::ldexp(1.0, step);
                const Exact before = exact_volume(mesh, mesh.triangles, grid);
                const Exact after = exact_volume(mesh, outward_triangles(mesh), grid);
                ASSERT_TRUE(after == (before < 0 ? -before : before)) << "seed " << seed << ", distance " << distance;
            }
        }
    }
}

TEST(Orientation, pieces_on_their_own_and_open_ones_as_they_are)
{
    const IndexedMesh mesh = joined(joined(ball(6, 4), turned_over(octahedron())), turned_over(flat_sheet(2, 2)));
    const std::vector<glm::uvec3> triangles = outward_triangles(mesh);
    const IndexedMesh expected = joined(joined(ball(6, 4), octahedron()), turned_over(flat_sheet(2, 2)));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3 t = expected.triangles[i];
        EXPECT_TRUE(triangles[i] == t || triangles[i] == glm::uvec3(t.y, t.z, t.x) ||
                    triangles[i] == glm::uvec3(t.z, t.x, t.y))
            << i;
    }
}

// Whatever triangles are put together at random: separated, they are a manifold in the same place, and separating again
// changes nothing.
TEST(Orientation, separated_is_always_manifold)
{
    constexpr std::uint64_t seed = 20280;
    Random random(seed);
    Variation none;
    std::vector<IndexedMesh> meshes = suspects(none, random);
    for (int i = 0; i < 2000; ++i) {
        IndexedMesh mesh{std::vector<glm::vec3>(4 + random.below(6)), {}};
        const auto count = static_cast<std::uint32_t>(mesh.positions.size());
        for (glm::vec3& position : mesh.positions) position = random.in_cube();
        for (std::uint32_t k = random.below(25); k > 0; --k) {
            const std::uint32_t a = random.below(count);
            const std::uint32_t b = (a + 1 + random.below(count - 1)) % count;
            std::uint32_t c = random.below(count);
            while (c == a || c == b) c = (c + 1) % count;
            mesh.triangles.emplace_back(a, b, c);
        }
        meshes.push_back(mesh);
    }
    for (const IndexedMesh& mesh : meshes) {
        const IndexedMesh result = separated(mesh);
        const ManifoldFaults faults = manifold_faults(result);
        ASSERT_TRUE(faults.crowded_edges.empty() && faults.torn_vertices.empty()) << "seed " << seed;
        ASSERT_EQ(faults.lonely_vertices, manifold_faults(mesh).lonely_vertices);
        ASSERT_EQ(result.triangles.size(), mesh.triangles.size());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k)
                ASSERT_EQ(result.positions[result.triangles[i][k]], mesh.positions[mesh.triangles[i][k]]);
        EXPECT_EQ(separated(result).positions.size(), result.positions.size());
    }
    EXPECT_EQ(separated(hourglass(5)).positions.size(), hourglass(5).positions.size() + 1);
    EXPECT_EQ(separated(cubes_at_an_edge()).positions.size(), 16U);
    EXPECT_EQ(separated(cubes_at_a_corner()).positions.size(), 16U);
}
