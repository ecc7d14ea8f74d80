#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

#include "../zoo.hpp"

/// Isolated triangles, three positions each, to be welded.
namespace umbral::meshes {

using Soup = std::vector<glm::vec3>;

inline Soup soup_of(const IndexedMesh& mesh)
{
    Soup soup;
    for (const glm::uvec3& t : mesh.triangles)
        soup.insert(soup.end(), {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    return soup;
}

/// Sheets in the planes of coordinates: a third of the coordinates are zeros, and about half of these zeros are
/// negative.
inline Soup soup_of_two_zeros(Random& random)
{
    Soup soup;
    for (int axis = 0; axis < 3; ++axis) {
        const IndexedMesh plane = mapped(flat_sheet(4, 4), [&](const glm::vec3& p) {
            glm::vec3 turned(0);
            turned[(axis + 1) % 3] = p.x;
            turned[(axis + 2) % 3] = p.z;
            return turned;
        });
        for (const glm::vec3& corner : soup_of(shuffled(plane, random))) soup.push_back(corner);
    }
    for (glm::vec3& corner : soup)
        for (int i = 0; i < 3; ++i)
            if (corner[i] == 0 && random.below(2) == 1) corner[i] = -0.0F;
    return soup;
}

/// Each triangle of a sheet comes twice, the second time one float further along one axis; and two numbers that are the
/// smallest there are apart.
inline Soup soup_of_close_places(Random& random)
{
    Soup soup = soup_of(shuffled(hills(5, 4, random), random));
    Soup shifted = soup;
    for (glm::vec3& corner : shifted) corner.y = std::nextafter(corner.y, 100.0F);
    soup.insert(soup.end(), shifted.begin(), shifted.end());
    const float smallest = std::numeric_limits<float>::denorm_min();
    soup.insert(soup.end(),
                {{smallest, 0, 0}, {0, 0, 0}, {2 * smallest, 0, 0}, {0, smallest, 0}, {0, 0, 0}, {0, 0, smallest}});
    return soup;
}

/// A sheet some of whose corners are not numbers, or are infinite; and triangles all of whose corners are the same but
/// not in one place, since one coordinate is NaN.
inline Soup soup_of_broken_corners(Random& random)
{
    Soup soup = soup_of(shuffled(hills(5, 4, random), random));
    const auto some = [&]() -> float& {
        return soup[random.below(static_cast<std::uint32_t>(soup.size()))][static_cast<int>(random.below(3))];
    };
    for (int i = 0; i < 16; ++i) some() = std::numeric_limits<float>::quiet_NaN();
    const glm::vec3 far(std::numeric_limits<float>::infinity(), 1, -std::numeric_limits<float>::infinity());
    for (int i = 0; i < 8; ++i) soup[random.below(static_cast<std::uint32_t>(soup.size()))] = far;
    soup.insert(soup.end(), 3, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 corner = soup[random.below(30)];
        corner[axis] = std::numeric_limits<float>::quiet_NaN();
        soup.insert(soup.end(), 3, corner);
    }
    return soup;
}

/// 60 triangles whose corners are at 27 places: one in nine has two corners in one place, or all three.
inline Soup soup_of_few_places(Random& random)
{
    constexpr std::array coordinates{-1.0F, 1.0F, 2.0F};
    const auto coordinate = [&] { return coordinates.at(random.below(3)); };
    Soup soup;
    for (int i = 0; i < 180; ++i) {
        const float x = coordinate();
        const float y = coordinate();
        soup.emplace_back(x, y, coordinate());
    }
    return soup;
}

/// 3 `cells` squares. Two of three lie in the plane x = y, as every model has that is turned by 45 degrees: whatever is
/// made of x and y by exclusive or is 0 there. The others are strips along each of the axes. All have two rows or one,
/// so that who hashes a row alike, because coordinates cancel or one is forgotten, takes time n².
inline Soup aligned_soup(std::uint32_t cells, Random& random)
{
    IndexedMesh mesh;
    const auto add = [&](std::uint32_t columns, std::uint32_t rows, const auto& place) {
        mesh = joined(mesh, sheet(columns, rows, [&](std::uint32_t column, std::uint32_t row) {
                          return place(static_cast<float>(column) + 0.5F * random.uniform(), static_cast<float>(row));
                      }));
    };
    add(cells, 2, [](float along, float row) { return glm::vec3(along, along, row); });
    for (int axis = 0; axis < 3; ++axis)
        add(cells / 3, 1, [&](float along, float row) {
            glm::vec3 corner(row - 9);
            corner[axis] = along;
            return corner;
        });
    return soup_of(shuffled(mesh, random));
}

/// Triangles that name a vertex twice or three times among others, and two vertices in one place.
inline IndexedMesh with_coinciding_corners(Random& random)
{
    IndexedMesh mesh = octahedron();
    mesh.positions.push_back(mesh.positions.front());
    mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 1}, {2, 3, 2}, {4, 5, 5}, {3, 3, 3}, {6, 0, 2}});
    return shuffled(mesh, random);
}

}
