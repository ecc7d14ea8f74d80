#include <umbral/projections/orthographic.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../island.hpp"
#include "../volumes.hpp"

namespace umbral {
namespace {

using namespace projections;

void record(Recorder& out, const ViewVolume& box)
{
    out.append("matrix", ask<orthographic_matrix>(out, box));
    out.append("inverse", ask<inverse_orthographic_matrix>(out, box));
}

// The cube itself, boxes with one size each that a hand can follow, and that of the course's slide; the last one is the
// course's base camera, which leaves z as it is.
void record_known(Variation& vary, Recorder& out)
{
    const ViewVolume boxes[] = {{-1, 1, -1, 1, -1, 1},   {-2, 2, -2, 2, -2, 2}, {0, 4, 0, 2, 1, 9},
                                {-4, 4, -3, 3, 1.5F, 9}, {2, 6, -5, -1, 0, 10}, {-1, 1, -0.75F, 0.75F, 1, -1}};
    for (const ViewVolume& box : boxes) record(out, varied(vary, box));
}

// The same box with its middle at 0 in some of the axes, but not in all of them; bit i of `which` for axis i.
ViewVolume with_middles_at_zero(ViewVolume box, unsigned which)
{
    if ((which & 1U) != 0) box.left = -box.right;
    if ((which & 2U) != 0) box.top = -box.bottom;
    if ((which & 4U) != 0) box.near_plane = -box.far_plane;
    return box;
}

void record_mirrored(Random& random, Recorder& out)
{
    for (unsigned i = 0; i < 70; ++i) record(out, with_sides_exchanged(random_box(random), 1 + i % 7));
}

// Twenty boxes, and each with its middle at 0 in one axis or two, in three ways; of each, one side after another moves
// outwards.
void record_random(Random& random, Recorder& out)
{
    for (unsigned i = 0; i < 20; ++i) {
        ViewVolume box = random_box(random);
        record(out, box);
        for (const unsigned more : {0U, 2U, 4U}) record(out, with_middles_at_zero(box, 1 + (i + more) % 6));
        for (float ViewVolume::*low : {&ViewVolume::left, &ViewVolume::bottom, &ViewVolume::near_plane}) {
            box.*low -= random.uniform(0.5F, 1);
            record(out, box);
        }
        for (float ViewVolume::*high : {&ViewVolume::right, &ViewVolume::top, &ViewVolume::far_plane}) {
            box.*high += random.uniform(0.5F, 1);
            record(out, box);
        }
    }
}

// Where two opposite sides come together: anywhere, or where floats are closest.
float place_of_flat(int kind, Random& random)
{
    if (kind == 2) return 0;
    const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
    return sign * (kind == 3 ? std::pow(10.0F, random.uniform(-43, -20)) : random.uniform(0.01F, 20));
}

// A box with a size and one without, in random order: one pair of opposite sides is equal. The other box is thick, or
// its sides are next to each other too; at 0, where 0 equals -0; or so near to it that their difference is all but no
// float.
void record_flat(Random& random, Recorder& out)
{
    for (int i = 0; i < 36; ++i) {
        const int kind = i / 3 % 4;
        ViewVolume flat = random_box(random);
        ViewVolume thick = flat;
        const auto bring_together = [&](float ViewVolume::*fixed, float ViewVolume::*moved) {
            flat.*fixed = place_of_flat(kind, random);
            flat.*moved = kind == 2 ? -0.0F : flat.*fixed;
            if (kind == 2 && random.below(2) == 0) std::swap(flat.*fixed, flat.*moved);
            if (kind == 0) return;
            thick.*fixed = flat.*fixed;
            thick.*moved = next_above(thick.*fixed);
            if (random.below(2) == 0) std::swap(thick.*fixed, thick.*moved);
        };
        switch (i % 3) {
            case 0: bring_together(&ViewVolume::left, &ViewVolume::right); break;
            case 1: bring_together(&ViewVolume::top, &ViewVolume::bottom); break;
            default: bring_together(&ViewVolume::near_plane, &ViewVolume::far_plane);
        }
        const bool first = random.below(2) == 1;
        for (const bool is_flat : {first, !first}) {
            const ViewVolume& asked = is_flat ? flat : thick;
            record_refusal(out, "refused", [&] { return ask<orthographic_matrix>(out, asked); });
            record_refusal(out, "inverse refused", [&] { return ask<inverse_orthographic_matrix>(out, asked); });
        }
    }
}

// Sides of any size between 1e-15 and 1e15: another one for each axis, or all three so large or so small that the
// determinant of the matrix is no float.
ViewVolume box_of_any_size(int kind, Random& random)
{
    ViewVolume box = random_box(random);
    const auto resize = [&](float& a, float& b) {
        const float exponent = kind % 3 == 0 ? random.uniform(-15, 15) : random.uniform(13.5F, 15);
        const float factor = std::pow(10.0F, kind % 3 == 1 ? -exponent : exponent);
        a *= factor;
        b *= factor;
    };
    resize(box.left, box.right);
    resize(box.bottom, box.top);
    resize(box.near_plane, box.far_plane);
    return box;
}

// Near the largest float, where a sum of two sides is no float any more, in one axis; or their difference, in the
// others.
ViewVolume box_of_the_largest_size(int axis_of_sum, Random& random)
{
    const auto large = [&] { return random.uniform(2e38F, 3.3e38F); };
    glm::mat3x2 sides(0);
    for (int axis = 0; axis < 3; ++axis) {
        const float low = random.below(2) == 0 ? -large() : large();
        sides[axis] = {low, axis == axis_of_sum ? 0.75F * low : std::copysign(large(), -low)};
    }
    return {sides[0].x, sides[0].y, sides[1].x, sides[1].y, sides[2].x, sides[2].y};
}

void draw_picture(Variation& vary, Recorder& out)
{
    const Stage stage(320, 240, {0.60F, 0.76F, 0.90F});
    const glm::mat4 view = glm::lookAt(vary.near(glm::vec3(20, 16.33F, 20), 5.0F), glm::vec3(0), glm::vec3(0, 1, 0));
    look_through(stage, view, ask<orthographic_matrix>(out, varied(vary, {-6.7F, 6.7F, -4.6F, 5.45F, 15, 50})));
    Island().draw(stage);
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"mirrored", [](Case& c, Recorder& out) { record_mirrored(c.random, out); }},
    {"flat", [](Case& c, Recorder& out) { record_flat(c.random, out); }},
    {"any size",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 100; ++i) record(out, box_of_any_size(i, c.random));
     }},
    {"largest",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 40; ++i) record(out, box_of_the_largest_size(i % 3, c.random));
     }},
    {"picture", [](Case& c, Recorder& out) { draw_picture(c.vary, out); }},
};

}
