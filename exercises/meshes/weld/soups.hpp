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
/// smallest there are apart. One sheet lies near the origin. Of another one an axis runs from 1000 to 1024, where
/// floats are closest for their decimals: who writes them with eight digits makes one number of two.
inline Soup soup_of_close_places(Random& random)
{
    Soup soup;
    const int axis = static_cast<int>(random.below(3));
    for (const bool is_far : {false, true}) {
        Soup sheet = soup_of(shuffled(hills(5, 4, random), random));
        for (glm::vec3& corner : sheet) {
            if (!is_far) continue;
            std::swap(corner.y, corner[axis]);
            corner[axis] = 1012 + 8 * corner[axis];
        }
        Soup shifted = sheet;
        for (glm::vec3& corner : shifted) {
            float& moved = is_far ? corner[axis] : corner.y;
            moved = std::nextafter(moved, 2000.0F);
        }
        soup.insert(soup.end(), sheet.begin(), sheet.end());
        soup.insert(soup.end(), shifted.begin(), shifted.end());
    }
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

/// 3 `cells` squares. A third lies in the plane x = y, as in every model that is turned by 45 degrees: whatever is made
/// of x and y by exclusive or is 0 there. A third lies in the plane x + y + z = 1, where the sum of the coordinates
/// says nothing; it is exact, since all are multiples of 1/1024. The others are strips along each of the axes, half of
/// whose vertices lie on it: there a product of hashes is 0. All have two rows of vertices, so that who hashes a row
/// alike, because coordinates cancel or one is forgotten, takes time n².
inline Soup aligned_soup(std::uint32_t cells, Random& random)
{
    IndexedMesh mesh;
    const auto add = [&](std::uint32_t columns, const auto& place) {
        mesh = joined(mesh, sheet(columns, 1, [&](std::uint32_t column, std::uint32_t row) {
                          const auto along = static_cast<float>(1024 * column + random.below(512));
                          return place(along / 1024, static_cast<float>(row));
                      }));
    };
    add(cells, [](float along, float row) { return glm::vec3(along, along, row); });
    add(cells, [](float along, float row) { return glm::vec3(along, row, 1 - along - row); });
    for (int axis = 0; axis < 3; ++axis)
        add(cells / 3, [&](float along, float row) {
            glm::vec3 corner(row);
            corner[axis] = along;
            return corner;
        });
    return soup_of(shuffled(mesh, random));
}

/// More vertices than 16 bits can count: a field of heights, corner by corner, and at the end `count` triangles between
/// its corners, one of each of them behind the first 65,536.
inline Soup soup_of_many_places(std::size_t count, Random& random)
{
    constexpr std::uint32_t columns = 257;
    constexpr std::uint32_t rows = 258;
    Soup soup;
    for (std::uint32_t i = 0; i < columns * rows; ++i)
        soup.emplace_back(static_cast<float>(i % columns), random.uniform(), static_cast<float>(i / columns));
    for (std::size_t i = 0; i < count; ++i) {
        constexpr std::uint32_t first_late = 65'536;
        std::array<glm::vec3, 3> corners{};
        for (glm::vec3& corner : corners) corner = soup[random.below(columns * rows)];
        corners.at(i % 3) = soup[first_late + random.below(columns * rows - first_late)];
        soup.insert(soup.end(), corners.begin(), corners.end());
    }
    return soup;
}

/// `count` triangles between six vertices: many more than vertices, as no closed surface in space has.
inline IndexedMesh of_few_vertices(std::size_t count, Random& random)
{
    IndexedMesh mesh = octahedron();
    mesh.triangles.clear();
    for (std::size_t i = 0; i < count; ++i) {
        glm::uvec3 t(0);
        for (int corner = 0; corner < 3; ++corner) t[corner] = random.below(6);
        mesh.triangles.push_back(t);
    }
    return mesh;
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
