#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <umbral/meshes/winged_edge.hpp>
#include <utility>

#include "../football.hpp"
#include "../zoo.hpp"

/// Meshes to ask about, and tables to ask them with: questions must not suffer from tables that the unit got wrong.
namespace umbral::meshes {

/// The winged edges of a mesh that surely has them, by the way of a map.
inline WingedMesh tables_of(const PolygonMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    const auto at = [](const std::vector<std::uint32_t>& face, std::size_t i) { return face[i % face.size()]; };
    for (const auto& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) numbers[std::minmax(at(face, i), at(face, i + 1))] = 0;
    WingedMesh tables{{},
                      std::vector<std::uint32_t>(mesh.positions.size(), 4294967295U),
                      std::vector<std::uint32_t>(mesh.faces.size(), 4294967295U)};
    for (auto& [ends, number] : numbers) {
        number = static_cast<std::uint32_t>(tables.edges.size());
        tables.edges.push_back({ends.first, ends.second, 0, 0, 0, 0, 0, 0});
        for (const std::uint32_t vertex : {ends.first, ends.second})
            tables.edge_of_vertex[vertex] = std::min(tables.edge_of_vertex[vertex], number);
    }
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        const auto& face = mesh.faces[f];
        const auto edge = [&](std::size_t i) { return numbers.at(std::minmax(at(face, i), at(face, i + 1))); };
        for (std::size_t i = 0; i < face.size(); ++i) {
            WingedEdge& e = tables.edges[edge(i)];
            tables.edge_of_face[f] = std::min(tables.edge_of_face[f], edge(i));
            const bool is_left = face[i] == e.start;
            (is_left ? e.left : e.right) = f;
            (is_left ? e.left_previous : e.right_previous) = edge(i + face.size() - 1);
            (is_left ? e.left_next : e.right_next) = edge(i + 1);
        }
    }
    return tables;
}

inline PolygonMesh polygons_of(const IndexedMesh& mesh)
{
    PolygonMesh result{mesh.positions, {}};
    for (const glm::uvec3& t : mesh.triangles) result.faces.push_back({t.x, t.y, t.z});
    return result;
}

/// Two fans of `sides` triangles over a ring: two vertices have as many edges as there are sides.
inline PolygonMesh double_cone(std::uint32_t sides)
{
    PolygonMesh mesh{{{0, 1, 0}, {0, -1, 0}}, {}};
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 6.283185307179586 * i / sides;
        mesh.positions.emplace_back(std::sin(angle), 0, std::cos(angle));
        mesh.faces.push_back({0, 2 + i, 2 + (i + 1) % sides});
        mesh.faces.push_back({1, 2 + (i + 1) % sides, 2 + i});
    }
    return mesh;
}

/// A prism over a polygon of `sides` corners: faces of many corners.
inline PolygonMesh prism(std::uint32_t sides)
{
    PolygonMesh mesh;
    std::vector<std::uint32_t> top;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 6.283185307179586 * i / sides;
        for (const float y : {-0.7F, 0.7F}) mesh.positions.emplace_back(std::sin(angle), y, std::cos(angle));
        const std::uint32_t next = (i + 1) % sides;
        mesh.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
        top.push_back(2 * i + 1);
    }
    std::vector<std::uint32_t> bottom(top.rbegin(), top.rend());
    for (std::uint32_t& vertex : bottom) --vertex;
    mesh.faces.push_back(top);
    mesh.faces.push_back(bottom);
    return mesh;
}

/// The same mesh with faces in another order, and begun at any corner.
inline PolygonMesh with_shuffled_faces(PolygonMesh mesh, Random& random)
{
    const auto some = [&](std::size_t count) { return random.below(static_cast<std::uint32_t>(count)); };
    for (std::size_t i = mesh.faces.size(); i > 1; --i) std::swap(mesh.faces[i - 1], mesh.faces[some(i)]);
    for (auto& face : mesh.faces)
        if (!face.empty()) std::rotate(face.begin(), face.begin() + some(face.size()), face.end());
    return mesh;
}

/// The same, with vertices in another order too. Corners that are no vertices stay what they are.
inline PolygonMesh shuffled(const PolygonMesh& mesh, Random& random)
{
    PolygonMesh result = with_shuffled_faces(mesh, random);
    std::vector<std::uint32_t> place(mesh.positions.size());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    for (std::size_t i = place.size(); i > 1; --i)
        std::swap(place[i - 1], place[random.below(static_cast<std::uint32_t>(i))]);
    for (std::size_t i = 0; i < place.size(); ++i) result.positions[place[i]] = mesh.positions[i];
    for (auto& face : result.faces)
        for (std::uint32_t& corner : face)
            if (corner < place.size()) corner = place[corner];
    return result;
}

/// The mesh shuffled; as it is unless inputs are to vary.
inline PolygonMesh shuffled(const PolygonMesh& mesh, Variation& vary)
{
    Random* const random = vary.random();
    return random != nullptr ? shuffled(mesh, *random) : mesh;
}

/// Bodies of triangles, quadrilaterals, pentagons, hexagons and more, of genus 0, 1 and 2, in one piece and in two.
inline std::vector<PolygonMesh> bodies()
{
    return {polygons_of(tetrahedron()),
            prism(4),
            football(),
            prism(9),
            double_cone(7),
            polygons_of(torus(5, 4)),
            polygons_of(plate_with_holes(2)),
            polygons_of(joined(octahedron(), tetrahedron(), {3, 0, 0})),
            {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}}};
}

