#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

/// What the drivers of meshes share: meshes to ask questions about.
namespace umbral::meshes {

/// Adds the quadrilateral a, b, c, d (counter-clockwise) as two triangles, cut from a to c, or else from b to d.
inline void add_quad(IndexedMesh& mesh, const glm::uvec4& corners, bool cut_at_first = true)
{
    const auto [a, b, c, d] = std::array{corners.x, corners.y, corners.z, corners.w};
    if (cut_at_first)
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    else
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
}

/// A sheet of `columns` x `rows` cells over the xz-plane, up +y; `place(column, row)` gives the vertices, row by row.
template <class Place>
IndexedMesh sheet(std::uint32_t columns, std::uint32_t rows, Place place)
{
    IndexedMesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column) mesh.positions.push_back(place(column, row));
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = row * (columns + 1) + column;
            const std::uint32_t below = corner + columns + 1;
            add_quad(mesh, {corner, below, below + 1, corner + 1}, (row + column) % 2 == 0);
        }
    }
    return mesh;
}

/// A hilly sheet whose cells grow along both axes, so that the triangles round a vertex differ much in area and angle.
inline IndexedMesh hills(std::uint32_t columns, std::uint32_t rows, Random& random)
{
    return sheet(columns, rows, [&](std::uint32_t column, std::uint32_t row) {
        const auto stretched = [](float cell) { return cell + 0.15F * cell * cell; };
        const glm::vec3 shift = 0.3F * random.in_cube();
        return glm::vec3(stretched(static_cast<float>(column)), 2 * shift.y, stretched(static_cast<float>(row))) +
               glm::vec3(shift.x, 0, shift.z);
    });
}

/// A unit vector perpendicular to the unit vector `axis`.
inline glm::dvec3 aside_of(const glm::dvec3& axis, Random& random)
{
    const glm::dvec3 other(random.unit_vector());
    return normalize(cross(axis, std::abs(dot(axis, other)) < 0.9 ? other : glm::dvec3(axis.y, axis.z, -axis.x)));
}

/// Turns every vertex by the same random rotation about the origin, computed in double and rounded once.
inline void turn(IndexedMesh& mesh, Random& random)
{
    const glm::dvec3 z(random.unit_vector());
    const glm::dvec3 x = aside_of(z, random);
    const glm::dmat3 rotation(x, cross(z, x), z);
    for (glm::vec3& position : mesh.positions) position = glm::vec3(rotation * glm::dvec3(position));
}

/// Turns the corners of every triangle round, so that any of them may come first.
inline void begin_anywhere(IndexedMesh& mesh, Random& random)
{
    for (glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<int>(random.below(3));
        t = {t[first], t[(first + 1) % 3], t[(first + 2) % 3]};
    }
}

/// The positions of a mesh under a map that keeps its triangles.
template <class Map>
IndexedMesh mapped(IndexedMesh mesh, Map map)
{
    for (glm::vec3& position : mesh.positions) position = map(position);
    return mesh;
}

/// Adds triangles of their own three vertices each.
inline void add_triangle(IndexedMesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

/// `count` triangles with corners within 3 of the origin; the angle at their first corner has this sine, but for the
/// rounding of the corners.
inline IndexedMesh sliver_triangles(double sine, int count, Random& random)
{
    IndexedMesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 along(random.unit_vector());
        const glm::dvec3 aside = aside_of(along, random);
        const glm::dvec3 corner(random.in_cube());
        const double stretch = 0.5 + random.uniform_double();
        add_triangle(mesh, glm::vec3(corner), glm::vec3(corner + along),
                     glm::vec3(corner + stretch * (along + sine * aside)));
    }
    return mesh;
}

/// `count` folds of two triangles each: the two enclose this angle (radians), so that their normals all but cancel
/// along the edge they share.
inline IndexedMesh sharp_folds(double angle, int count, Random& random)
{
    IndexedMesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        IndexedMesh fold{
            {{0, 0, 0}, {0, 0, 1}, {1, 0, random.uniform()}, {std::cos(angle), std::sin(angle), random.uniform()}}, {}};
        turn(fold, random);
        mesh.positions.insert(mesh.positions.end(), fold.positions.begin(), fold.positions.end());
        mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 3, first + 1}});
    }
    return mesh;
}

/// A closed tube along a trefoil knot, outward: `along` rings of `around` vertices.
inline IndexedMesh trefoil(std::uint32_t along, std::uint32_t around, double radius)
{
    constexpr double full_turn = 6.283185307179586;
    const auto centre = [](double t) {
        const double distance = 2 + std::cos(3 * t);
        return glm::dvec3(distance * std::cos(2 * t), distance * std::sin(2 * t), 1.15 * std::sin(3 * t));
    };
    IndexedMesh mesh;
    for (std::uint32_t ring = 0; ring < along; ++ring) {
        const double t = full_turn * ring / along;
        const glm::dvec3 forward = normalize(centre(t + 1e-3) - centre(t - 1e-3));
        // Out of the torus on which the knot lies: never parallel to the knot, so that rings do not twist.
        const glm::dvec3 spine = 2.0 * glm::dvec3(std::cos(2 * t), std::sin(2 * t), 0);
        const glm::dvec3 side = normalize(cross(forward, centre(t) - spine));
        const glm::dvec3 up = cross(side, forward);
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = full_turn * (i + 0.5 * (ring % 2)) / around;
            mesh.positions.emplace_back(centre(t) + radius * (std::cos(angle) * up + std::sin(angle) * side));
        }
    }
    for (std::uint32_t ring = 0; ring < along; ++ring) {
        const std::uint32_t next = (ring + 1) % along * around;
        const std::uint32_t shift = ring % 2;
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t here = ring * around;
            const std::uint32_t j = (i + 1) % around;
            // Odd rings are turned by half a step: two triangles that are as equilateral as the curve allows.
            if (shift == 0)
                mesh.triangles.insert(mesh.triangles.end(),
                                      {{here + i, here + j, next + i}, {here + j, next + j, next + i}});
            else
                mesh.triangles.insert(mesh.triangles.end(),
                                      {{here + i, next + j, next + i}, {here + i, here + j, next + j}});
        }
    }
    return mesh;
}

}
