#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

/// What the drivers of lighting share: shapes with unit normals that point outwards, lights and materials.
namespace umbral::lighting {

/// Triangles, anticlockwise as seen from outside.
struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
};

/// A source of light in eye coordinates: w = 1 a place, w = 0 a direction towards the light, of any length.
struct Light {
    glm::vec4 position;
    glm::vec3 color;
};

struct Material {
    glm::vec3 emission{0};
    glm::vec3 ambient{0};
    glm::vec3 diffuse{0};
    glm::vec3 specular{0};
    float shininess = 1;
};

/// Joins the vertices of a grid of `columns` x `rows` cells, row by row, into triangles.
inline void join_grid(Shape& shape, int columns, int rows)
{
    const auto at = [&](int column, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t corners[] = {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)};
            for (const int i : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(corners[i]);
        }
}

/// A surface given by point(u, v) for u, v in [0, 1], its normal the cross product of the tangents along u and v.
template <class Point>
Shape surface(int columns, int rows, Point point)
{
    Shape shape;
    constexpr float step = 1e-3F;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(columns);
            const float v = static_cast<float>(row) / static_cast<float>(rows);
            shape.positions.push_back(point(u, v));
            shape.normals.push_back(normalize(cross(point(u + step, v) - point(u - step, v), point(u, v + step) - point(u, v - step))));
        }
    join_grid(shape, columns, rows);
    return shape;
}

inline constexpr float turn = 6.2831853F;

/// The unit sphere from its south pole up to the height `top` (1: closed), by longitude and latitude.
inline Shape sphere(int longitudes, int latitudes, float top = 1)
{
    Shape shape;
    const float last = std::acos(-top);
    for (int row = 0; row <= latitudes; ++row)
        for (int column = 0; column <= longitudes; ++column) {
            const float longitude = turn * static_cast<float>(column) / static_cast<float>(longitudes);
            const float polar = last * static_cast<float>(row) / static_cast<float>(latitudes);
            shape.positions.emplace_back(std::sin(polar) * std::sin(longitude), -std::cos(polar), std::sin(polar) * std::cos(longitude));
        }
    shape.normals = shape.positions;
    join_grid(shape, longitudes, latitudes);
    return shape;
}

/// An icosahedron with its corners on the unit sphere, each triangle divided in four `times` times.
inline Shape icosphere(int times)
{
    const float golden = (1 + std::sqrt(5.0F)) / 2;
    Shape shape;
    shape.positions = {{-1, golden, 0},  {1, golden, 0},  {-1, -golden, 0}, {1, -golden, 0}, {0, -1, golden},  {0, 1, golden},
                       {0, -1, -golden}, {0, 1, -golden}, {golden, 0, -1},  {golden, 0, 1},  {-golden, 0, -1}, {-golden, 0, 1}};
    shape.indices = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                     3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
    for (int i = 0; i < times; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size()));
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
        return glm::vec3(distance * std::cos(2 * turn * u), distance * std::sin(2 * turn * u), 0.34F * std::sin(3 * turn * u));
    });
}

/// The square [-1, 1]² in x and z with waves of that height, its outside upwards.
inline Shape waves(int cells, float height)
{
    return surface(cells, cells, [&](float u, float v) {
        const float x = 2 * u - 1;
        const float z = 1 - 2 * v;
        return glm::vec3(x, height * std::sin(7 * x + 2 * z) * std::cos(6 * z - x), z);
    });
}

}
