// alternative: the tables written down by hand, other diagonals, and other turns of the replicated image
#include <umbral/texturing/dice_cube.hpp>

namespace umbral::texturing {

TexturedCube dice_cube()
{
    constexpr float a = 1.0F / 4, b = 2.0F / 4, c = 3.0F / 4, l = 1.0F / 3, h = 2.0F / 3;
    TexturedCube cube;
    cube.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0},
                      {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
    cube.coordinates = {{b, 0}, {c, 0}, {0, l}, {a, l}, {b, l}, {c, l}, {1, l},
                        {0, h}, {a, h}, {b, h}, {c, h}, {1, h}, {b, 1}, {c, 1}};
    cube.triangles = {{0, 1, 4}, {1, 5, 4},  {2, 3, 7},  {3, 8, 7},   {3, 4, 8},   {4, 9, 8},
                      {4, 5, 9}, {5, 10, 9}, {5, 6, 10}, {6, 11, 10}, {9, 10, 12}, {10, 13, 12}};
    return cube;
}

TexturedCube lit_dice_cube()
{
    const TexturedCube shared = dice_cube();
    TexturedCube cube;
    for (std::size_t t = 0; t < shared.triangles.size(); t += 2) {
        const glm::uvec3 lower = shared.triangles[t];
        const auto first = static_cast<unsigned>(cube.positions.size());
        const glm::vec3 normal = cross(shared.positions[lower.y] - shared.positions[lower.x],
                                       shared.positions[lower.z] - shared.positions[lower.x]);
        for (const unsigned i : {lower.x, lower.y, shared.triangles[t + 1].y, lower.z}) {
            cube.positions.push_back(shared.positions[i]);
            cube.coordinates.push_back(shared.coordinates[i]);
            cube.normals.push_back(normal);
        }
        cube.triangles.push_back({first + 3, first, first + 1});
        cube.triangles.push_back({first + 1, first + 2, first + 3});
    }
    return cube;
}

TexturedCube replicated_cube()
{
    TexturedCube cube;
    cube.positions = {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1},
                      {0, 1, 0}, {1, 1, 1}, {0, 1, 0}, {0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 0}};
    cube.coordinates = {{1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}, {1, 0}, {1, 1},
                        {0, 1}, {0, 1}, {1, 0}, {1, 1}, {0, 0}, {0, 0}, {1, 1}};
    cube.triangles = {{1, 2, 3},  {1, 3, 0},  {5, 6, 7},  {5, 7, 4},  {8, 2, 9},  {8, 9, 6},
                      {1, 11, 5}, {1, 5, 10}, {0, 8, 12}, {0, 12, 5}, {4, 9, 13}, {4, 13, 1}};
    return cube;
}

}
