#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::texturing {

/// Tables of an indexed mesh with texture coordinates: entry i of `positions`, `coordinates` and, if there are any,
/// `normals` belongs to vertex i; `triangles` are triples of vertices, anticlockwise as seen from outside.
struct TexturedCube {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> coordinates;
    std::vector<glm::vec3> normals;  ///< unit, outward; empty where the cube is not lit
    std::vector<glm::uvec3> triangles;
};

/// The unit cube [0, 1]³ in a texture of the proportions 4 : 3 that shows the faces of a die, unfolded.
///
/// The texture has 4 x 3 square cells, of which the net takes six; (u, v) = (0, 0) is its lower left corner:
///
///             0    1/4   1/2   3/4    1
///          1  .     .     +-----+     .        . a corner of the grid that no face touches
///                         |  3  |              (three of the five above, three of the five below)
///        2/3  +-----+-----+-----+-----+
///             |  6  |  5  |  1  |  2  |
///        1/3  +-----+-----+-----+-----+
///                         |  4  |
///          0  .     .     +-----+     .
///
/// The 1 is the front face, z = 1, and stands upright: seen from outside, u grows along +x and v along +y. The others
/// are folded back from it round the cube like paper: 2 is x = 1, 5 is x = 0, 3 is y = 1, 4 is y = 0, and 6, which
/// hangs on the 5, is z = 0. No face is mirrored.
///
/// Without normals, 12 triangles, and **as few vertices as possible**: two faces share a vertex where they have the
/// same position and the same coordinates there. Coordinates are right to 1e-6. Course: problem 3.10.
[[nodiscard]] TexturedCube dice_cube();

/// The same cube and texture for lighting: each face has one normal. Again as few vertices as possible, 12 triangles.
/// Course: problem 3.11.
[[nodiscard]] TexturedCube lit_dice_cube();

/// The cube [0, 1]³ with a whole square image on each face: the coordinates of its four corners, anticlockwise as seen
/// from outside, are (0, 0), (1, 0), (1, 1), (0, 1). With which corner of the face they begin is free, for each face
/// alone, so that the image may lie on its side, but it is never mirrored. Coordinates are 0 or 1 (the texture is not
/// repeated). Without normals, 12 triangles, and as few vertices as that allows. Course: problem 3.12.
[[nodiscard]] TexturedCube replicated_cube();

}
