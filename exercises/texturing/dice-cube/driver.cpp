#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

void record_sizes(Recorder& out, const TexturedCube& cube)
{
    for (const std::size_t size :
         {cube.positions.size(), cube.coordinates.size(), cube.normals.size(), cube.triangles.size()})
        out.append("sizes", static_cast<std::int32_t>(size));
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

// In pairs: one place on a side, and one in its plane beside it, where there must be nothing.
void record_covers(Recorder& out, const std::vector<Triangle>& triangles, Random& random)
{
    for (const Side& side : sides)
        for (int i = 0; i < 12; ++i) {
            const glm::vec2 on = random_place(random);
            const glm::vec2 beside = on + (random.below(2) == 0 ? glm::vec2(1, 0) : glm::vec2(0, -1));
            const bool on_first = random.below(2) == 0;
            for (const glm::vec2 place : {on_first ? on : beside, on_first ? beside : on})
                out.append("covers", seen(triangles, side, place).covers);
        }
}

void record_dice(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<dice_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    record_covers(out, triangles, c.random);
    for (const Side& side : sides)
        for (int i = 0; i < 12; ++i)
            out.append("coordinates", seen(triangles, side, random_place(c.random)).coordinates);
}

void record_lit(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<lit_dice_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    for (const Side& side : sides)
        for (int i = 0; i < 12; ++i) {
            const Seen at = seen(triangles, side, random_place(c.random));
            out.append("coordinates", at.coordinates);
            out.append("normals", at.normal);
        }
}

void record_replicated(Case& c, Recorder& out)
{
    const TexturedCube cube = ask<replicated_cube>(out);
    record_sizes(out, cube);
    const std::vector<Triangle> triangles = triangles_of(cube);
    record_covers(out, triangles, c.random);
    for (const Side& side : sides)
        for (const glm::vec2& at : corners_of(triangles, side)) out.append("corners", at);
}

Image picture(Recorder& out)
{
    const TexturedCube dice = ask<dice_cube>(out);
    const TexturedCube lit = ask<lit_dice_cube>(out);
    return texturing::picture(dice, lit, upright(ask<replicated_cube>(out)));
}

}

const Driver driver = {
    {"dice", [](Case& c, Recorder& out) { record_dice(c, out); }},
    {"lit", [](Case& c, Recorder& out) { record_lit(c, out); }},
    {"replicated", [](Case& c, Recorder& out) { record_replicated(c, out); }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", picture(out)); }},
};

}
