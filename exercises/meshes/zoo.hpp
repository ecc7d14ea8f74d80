#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "support.hpp"

/// A zoo of meshes for questions about topology: what each of them is stands beside it. All have a size of about 2
/// round the origin.
namespace umbral::meshes {

/// A strip of `cells` (3 or more) quadrilaterals with half a twist: one side, one boundary loop of 2 `cells` edges,
/// characteristic 0. Not orientable.
inline IndexedMesh moebius(std::uint32_t cells, std::uint32_t across = 1)
{
    IndexedMesh mesh;
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
        for (std::uint32_t row = 0; row <= across; ++row) {
            const double u = 6.283185307179586 * cell / cells;
            const double shift = 0.45 * (2.0 * row / across - 1);
            const double distance = 1 + shift * std::cos(u / 2);
            mesh.positions.emplace_back(distance * std::sin(u), shift * std::sin(u / 2), distance * std::cos(u));
        }
    }
    const auto at = [&](std::uint32_t cell, std::uint32_t row) {
        return cell < cells ? cell * (across + 1) + row : across - row;
    };
    for (std::uint32_t cell = 0; cell < cells; ++cell)
        for (std::uint32_t row = 0; row < across; ++row)
            add_quad(mesh, {at(cell, row), at(cell + 1, row), at(cell + 1, row + 1), at(cell, row + 1)});
    return mesh;
}

