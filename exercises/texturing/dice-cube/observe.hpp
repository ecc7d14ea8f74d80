#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <umbral/core/random.hpp>
#include <umbral/texturing/dice_cube.hpp>

/// What the driver sees of a cube whose tables may be in any order: its faces, looked at from outside.
namespace umbral::texturing {

/// A face by its lower left corner and its sides.
struct Side {
    glm::vec3 corner, along, up;

    [[nodiscard]] glm::vec3 at(glm::vec2 place) const { return corner + place.x * along + place.y * up; }
    [[nodiscard]] glm::vec3 normal() const { return cross(along, up); }
};

inline constexpr std::array<Side, 6> sides = {Side{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},    // front
                                              Side{{1, 0, 1}, {0, 0, -1}, {0, 1, 0}},   // right
                                              Side{{0, 1, 1}, {1, 0, 0}, {0, 0, -1}},   // top
                                              Side{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},    // bottom
                                              Side{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},    // left
                                              Side{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}};  // back

inline constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// A triangle whose vertices exist; coordinates and normals that are missing are not a number.
struct Corner {
    glm::vec3 position;
    glm::vec2 coordinates{no_value};
    glm::vec3 normal{no_value};
};
using Triangle = std::array<Corner, 3>;

inline std::vector<Triangle> triangles_of(const TexturedCube& cube)
{
    std::vector<Triangle> result;
    for (const glm::uvec3& indices : cube.triangles) {
        Triangle triangle{};
        bool exists = true;
        for (int k = 0; k < 3; ++k) {
            const std::size_t i = indices[k];
            exists = exists && i < cube.positions.size();
            if (!exists) break;
            Corner& corner = triangle[static_cast<std::size_t>(k)];
            corner.position = cube.positions[i];
            if (i < cube.coordinates.size()) corner.coordinates = cube.coordinates[i];
            if (i < cube.normals.size()) corner.normal = cube.normals[i];
        }
        if (exists) result.push_back(triangle);
    }
    return result;
}

/// The weights of a triangle's corners at a point of its plane; nothing where the plane is another one or the triangle
/// has no area.
inline std::optional<glm::vec3> weights(const Triangle& triangle, const glm::vec3& point)
{
    const glm::vec3 a = triangle[0].position;
    const glm::vec3 normal = cross(triangle[1].position - a, triangle[2].position - a);
    const float square = dot(normal, normal);
    if (!(square > 1e-6F) || std::abs(dot(normal, point - a)) > 1e-4F * std::sqrt(square)) return std::nullopt;
    glm::vec3 result(0);
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 from = triangle[static_cast<std::size_t>((k + 1) % 3)].position;
        const glm::vec3 to = triangle[static_cast<std::size_t>((k + 2) % 3)].position;
        result[k] = dot(cross(to - from, point - from), normal) / square;
    }
    return result;
}

/// What lies at a place of a side: how many triangles that face outward, how many inward, and what the only outward one
/// has there.
struct Seen {
    glm::vec2 covers{0};
    glm::vec2 coordinates{no_value};
    glm::vec3 normal{no_value};
};

inline Seen seen(const std::vector<Triangle>& triangles, const Side& side, glm::vec2 place)
{
    Seen result;
    for (const Triangle& triangle : triangles) {
        const std::optional<glm::vec3> w = weights(triangle, side.at(place));
        if (!w || w->x < 0 || w->y < 0 || w->z < 0) continue;
        const glm::vec3 normal =
            cross(triangle[1].position - triangle[0].position, triangle[2].position - triangle[0].position);
        const bool outward = dot(normal, side.normal()) > 0;
        result.covers[outward ? 0 : 1] += 1;
        if (!outward) continue;
        result.coordinates =
            w->x * triangle[0].coordinates + w->y * triangle[1].coordinates + w->z * triangle[2].coordinates;
        result.normal = w->x * triangle[0].normal + w->y * triangle[1].normal + w->z * triangle[2].normal;
    }
    if (result.covers.x != 1) {
        result.coordinates = glm::vec2(no_value);
        result.normal = glm::vec3(no_value);
    }
    return result;
}

/// The coordinates of a side's corners, anticlockwise, from the one that is nearest to (0, 0); not a number where the
/// triangles that meet there disagree.
inline std::array<glm::vec2, 4> corners_of(const std::vector<Triangle>& triangles, const Side& side)
{
    constexpr float inset = 1e-3F;
    constexpr glm::vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::array<glm::vec2, 4> result{};
    std::size_t first = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        // Just inside the corner, on both sides of its diagonal.
        const glm::vec2 inwards = inset * (glm::vec2(1) - 2.0F * square[k]);
        const glm::vec2 a = seen(triangles, side, square[k] + inwards * glm::vec2(1, 0.5F)).coordinates;
        const glm::vec2 b = seen(triangles, side, square[k] + inwards * glm::vec2(0.5F, 1)).coordinates;
        result[k] = distance(a, b) < 8 * inset ? 0.5F * (a + b) : glm::vec2(no_value);
        if (length(result[k]) < length(result[first])) first = k;
    }
    std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(first), result.end());
    return result;
}

}
