#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

/// Shapes for pictures: triangles with unit normals that point outwards. Vertices where a surface meets itself come
/// twice.
namespace umbral::shapes {

/// A full turn, in radians.
inline constexpr float turn = 6.2831853F;

/// Triangles, anticlockwise as seen from outside.
struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;

    /// Adds a parallelogram of four vertices of its own.
    void quad(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up)
    {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {corner, corner + along, corner + along + up, corner + up});
        normals.insert(normals.end(), 4, normalize(cross(along, up)));
        indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
};

/// Joins the last vertices of a shape, a grid of `columns` x `rows` cells that comes row by row, into triangles.
inline void join_grid(Shape& shape, int columns, int rows)
{
    const auto first = static_cast<int>(shape.positions.size()) - (columns + 1) * (rows + 1);
    const auto at = [&](int column, int row) {
        return static_cast<std::uint32_t>(first + row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t corners[] = {at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                             at(column, row + 1)};
            for (const int i : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(corners[i]);
        }
}

/// A point of a surface and its normal there.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
};

/// A surface given by vertex(u, v) for u, v in [0, 1]. Its outside is where v grows to the left of u.
template <class At>
Shape woven(int columns, int rows, At vertex)
{
    Shape shape;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const Vertex next = vertex(static_cast<float>(column) / static_cast<float>(columns),
                                       static_cast<float>(row) / static_cast<float>(rows));
            shape.positions.push_back(next.position);
            shape.normals.push_back(next.normal);
        }
    join_grid(shape, columns, rows);
    return shape;
}

/// A surface given by point(u, v) for u, v in [0, 1], its normal the cross product of the tangents along u and v.
template <class Point>
Shape surface(int columns, int rows, Point point)
{
    constexpr float step = 1e-3F;
    return woven(columns, rows, [&](float u, float v) {
        const glm::vec3 normal =
            cross(point(u + step, v) - point(u - step, v), point(u, v + step) - point(u, v - step));
        return Vertex{point(u, v), normalize(normal)};
    });
}

/// The unit sphere from its south pole up to the height `top` (1: closed), by longitude and latitude.
inline Shape sphere(int longitudes, int latitudes, float top = 1)
{
    const float last = std::acos(-top);
    return woven(longitudes, latitudes, [&](float u, float v) {
        const float polar = last * v;
        const glm::vec3 place(std::sin(polar) * std::sin(turn * u), -std::cos(polar),
                              std::sin(polar) * std::cos(turn * u));
        return Vertex{place, place};
    });
}

/// An icosahedron with its corners on the unit sphere, each triangle divided in four `times` times.
inline Shape icosphere(int times)
{
    const float golden = (1 + std::sqrt(5.0F)) / 2;
    Shape shape;
    shape.positions = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                       {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                       {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    shape.indices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                     4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                     6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int i = 0; i < times; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size()));
            if (fresh) shape.positions.push_back(normalize(shape.positions[a]) + normalize(shape.positions[b]));
            return found->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t first = 0; first < shape.indices.size(); first += 3) {
            const std::uint32_t a = shape.indices[first];
            const std::uint32_t b = shape.indices[first + 1];
            const std::uint32_t c = shape.indices[first + 2];
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        shape.indices = std::move(finer);
    }
    for (glm::vec3& position : shape.positions) position = normalize(position);
    shape.normals = shape.positions;
    return shape;
}

/// A tube of radius `thickness` round the closed curve centre(u); `centre` has period 1.
template <class Curve>
Shape tube(int along, int around, float thickness, Curve centre)
{
    return surface(along, around, [&](float u, float v) {
        constexpr float step = 2e-3F;
        const glm::vec3 tangent = normalize(centre(u + step) - centre(u - step));
        // Away from the axis, made perpendicular to the curve: never parallel to it for the curves below.
        const glm::vec3 outwards = centre(u) - glm::vec3(0, 0, centre(u).z);
        const glm::vec3 side = normalize(outwards - dot(outwards, tangent) * tangent);
        return centre(u) + thickness * (std::cos(turn * v) * side - std::sin(turn * v) * cross(tangent, side));
    });
}

/// A ring of radius 1 in the plane z = 0.
inline Shape torus(int along, int around, float thickness)
{
    return tube(along, around, thickness, [](float u) { return glm::vec3(std::cos(turn * u), std::sin(turn * u), 0); });
}

/// The knot that winds twice round the z axis and three times through itself.
inline Shape trefoil(int along, int around, float thickness)
{
    return tube(along, around, thickness, [](float u) {
        const float distance = 0.72F + 0.3F * std::cos(3 * turn * u);
        return glm::vec3(distance * std::cos(2 * turn * u), distance * std::sin(2 * turn * u),
                         0.34F * std::sin(3 * turn * u));
    });
}

/// The cube with corners at 0 and 1.
inline Shape box()
{
    Shape cube;
    cube.quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    cube.quad({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
    cube.quad({1, 0, 1}, {0, 0, -1}, {0, 1, 0});
    cube.quad({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    cube.quad({0, 1, 1}, {1, 0, 0}, {0, 0, -1});
    cube.quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    return cube;
}

/// An arrow along z from the origin, of length 1: the profile (height, radius) of shaft and head, turned round the
/// axis.
inline Shape arrow()
{
    constexpr glm::vec2 profile[] = {{0, 0.022F}, {0.78F, 0.022F}, {0.78F, 0.065F}, {1, 0}};
    constexpr int sides = 24;
    Shape shape;
    const auto around = [](float height, float radius, int side) {
        const float angle = turn * static_cast<float>(side) / sides;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle), height);
    };
    for (int part = 0; part < 3; ++part) {
        const glm::vec2 low = profile[part];
        const glm::vec2 high = profile[part + 1];
        const glm::vec2 slope = glm::normalize(glm::vec2(low.y - high.y, high.x - low.x));
        for (const glm::vec2& ring : {low, high})
            for (int side = 0; side <= sides; ++side) {
                shape.positions.push_back(around(ring.x, ring.y, side));
                shape.normals.push_back(around(slope.x, slope.y, side));
            }
        join_grid(shape, sides, 1);
    }
    return shape;
}

}
