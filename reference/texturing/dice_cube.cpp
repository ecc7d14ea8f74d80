// Based on: C. Ureña. Informática Gráfica, problems 3.10 to 3.12.

#include <algorithm>
#include <array>
#include <umbral/texturing/dice_cube.hpp>

namespace umbral::texturing {
namespace {

// A face of the unit cube by one of its corners and the sides that leave it, anticlockwise as seen from outside, and
// the part of the texture that it shows: the coordinates at that corner, and how they change along the two sides.
struct Face {
    glm::vec3 corner, along, up;
    glm::vec2 coordinates, u_along, v_up;
};

// Vertices at one place of the texture and of space are one vertex. If `lit`, they must also have the same normal.
TexturedCube assembled(const std::array<Face, 6>& faces, bool lit)
{
    TexturedCube cube;
    const auto vertex = [&](const glm::vec3& position, const glm::vec2& coordinates, const glm::vec3& normal) {
        for (unsigned i = 0; i < cube.positions.size(); ++i)
            if (cube.positions[i] == position && distance(cube.coordinates[i], coordinates) < 1e-3F &&
                (!lit || cube.normals[i] == normal))
                return i;
        cube.positions.push_back(position);
        cube.coordinates.push_back(coordinates);
        if (lit) cube.normals.push_back(normal);
        return static_cast<unsigned>(cube.positions.size() - 1);
    };
    for (const Face& face : faces) {
        std::array<unsigned, 4> corners{};
        constexpr glm::vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [s, t] = std::pair(square[k].x, square[k].y);
            corners[k] = vertex(face.corner + s * face.along + t * face.up,
                                face.coordinates + s * face.u_along + t * face.v_up, cross(face.along, face.up));
        }
        cube.triangles.emplace_back(corners[0], corners[1], corners[2]);
        cube.triangles.emplace_back(corners[0], corners[2], corners[3]);
    }
    return cube;
}

constexpr glm::vec3 x(1, 0, 0);
constexpr glm::vec3 y(0, 1, 0);
constexpr glm::vec3 z(0, 0, 1);

// A face of the net, by the column and row of its cell from the lower left.
Face cell(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up, int column, int row)
{
    const glm::vec2 size(1.0F / 4, 1.0F / 3);
    return {corner, along, up, size * glm::vec2(column, row), {size.x, 0}, {0, size.y}};
}

std::array<Face, 6> net()
{
    return {cell(z, x, y, 2, 1),          // 1
            cell(x + z, -z, y, 3, 1),     // 2
            cell(y + z, x, -z, 2, 2),     // 3
            cell({0, 0, 0}, x, z, 2, 0),  // 4
            cell({0, 0, 0}, z, y, 1, 1),  // 5
            cell(x, -x, y, 0, 1)};        // 6
}

}

TexturedCube dice_cube() { return assembled(net(), false); }

TexturedCube lit_dice_cube() { return assembled(net(), true); }

TexturedCube replicated_cube()
{
    constexpr glm::vec2 u(1, 0);
    constexpr glm::vec2 v(0, 1);
    constexpr glm::vec2 origin(0, 0);
    // Of the 4^6 ways to turn the six images, 128 need 14 vertices, and none needs fewer: here those on the front and
    // the back lie on their sides.
    return assembled(
        {Face{x + z, -z, y, origin, u, v}, Face{{0, 0, 0}, z, y, origin, u, v}, Face{y + z, x, -z, origin, u, v},
         Face{{0, 0, 0}, x, z, origin, u, v}, Face{z, x, y, u, v, -u}, Face{x, -x, y, u, v, -u}},
        false);
}

}