/// A torus whose last join is turned over: closed, not orientable, characteristic 0. Its positions are a torus's, so
/// that it cuts itself.
inline IndexedMesh klein_bottle(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh = torus(columns, rows);
    mesh.triangles.clear();
    const auto at = [&](std::uint32_t column, std::uint32_t row) {
        return column < columns ? column * rows + row % rows : (2 * rows - row) % rows;
    };
    for (std::uint32_t column = 0; column < columns; ++column)
        for (std::uint32_t row = 0; row < rows; ++row)
            add_quad(mesh, {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
    return mesh;
}

/// The projective plane with the fewest triangles: V 6, E 15, F 10; closed, not orientable, characteristic 1. Its
/// positions are any.
inline IndexedMesh projective_plane()
{
    return {
        {{1, 0, 0}, {-1, 0, 0.1F}, {0, 1, 0}, {0, -1, 0.2F}, {0, 0, 1}, {0.1F, 0, -1}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}}};
}

/// `pages` triangles that share one edge: a manifold for one and two, none from three on.
inline IndexedMesh book(std::uint32_t pages)
{
    IndexedMesh mesh{{{0, -1, 0}, {0, 1, 0}}, {}};
    for (std::uint32_t page = 0; page < pages; ++page) {
        const double angle = 6.283185307179586 * page / pages;
        mesh.positions.emplace_back(std::cos(angle), 0, std::sin(angle));
        mesh.triangles.emplace_back(0, 1, page + 2);
    }
    return mesh;
}

/// Two triangles that share one vertex and no edge: a bow-tie vertex on the boundary.
inline IndexedMesh bow_tie()
{
    return {{{0, 0, 0}, {1, 0.6F, 0}, {1, -0.6F, 0}, {-1, 0.6F, 0}, {-1, -0.6F, 0}}, {{0, 2, 1}, {0, 3, 4}}};
}

/// A disc of `slices` (3 or more) triangles round one vertex, whose degree grows with it.
inline IndexedMesh disc(std::uint32_t slices)
{
    IndexedMesh mesh{{{0, 0.3F, 0}}, {}};
    for (std::uint32_t slice = 0; slice < slices; ++slice) {
        const double angle = 6.283185307179586 * slice / slices;
        mesh.positions.emplace_back(std::sin(angle), 0, std::cos(angle));
        mesh.triangles.emplace_back(0, 1 + slice, 1 + (slice + 1) % slices);
    }
    return mesh;
}

/// Cones that share their apex, a bow tie; the apex is the last of 131,072 vertices, and their rims begin at 0, 32,768
/// and 65,536.
///
/// Two vertices packed into 32 bits, as a * V + b or as a << 16 | b, are the same number for edges of different cones.
inline IndexedMesh cones_with_large_indices(std::uint32_t slices)
{
    constexpr std::uint32_t apex = 131'071;
    IndexedMesh mesh{std::vector<glm::vec3>(apex + 1), {}};
    for (const std::uint32_t first : {0U, 32'768U, 65'536U}) {
        for (std::uint32_t slice = 0; slice < slices; ++slice) {
            const double angle = 6.283185307179586 * slice / slices;
            mesh.positions[first + slice] =
                glm::vec3(glm::dvec3(std::sin(angle), first / 32'768.0 - 1.5, std::cos(angle)));
            mesh.triangles.emplace_back(apex, first + slice, first + (slice + 1) % slices);
        }
    }
    return mesh;
}

/// A tube without ends: two boundary loops of `columns` (3 or more) edges, characteristic 0.
inline IndexedMesh tube(std::uint32_t columns, std::uint32_t rows)
{
    IndexedMesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double angle = 6.283185307179586 * column / columns;
            mesh.positions.emplace_back(std::sin(angle), 1.6 * row / rows - 0.8, std::cos(angle));
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns;
            add_quad(mesh, {row * columns + column, row * columns + next, (row + 1) * columns + next,
                            (row + 1) * columns + column});
        }
    }
    return mesh;
}

/// A flat sheet of `columns` x `rows` cells over the xz-plane, up +y, each side 2 long.
inline IndexedMesh flat_sheet(std::uint32_t columns, std::uint32_t rows)
{
    return sheet(columns, rows, [&](std::uint32_t column, std::uint32_t row) {
        return glm::vec3(2.0F * static_cast<float>(column) / static_cast<float>(columns) - 1, 0,
                         2.0F * static_cast<float>(row) / static_cast<float>(rows) - 1);
    });
}

/// Both meshes, the second one's vertices after the first one's; they share none.
inline IndexedMesh joined(IndexedMesh first, const IndexedMesh& second, const glm::vec3& shift = glm::vec3(0))
{
    const auto count = static_cast<std::uint32_t>(first.positions.size());
    for (const glm::vec3& position : second.positions) first.positions.push_back(position + shift);
    for (const glm::uvec3& triangle : second.triangles) first.triangles.push_back(triangle + count);
    return first;
}

/// The same mesh in another order: vertices and triangles are permuted, and triangles start at any of their corners.
/// Winding stays.
inline IndexedMesh shuffled(const IndexedMesh& mesh, Random& random)
{
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<std::uint32_t> place(count);
    for (std::uint32_t i = 0; i < count; ++i) place[i] = i;
    for (std::uint32_t i = count; i > 1; --i) std::swap(place[i - 1], place[random.below(i)]);
    IndexedMesh result{std::vector<glm::vec3>(count), mesh.triangles};
    for (std::uint32_t i = 0; i < count; ++i) result.positions[place[i]] = mesh.positions[i];
    for (auto i = static_cast<std::uint32_t>(result.triangles.size()); i > 1; --i)
        std::swap(result.triangles[i - 1], result.triangles[random.below(i)]);
    for (glm::uvec3& t : result.triangles) {
        t = {place[t.x], place[t.y], place[t.z]};
        for (std::uint32_t turns = random.below(3); turns > 0; --turns) t = {t.y, t.z, t.x};
    }
    return result;
}

/// The mesh shuffled; as it is unless inputs are to vary.
inline IndexedMesh shuffled(const IndexedMesh& mesh, Variation& vary)
{
    Random* const random = vary.random();
    return random != nullptr ? shuffled(mesh, *random) : mesh;
}

/// About half of the triangles wound the other way round.
inline IndexedMesh with_mixed_winding(IndexedMesh mesh, Random& random)
{
    for (glm::uvec3& triangle : mesh.triangles)
        if (random.below(2) == 1) std::swap(triangle.y, triangle.z);
    return mesh;
}

/// `count` vertices that no triangle has, at the end of the list.
inline IndexedMesh with_lonely_vertices(IndexedMesh mesh, int count)
{
    for (int i = 0; i < count; ++i) mesh.positions.emplace_back(0.3F * static_cast<float>(i), 1.5F, 0);
    return mesh;
}

/// A mesh of the zoo, and its name for reports and tests.
struct Sample {
    const char* name;
    IndexedMesh mesh;
};

/// One of each kind that is coherently wound and a 2-manifold (every edge has one or two triangles, the triangles round
/// a vertex form one fan). Varied, those that have a size have another one.
inline std::vector<Sample> tame_meshes(Variation& vary)
{
    const auto size = [&](std::uint32_t written) { return vary.one_of(written, std::array{written + 1, written + 2}); };
    return {{"tetrahedron", tetrahedron()},
            {"octahedron", octahedron()},
            {"cube", cube()},
            {"ball", ball(size(8), size(5))},
            {"torus", torus(size(7), size(5))},
            {"plate with two holes", plate_with_holes(2)},
            {"plate with three holes", plate_with_holes(3)},
            {"two balls", joined(ball(size(5), size(3)), ball(size(4), size(4)), {3, 0, 0})},
            {"sheet", flat_sheet(size(4), size(3))},
            {"disc", disc(size(7))},
            {"tube", tube(size(6), size(2))},
            {"triangle", book(1)},
            {"two sheets", joined(flat_sheet(size(2), size(2)), flat_sheet(size(1), size(3)), {0, 1, 0})}};
}

inline std::vector<Sample> tame_meshes()
{
    Variation none;
    return tame_meshes(none);
}

/// A mesh and its copy, whose vertices have numbers that are 65,536 larger: two numbers of vertices do not fit into 32
/// bits. The vertices between belong to no triangle.
inline IndexedMesh with_far_copy(IndexedMesh mesh)
{
    constexpr std::uint32_t far = 65536;
    const std::size_t count = mesh.positions.size();
    mesh.positions.resize(far + count, glm::vec3(0));
    std::copy_n(mesh.positions.begin(), count, mesh.positions.begin() + far);
    for (std::size_t i = 0, old = mesh.triangles.size(); i < old; ++i)
        mesh.triangles.push_back(mesh.triangles[i] + far);
    return mesh;
}

/// The same mesh, whose vertices get four kinds of numbers in random order: from 0, `step`, 2 `step` and 3 `step` on.
///
/// Two vertices packed into one number by that step, as a * step + b, or cut at it, are the same for many other edges.
/// The vertices between belong to no triangle.
inline IndexedMesh spread(const IndexedMesh& mesh, std::uint32_t step, Random& random)
{
    const IndexedMesh ordered = shuffled(mesh, random);
    const auto place = [step](std::uint32_t vertex) { return vertex / 4 + vertex % 4 * step; };
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    IndexedMesh result{std::vector<glm::vec3>(3 * step + count, glm::vec3(0)), ordered.triangles};
    for (std::uint32_t i = 0; i < count; ++i) result.positions[place(i)] = ordered.positions[i];
    for (glm::uvec3& t : result.triangles) t = {place(t.x), place(t.y), place(t.z)};
    return result;
}

/// One of each kind that is not orientable, not a manifold, or not what one expects of a mesh.
inline std::vector<Sample> wild_meshes()
{
    IndexedMesh doubled = flat_sheet(2, 2);
    doubled.triangles.push_back(doubled.triangles[3]);
    return {{"Moebius strip", moebius(9)},
            {"wide Moebius strip", moebius(8, 3)},
            {"Klein bottle", klein_bottle(6, 5)},
            {"projective plane", projective_plane()},
            {"three triangles at an edge", book(3)},
            {"five triangles at an edge", book(5)},
            {"bow tie", bow_tie()},
            {"cubes at an edge", cubes_at_an_edge()},
            {"cubes at a corner", cubes_at_a_corner()},
            {"a triangle twice", doubled},
            {"lonely vertices", with_lonely_vertices(octahedron(), 3)},
            {"no triangles", with_lonely_vertices({}, 4)},
            {"nothing", {}}};
}

}
