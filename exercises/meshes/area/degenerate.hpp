#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <utility>

#include "../support.hpp"

/// Meshes and triangles in which something is out of the ordinary.
namespace umbral::meshes {

/// The mesh with a vertex that no triangle has, behind the first `place` ones.
inline IndexedMesh with_unused(IndexedMesh mesh, std::size_t place, const glm::vec3& position)
{
    mesh.positions.insert(mesh.positions.begin() + static_cast<std::ptrdiff_t>(place), position);
    for (glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) t[i] += t[i] >= place ? 1 : 0;
    return mesh;
}

/// A small hilly mesh with triangles without area, and with some that come twice in a row, at any places. Of four such
/// meshes two have a broken corner, one has a broken vertex that no triangle has, and one such a vertex far away; the
/// latter two first, last or in between. Corners are multiples of 1/64, so that what is degenerate is so in any
/// arithmetic.
inline IndexedMesh degenerate_mesh(int kind, Random& random)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float broken[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity};
    IndexedMesh mesh =
        mapped(hills(2, 2, random), [](const glm::vec3& position) { return round(64.0F * position) / 64.0F; });
    // A copy of a corner, and one on a line with two others.
    mesh.positions.insert(mesh.positions.end(), {mesh.positions[4], 2.0F * mesh.positions[1] - mesh.positions[0]});
    mesh.triangles.insert(mesh.triangles.end(), {{3, 3, 5}, {5, 8, 8}, {6, 7, 6}, {4, 9, 7}, {0, 1, 10}, {2, 2, 2}});
    const std::uint32_t other = 1 + random.below(8);
    mesh.triangles.push_back(random.below(2) == 0 ? glm::uvec3(0, 0, other) : glm::uvec3(0, other, 0));
    mesh.triangles = in_random_order(random, std::move(mesh.triangles));
    // The first, the last, or any.
    const auto any_place = [&](std::size_t count) {
        const auto last = static_cast<std::uint32_t>(count - 1);
        const std::uint32_t within = random.below(last + 1);
        const std::uint32_t which = random.below(3);
        return which == 0 ? 0 : which == 1 ? last : within;
    };
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t place = any_place(mesh.triangles.size());
        const glm::uvec3 t = mesh.triangles[place];
        const glm::uvec3 again = i == 0 ? t : i == 1 ? glm::uvec3(t.y, t.z, t.x) : glm::uvec3(t.z, t.y, t.x);
        mesh.triangles.insert(mesh.triangles.begin() + place, again);
    }
    const int coordinate = kind / 4 % 3;
    if (kind % 2 == 0) mesh.positions[random.below(9)][coordinate] = broken[random.below(3)];
    // Every second time there are more vertices than triangles.
    if (kind % 4 == 1)
        for (int left = kind % 8 == 1 ? 1 : 12; left > 0; --left) {
            glm::vec3 lost(9);
            lost[coordinate] = broken[random.below(3)];
            mesh = with_unused(mesh, any_place(mesh.positions.size() + 1), lost);
        }
    if (kind % 4 == 3)
        mesh = with_unused(mesh, any_place(mesh.positions.size() + 1), 1e30F * (1.5F + random.in_cube()));
    return mesh;
}

/// A triangle of which x, y and z are called y, z and x, or z, x and y, after `turns`.
inline void add_turned(IndexedMesh& mesh, const glm::vec3 (&corners)[3], int turns)
{
    const auto turned = [turns](const glm::vec3& p) {
        return glm::vec3(p[turns % 3], p[(turns + 1) % 3], p[(turns + 2) % 3]);
    };
    add_triangle(mesh, turned(corners[0]), turned(corners[1]), turned(corners[2]));
}

/// `count` triangles that are much thinner than floats are apart where their corners lie, so that a tolerance takes
/// them for lines; but one coordinate of theirs is next to 0. All products in their areas are nearly exact in double.
inline IndexedMesh thin_triangles(int count, Random& random)
{
    IndexedMesh mesh;
    for (int i = 0; i < count; ++i) {
        const float height = std::pow(10.0F, random.uniform(-12, -6.5F));
        const float y = random.uniform(-2, 2);
        const float x = random.uniform(-2, 2);
        const float away = random.uniform(0.5F, 2);
        const glm::vec3 corners[3] = {{x, y, 0}, {x + away, y, 0}, {random.uniform(-2, 2), y, height}};
        add_turned(mesh, corners, i);
    }
    begin_anywhere(mesh, random);
    return mesh;
}

/// `count` triangles of which two coordinates are so large that their squares and their sum are no floats; areas are.
inline IndexedMesh triangles_next_to_the_largest_float(int count, Random& random)
{
    IndexedMesh mesh;
    for (int i = 0; i < count; ++i) {
        const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
        const float x = sign * random.uniform(2e38F, 3.3e38F);
        const float y = sign * random.uniform(2e38F, 3.3e38F);
        const float step = sign * std::exp2(104.0F + static_cast<float>(random.below(3)));  // one float, two or four
        const float height = std::pow(10.0F, random.uniform(-3, 3));
        const glm::vec3 corners[3] = {
            {x, y, height}, {x, y + step, random.uniform(-1, 1)}, {x, y, -random.uniform(1, 2)}};
        add_turned(mesh, corners, i);
    }
    begin_anywhere(mesh, random);
    return mesh;
}

}
