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

void record_mirrored(Random& random, Recorder& out)
{
    for (unsigned i = 0; i < 70; ++i) record(out, with_sides_exchanged(random_box(random), 1 + i % 7));
}

// Twenty boxes; of each, one side after another moves outwards.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        ViewVolume box = random_box(random);
        record(out, box);
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

// A box with a size and one without, in random order: one pair of opposite sides is equal. Three times out of four the
// other one's are next to each other; once at 0, where floats are closest, and 0 equals -0.
void record_flat(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        ViewVolume box = random_box(random);
        ViewVolume flat = box;
        ViewVolume thin = box;
        const auto bring_together = [&](float ViewVolume::*fixed, float ViewVolume::*moved) {
            const bool at_zero = i / 3 % 4 == 2;
            if (at_zero) flat.*fixed = thin.*fixed = 0;
            flat.*moved = at_zero ? -0.0F : flat.*fixed;
            thin.*moved = next_above(thin.*fixed);
        };
        switch (i % 3) {
            case 0: bring_together(&ViewVolume::left, &ViewVolume::right); break;
            case 1: bring_together(&ViewVolume::top, &ViewVolume::bottom); break;
            default: bring_together(&ViewVolume::near_plane, &ViewVolume::far_plane);
        }
        if (i / 3 % 4 != 0) box = thin;
        const bool first = random.below(2) == 1;
        for (const bool is_flat : {first, !first}) {
            const ViewVolume& asked = is_flat ? flat : box;
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

// Near the largest float, where a sum or a difference of two sides is no float any more.
ViewVolume box_of_the_largest_size(Random& random)
{
    const auto large = [&] { return random.uniform(2e38F, 3.3e38F); };
    const float left = large();
    const float right = 0.75F * left;
    return random.below(2) == 0 ? ViewVolume{-large(), large(), left, right, 1, large()}
                                : ViewVolume{left, right, -large(), large(), -large(), large()};
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
         for (int i = 0; i < 40; ++i) record(out, box_of_the_largest_size(c.random));
     }},
    {"picture", [](Case& c, Recorder& out) { draw_picture(c.vary, out); }},
};

}
