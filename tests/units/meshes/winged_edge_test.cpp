#include <gtest/gtest.h>

#include <meshes/winged-edge/tables.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t after(const std::vector<std::uint32_t>& face, std::size_t i) { return face[(i + 1) % face.size()]; }

/// The faces with the side (from, to), by looking at all of them.
std::vector<std::uint32_t> faces_with(const PolygonMesh& mesh, std::uint32_t from, std::uint32_t to)
{
    std::vector<std::uint32_t> found;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t i = 0; i < mesh.faces[f].size(); ++i)
            if (mesh.faces[f][i] == from && after(mesh.faces[f], i) == to) found.push_back(f);
    return found;
}

WingedMesh winged(const PolygonMesh& mesh)
{
    auto result = winged_edges(mesh);
    if (const auto* fault = std::get_if<NotWinged>(&result))
        throw std::logic_error("refused with fault " + std::to_string(static_cast<int>(fault->fault)));
    return std::get<WingedMesh>(result);
}

/// The cyclic sequence, begun at its smallest item.
std::vector<std::uint32_t> from_smallest(std::vector<std::uint32_t> ring)
{
    std::ranges::rotate(ring, std::ranges::min_element(ring));
    return ring;
}

}

// Worked by hand in the statement.
TEST(WingedEdge, tetrahedron)
{
    const WingedMesh mesh = winged(polygons_of(tetrahedron()));
    ASSERT_EQ(mesh.edges.size(), 6U);
    const WingedEdge& e = mesh.edges[0];
    EXPECT_EQ(
        (std::vector{e.start, e.end, e.left, e.right, e.left_previous, e.left_next, e.right_previous, e.right_next}),
        (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 3, 4, 2}));
    EXPECT_EQ(edges_round_vertex(mesh, 0), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(vertices_round_face(mesh, 0), (std::vector<std::uint32_t>{0, 1, 2}));
}

// Every list against brute force, on bodies in random order.
TEST(WingedEdge, answers_are_those_of_brute_force)
{
    constexpr std::uint64_t seed = 20277;
    Random random(seed);
    for (int round = 0; round < 10; ++round) {
        for (const PolygonMesh& body : bodies()) {
            const PolygonMesh mesh = shuffled(body, random);
            const WingedMesh tables = winged(mesh);
            for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
                const std::vector<std::uint32_t> corners = vertices_round_face(tables, f);
                const std::vector<std::uint32_t> edges = edges_round_face(tables, f);
                const std::vector<std::uint32_t> neighbours = faces_round_face(tables, f);
                ASSERT_EQ(from_smallest(corners), from_smallest(mesh.faces[f])) << "seed " << seed;
                ASSERT_EQ(edges[0], *std::ranges::min_element(edges));
                for (std::size_t i = 0; i < corners.size(); ++i) {
                    const WingedEdge& e = tables.edges[edges[i]];
                    ASSERT_EQ(Ends(e.start, e.end), Ends(std::minmax(corners[i], after(corners, i))));
                    ASSERT_EQ(faces_with(mesh, after(corners, i), corners[i]), std::vector{neighbours[i]});
                }
            }
            for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
                const std::vector<std::uint32_t> others = vertices_round_vertex(tables, v);
                const std::vector<std::uint32_t> edges = edges_round_vertex(tables, v);
                const std::vector<std::uint32_t> faces = faces_round_vertex(tables, v);
                std::set<std::uint32_t> expected;
                for (std::uint32_t w = 0; w < mesh.positions.size(); ++w)
                    if (!faces_with(mesh, v, w).empty()) expected.insert(w);
                ASSERT_EQ(std::set<std::uint32_t>(others.begin(), others.end()), expected);
                ASSERT_EQ(others.size(), expected.size());
                for (std::size_t i = 0; i < others.size(); ++i) {
                    const WingedEdge& e = tables.edges[edges[i]];
                    ASSERT_EQ(Ends(e.start, e.end), Ends(std::minmax(v, others[i])));
                    // Counter-clockwise: the face on the left of (v, others[i]) comes back to v from the next
                    // neighbour.
                    ASSERT_EQ(faces_with(mesh, v, others[i]), std::vector{faces[i]});
                    ASSERT_EQ(faces_with(mesh, after(others, i), v), std::vector{faces[i]});
                }
            }
        }
    }
}

TEST(WingedEdge, every_fault_is_found)
{
    std::set<int> seen;
    for (const PolygonMesh& mesh : no_bodies()) {
        const auto result = winged_edges(mesh);
        ASSERT_TRUE(std::holds_alternative<NotWinged>(result));
        seen.insert(static_cast<int>(std::get<NotWinged>(result).fault));
    }
    EXPECT_EQ(seen, (std::set<int>{1, 2, 3, 4, 5, 6}));
}

TEST(WingedEdge, places_of_faults)
{
    const auto fault = [](const PolygonMesh& mesh) {
        const auto found = std::get<NotWinged>(winged_edges(mesh));
        return std::vector<std::uint32_t>{static_cast<std::uint32_t>(found.fault), found.a, found.b};
    };
    PolygonMesh open = polygons_of(tetrahedron());
    open.faces.erase(open.faces.begin());
    EXPECT_EQ(fault(open), (std::vector<std::uint32_t>{3, 0, 1}));
    PolygonMesh turned = polygons_of(tetrahedron());
    std::ranges::reverse(turned.faces[3]);
    EXPECT_EQ(fault(turned), (std::vector<std::uint32_t>{4, 1, 2}));
    PolygonMesh lonely = polygons_of(tetrahedron());
    lonely.positions.emplace_back(0);
    EXPECT_EQ(fault(lonely), (std::vector<std::uint32_t>{5, 4, 4}));
    EXPECT_EQ(fault(polygons_of(cubes_at_an_edge()))[0], 2U);
    EXPECT_EQ(fault(polygons_of(cubes_at_a_corner()))[0], 6U);
}