/// Meshes that have no winged edges, one for each reason and some with several.
inline std::vector<PolygonMesh> no_bodies()
{
    std::vector<PolygonMesh> meshes;
    for (const Sample& sample : wild_meshes())
        if (!sample.mesh.positions.empty()) meshes.push_back(polygons_of(sample.mesh));
    for (const IndexedMesh& open :
         {flat_sheet(3, 2), tube(5, 2), disc(6), book(1), book(2), with_far_copy(tetrahedron())})
        meshes.push_back(polygons_of(open));
    const PolygonMesh good = prism(5);
    const auto changed = [&](auto change) {
        meshes.push_back(good);
        change(meshes.back());
    };
    changed([](PolygonMesh& mesh) { std::ranges::reverse(mesh.faces[2]); });
    changed([](PolygonMesh& mesh) { mesh.faces.erase(mesh.faces.begin() + 3); });
    changed([](PolygonMesh& mesh) { mesh.positions.emplace_back(0, 0, 0); });
    changed([](PolygonMesh& mesh) { mesh.faces.insert(mesh.faces.begin() + 2, std::vector<std::uint32_t>{}); });
    changed([](PolygonMesh& mesh) { mesh.faces[4] = {3, 4}; });
    changed([](PolygonMesh& mesh) { mesh.faces[1].push_back(mesh.faces[1][0]); });
    changed([](PolygonMesh& mesh) { mesh.faces[5][3] = mesh.faces[5][1]; });
    changed([](PolygonMesh& mesh) { mesh.faces[6][2] = 10; });
    changed([](PolygonMesh& mesh) { mesh.faces[0][1] = 4294967295U; });
    changed([](PolygonMesh& mesh) { mesh.faces.push_back(mesh.faces[3]); });
    // A bag whose two corners are one: closed and coherent, but the faces of vertex 0 are two rings.
    PolygonMesh bag = polygons_of(ball(6, 4));
    const auto last = static_cast<std::uint32_t>(bag.positions.size()) - 1;
    for (auto& face : bag.faces) std::ranges::replace(face, last, 0U);
    bag.positions.pop_back();
    meshes.push_back(bag);
    return meshes;
}

/// Both, the second one's vertices behind the first one's.
inline PolygonMesh joined(PolygonMesh first, const PolygonMesh& second)
{
    const auto count = static_cast<std::uint32_t>(first.positions.size());
    first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
    for (std::vector<std::uint32_t> face : second.faces) {
        for (std::uint32_t& corner : face) corner += count;
        first.faces.push_back(face);
    }
    return first;
}

/// Two bodies that share a vertex, any one of each.
inline PolygonMesh sharing_a_vertex(const PolygonMesh& first, const PolygonMesh& second, Random& random)
{
    PolygonMesh mesh = joined(shuffled(first, random), shuffled(second, random));
    const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
    for (auto& face : mesh.faces) std::ranges::replace(face, last, 0U);
    mesh.positions.pop_back();
    return mesh;
}

/// Each two kinds of faults in one mesh, of which only the first is to be reported, and bodies that share a vertex. The
/// order of the pieces, vertices and faces says nothing. What is looked for late comes more often.
inline std::vector<PolygonMesh> more_faults(Random& random)
{
    PolygonMesh names_twice = prism(5);
    names_twice.faces[5][3] = names_twice.faces[5][1];
    PolygonMesh turned = prism(5);
    std::ranges::reverse(turned.faces[2]);
    const std::array kinds{names_twice,
                           polygons_of(cubes_at_an_edge()),
                           polygons_of(disc(6)),
                           turned,
                           polygons_of(with_lonely_vertices(octahedron(), 2)),
                           polygons_of(cubes_at_a_corner())};
    std::vector<PolygonMesh> meshes;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        for (std::size_t k = i; k < kinds.size(); ++k)
            for (std::size_t round = 0; round < 1 + i / 2; ++round)
                meshes.push_back(shuffled(joined(kinds[i], kinds[k]), random));
    const std::array wholes{polygons_of(octahedron()), prism(6), double_cone(5), polygons_of(torus(5, 4))};
    for (std::size_t i = 0; i < wholes.size(); ++i)
        for (std::size_t k = i; k < wholes.size(); k += 2)
            meshes.push_back(shuffled(sharing_a_vertex(wholes[i], wholes[k], random), random));
    // Two bags of two triangles each, which share a vertex of four edges only; and with a vertex that nobody has, of
    // which the one in the lower place is not the first to be looked for.
    PolygonMesh bags{std::vector<glm::vec3>(5), {{0, 1, 2}, {0, 2, 1}, {0, 3, 4}, {0, 4, 3}}};
    meshes.push_back(shuffled(bags, random));
    bags.positions.emplace_back(1);
    // A face with a vertex twice, and one with two corners: the first of the two faces is told.
    const PolygonMesh two_faces{std::vector<glm::vec3>(3), {{0, 1, 0, 2}, {0, 1}}};
    for (int i = 0; i < 4; ++i)
        for (const PolygonMesh& mesh : {bags, two_faces}) meshes.push_back(shuffled(mesh, random));
    return meshes;
}

}
