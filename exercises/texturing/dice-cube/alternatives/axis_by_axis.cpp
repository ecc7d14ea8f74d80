// alternative: the faces by axis and side, and the vertices looked up in a map
#include <map>
#include <tuple>
#include <umbral/texturing/dice_cube.hpp>

namespace umbral::texturing {
namespace {

using Key = std::tuple<int, int, int, int, int, int>;  // twelfths of the texture, and the face where that counts

struct Builder {
    TexturedCube cube;
    std::map<Key, unsigned> known;

    unsigned add(glm::ivec3 p, glm::ivec2 twelfths, int face)
    {
        const auto [entry, is_new] = known.try_emplace({p.x, p.y, p.z, twelfths.x, twelfths.y, face}, known.size());
        if (is_new) {
            cube.positions.emplace_back(p);
            cube.coordinates.push_back(glm::vec2(twelfths) / 12.0F);
        }
        return entry->second;
    }

    void quad(unsigned a, unsigned b, unsigned c, unsigned d)
    {
        cube.triangles.emplace_back(d, a, b);
        cube.triangles.emplace_back(b, c, d);
    }
};

TexturedCube dice(bool lit)
{
    Builder builder;
    const auto face = [&](int number, glm::ivec3 a, glm::ivec3 b, glm::ivec3 c, glm::ivec3 d, int column, int row) {
        const glm::ivec2 low(3 * column, 4 * row);
        const int mark = lit ? number : 0;
        builder.quad(builder.add(a, low, mark), builder.add(b, low + glm::ivec2(3, 0), mark),
                     builder.add(c, low + glm::ivec2(3, 4), mark), builder.add(d, low + glm::ivec2(0, 4), mark));
        if (!lit) return;
        const glm::vec3 normal = cross(glm::vec3(b - a), glm::vec3(d - a));
        builder.cube.normals.resize(builder.cube.positions.size(), normal);
    };
    face(1, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, 2, 1);
    face(2, {1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, 3, 1);
    face(3, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0}, 2, 2);
    face(4, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, 2, 0);
    face(5, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}, 1, 1);
    face(6, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, 0, 1);
    return builder.cube;
}

}

TexturedCube dice_cube() { return dice(false); }

TexturedCube lit_dice_cube() { return dice(true); }

TexturedCube replicated_cube()
{
    Builder builder;
    const auto face = [&](int turned, glm::ivec3 a, glm::ivec3 b, glm::ivec3 c, glm::ivec3 d) {
        constexpr int around[][2] = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
        unsigned corners[4];
        int k = turned;
        for (const glm::ivec3 p : {a, b, c, d}) {
            corners[k - turned] = builder.add(p, {around[k % 4][0], around[k % 4][1]}, 0);
            ++k;
        }
        builder.quad(corners[0], corners[1], corners[2], corners[3]);
    };
    face(0, {1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1});
    face(0, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0});
    face(2, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0});
    face(0, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
    face(3, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
    face(1, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0});
    return builder.cube;
}

}
