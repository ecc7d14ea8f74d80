#include <array>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

// How many entries each table has, the tables by their number in the struct, from 1.
void record_sizes(Recorder& out, const TexturedCube& cube)
{
    out.columns("sizes", "table, entries");
    const std::size_t sizes[] = {cube.positions.size(), cube.coordinates.size(), cube.normals.size(),
                                 cube.triangles.size()};
    for (int i = 0; i < 4; ++i) out.append("sizes", glm::vec2(i + 1, sizes[i]));
}

// Away from edges and diagonals, so that no rounding decides which triangle it is.
glm::vec2 random_place(Random& random)
{
    const float slant = random.uniform(0.05F, 0.45F) + (random.below(2) == 0 ? 0.5F : 0.0F);
    const float off = random.uniform(0.06F, 0.44F);
    // (off, 1/2) turned to the left, right, lower or upper quarter of the square, and moved along.
    const glm::vec2 left(off, off + (1 - 2 * off) * slant);
    switch (random.below(4)) {
        case 0: return left;
        case 1: return glm::vec2(1) - left;
        case 2: return {left.y, left.x};
        default: return glm::vec2(1) - glm::vec2(left.y, left.x);
    }
}

// Calls `observe` for all faces, each by the number that the die shows there. Varied, the first one is another.
template <class Observe>
void for_each_face(Variation& vary, const Observe& observe)
{
    const std::size_t first = vary.one_of(0, std::array{1, 2, 3, 4, 5});
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::size_t face = (first + i) % sides.size();
        observe(static_cast<float>(face + 1), sides[face]);
    }
}

// The same twelve times each, with a random place on the face.
template <class Observe>
void record_faces(Case& c, const Observe& observe)
{
    for_each_face(c.vary, [&](float face, const Side& side) {
        for (int i = 0; i < 12; ++i) observe(face, side, random_place(c.random));
    });
}

// In pairs: one place on a side, and one in its plane beside it, where there must be nothing.
void record_covers(Recorder& out, const std::vector<Triangle>& triangles, Case& c)
{
    out.columns("covers", "face, outward triangles, inward triangles");
    record_faces(c, [&](float face, const Side& side, glm::vec2 on) {
        const glm::vec2 beside = on + (c.random.below(2) == 0 ? glm::vec2(1, 0) : glm::vec2(0, -1));
        const bool on_first = c.random.below(2) == 0;
        for (const glm::vec2 place : {on_first ? on : beside, on_first ? beside : on})
            out.append("covers", glm::vec3(face, seen(triangles, side, place).covers));
    });
}

void record_dice(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<dice_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    record_covers(out, triangles, c);
    out.columns("coordinates", "face, u, v");
    record_faces(c, [&](float face, const Side& side, glm::vec2 place) {
        out.append("coordinates", glm::vec3(face, seen(triangles, side, place).coordinates));
    });
    record_sizes(out, ask<dice_cube>(out));
}

void record_lit(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<lit_dice_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    out.columns("coordinates", "face, u, v");
    out.columns("normals", "face, x, y, z");
    record_faces(c, [&](float face, const Side& side, glm::vec2 place) {
        const Seen at = seen(triangles, side, place);
        out.append("coordinates", glm::vec3(face, at.coordinates));
        out.append("normals", glm::vec4(face, at.normal));
    });
    record_sizes(out, ask<lit_dice_cube>(out));
}

void record_replicated(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<replicated_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    record_covers(out, triangles, c);
    out.columns("corners", "face, u, v");
    for_each_face(c.vary, [&](float face, const Side& side) {
        for (const glm::vec2& at : corners_of(triangles, side)) out.append("corners", glm::vec3(face, at));
    });
    record_sizes(out, ask<replicated_cube>(out));
}

Image picture(Case& c, Recorder& out)
{
    const TexturedCube dice = ask<dice_cube>(out);
    const TexturedCube lit = ask<lit_dice_cube>(out);
    return texturing::picture(dice, lit, upright(ask<replicated_cube>(out)), c.vary);
}

}

const Driver driver = {
    {"dice", [](Case& c, Recorder& out) { record_dice(c, out); }},
    {"lit", [](Case& c, Recorder& out) { record_lit(c, out); }},
    {"replicated", [](Case& c, Recorder& out) { record_replicated(c, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(c, out)); }},
};

}
