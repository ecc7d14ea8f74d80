#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <tuple>
#include <umbral/meshes/mesh.hpp>
#include <utility>

#include "support.hpp"

/// Bodies: closed meshes, wound so that they look outwards. Their size is about 2, round the origin.
namespace umbral::meshes {

/// Cells of a lattice of unit cubes.
using Cubes = std::set<std::tuple<int, int, int>>;

/// The outward surface of a union of cubes, each side of a cube cut into two triangles; cubes that meet in an edge or
/// corner share its vertices.
///
/// Where two cubes meet in an edge only, that edge has four triangles; where they meet in a corner only, the vertex is
/// a bow tie.
inline IndexedMesh cube_surface(const Cubes& cubes, float scale = 1)
{
    IndexedMesh mesh;
    std::map<std::tuple<int, int, int>, std::uint32_t> places;
    const auto vertex = [&](const glm::ivec3& corner) {
        const auto [found, is_new] =
            places.try_emplace({corner.x, corner.y, corner.z}, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) mesh.positions.push_back(scale * glm::vec3(corner));
        return found->second;
    };
    for (const auto& [x, y, z] : cubes) {
        const glm::ivec3 low(x, y, z);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                glm::ivec3 out(0), u(0), v(0);
                out[axis] = 1;
                u[(axis + 1) % 3] = 1;
                v[(axis + 2) % 3] = 1;
                const glm::ivec3 neighbour = low + (2 * side - 1) * out;
                if (cubes.contains({neighbour.x, neighbour.y, neighbour.z})) continue;
                if (side == 0) std::swap(u, v);
                const glm::ivec3 first = low + side * out;
                add_quad(mesh, {vertex(first), vertex(first + u), vertex(first + u + v), vertex(first + v)});
            }
        }
    }
    return mesh;
}

/// The middle of the bounding box goes to the origin.
inline IndexedMesh centred(IndexedMesh mesh)
{
    if (mesh.positions.empty()) return mesh;
    glm::vec3 low = mesh.positions[0];
    glm::vec3 high = low;
    for (const glm::vec3& position : mesh.positions) {
        low = min(low, position);
        high = max(high, position);
    }
    return mapped(std::move(mesh), [&](const glm::vec3& position) { return position - 0.5F * (low + high); });
}

/// V 4, E 6, F 4; closed, genus 0.
inline IndexedMesh tetrahedron()
{
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// V 6, E 12, F 8; closed, genus 0.
inline IndexedMesh octahedron()
{
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// V 8, E 18, F 12; closed, genus 0.
inline IndexedMesh cube() { return centred(cube_surface({{0, 0, 0}}, 1.4F)); }

/// Closed, of any genus: a plate of cubes with that many holes in a row.
inline IndexedMesh plate_with_holes(int genus)
{
    Cubes cubes;
    for (int x = 0; x <= 2 * genus; ++x)
        for (int y = 0; y < 3; ++y)
            if (y != 1 || x % 2 == 0) cubes.insert({x, y, 0});
    return centred(cube_surface(cubes, 2.4F / static_cast<float>(2 * genus + 1)));
}

/// Two cubes that share an edge: that edge has four triangles, and its ends are no bow ties, since all their triangles
/// hang together over edges.
inline IndexedMesh cubes_at_an_edge() { return centred(cube_surface({{0, 0, 0}, {1, 1, 0}}, 0.9F)); }

/// Two cubes that share a corner: a bow-tie vertex, and every edge has two triangles.
inline IndexedMesh cubes_at_a_corner() { return centred(cube_surface({{0, 0, 0}, {1, 1, 1}}, 0.9F)); }

/// A ball of `columns` meridians (3 or more) and `rows` bands (2 or more); each pole is one vertex. V columns (rows -
/// 1) + 2, F 2 columns (rows - 1).
inline IndexedMesh ball(std::uint32_t columns, std::uint32_t rows, float radius = 1)
{
    IndexedMesh mesh;
    const auto ring = [&](std::uint32_t row, std::uint32_t column) {
        return 1 + (row - 1) * columns + column % columns;
    };
    mesh.positions.emplace_back(0, radius, 0);
    for (std::uint32_t row = 1; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double latitude = 3.141592653589793 * row / rows;
            const double longitude = 6.283185307179586 * column / columns;
            mesh.positions.emplace_back(double{radius} * glm::dvec3(std::sin(latitude) * std::sin(longitude),
                                                                    std::cos(latitude),
                                                                    std::sin(latitude) * std::cos(longitude)));
        }
    }
    const auto south = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0, -radius, 0);
    for (std::uint32_t column = 0; column < columns; ++column) {
        mesh.triangles.emplace_back(0, ring(1, column), ring(1, column + 1));
        for (std::uint32_t row = 1; row + 1 < rows; ++row)
            add_quad(mesh,
                     {ring(row, column), ring(row + 1, column), ring(row + 1, column + 1), ring(row, column + 1)});
        mesh.triangles.emplace_back(ring(rows - 1, column), south, ring(rows - 1, column + 1));
    }
    return mesh;
}

/// A closed grid of `columns` x `rows` (3 or more each) cells that is joined to itself on both sides: a torus, genus 1.
/// V columns rows, E 3 V, F 2 V.
inline IndexedMesh torus(std::uint32_t columns, std::uint32_t rows, float large = 1, float small = 0.42F)
{
    IndexedMesh mesh;
    for (std::uint32_t column = 0; column < columns; ++column) {
        for (std::uint32_t row = 0; row < rows; ++row) {
            const double u = 6.283185307179586 * column / columns;
            const double v = 6.283185307179586 * row / rows;
            const double distance = double{large} + double{small} * std::cos(v);
            mesh.positions.emplace_back(distance * std::sin(u), double{small} * std::sin(v), distance * std::cos(u));
        }
    }
    const auto at = [&](std::uint32_t column, std::uint32_t row) { return column % columns * rows + row % rows; };
    for (std::uint32_t column = 0; column < columns; ++column)
        for (std::uint32_t row = 0; row < rows; ++row)
            add_quad(mesh, {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
    return mesh;
}

}
