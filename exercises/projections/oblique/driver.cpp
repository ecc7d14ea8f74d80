#include <limits>
#include <umbral/projections/oblique.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../island.hpp"
#include "../volumes.hpp"

namespace umbral {
namespace {

using namespace projections;

void record(Recorder& out, const ViewVolume& box, const Lean& lean)
{
    out.append("shear", ask<oblique_shear>(out, lean));
    out.append("matrix", ask<oblique_matrix>(out, box, lean));
    out.append("direction", ask<projector_direction>(out, lean));
}

void record_angle(Recorder& out, float alpha_degrees)
{
    out.append("foreshortening", ask<foreshortening_of>(out, alpha_degrees));
}

// Cavalier and cabinet to the right, upwards and between; no lean at all; the opposite direction. In the last two boxes
// bottom and top, near and far are exchanged; one begins at the viewer.
void record_known(Variation& vary, Recorder& out)
{
    const ViewVolume boxes[] = {
        {-1, 1, -1, 1, -1, 1}, {0, 4, 0, 2, 1, 9}, {-2, 2, -1, 1, 0, 8}, {-1, 3, 2, -2, 8, 4}, {-2, 2, 1, -1, 4, 0}};
    for (const ViewVolume& written : boxes) {
        const ViewVolume box = varied(vary, written);
        for (const Lean& lean :
             {Lean{0, 1}, {90, 1}, {45, 1}, {30, 0.5F}, {45, 0.5F}, {60, 0}, {0, -0.5F}, {180, 0.75F}, {-90, 2}})
            record(out, box, {vary.near(lean.angle_degrees, 12.0F), vary.scaled(lean.foreshortening, 1.2F)});
    }
    for (const float alpha : {45.0F, 63.434949F, 90.0F, 60.0F, 30.0F, 26.565051F})
        record_angle(out, alpha < 90 ? vary.near(alpha, 4.0F) : alpha);
}

// Angles of up to two turns; every fourth time depths are a hundred times as long as they are, or a hundredth.
Lean random_lean(Random& random, bool any_length)
{
    const float angle = random.uniform(-720, 720);
    const float length = random.uniform(-1.5F, 1.5F);
    return {angle, any_length ? length * std::exp2(random.uniform(-6, 6)) : length};
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const Lean lean = random_lean(random, i % 4 == 0);
        record(out, with_sides_exchanged(random_box(random), random.below(8)), lean);
        record_angle(out, random.uniform(5, 89));
    }
}

// An angle, and what is none, in random order. Of the smallest angles the foreshortening is no float any more.
void record_refused(Random& random, Recorder& out)
{
    constexpr float smallest = std::numeric_limits<float>::denorm_min();
    for (const float wrong : {0.0F, -45.0F, next_above(90), 135.0F, 180.0F, std::numeric_limits<float>::quiet_NaN()})
        for (int i = 0; i < 5; ++i) {
            const float small = std::exp2(random.uniform(-126, -20));
            const float smaller = smallest * static_cast<float>(1 + random.below(16));
            const float close[] = {90, std::nextafter(90.0F, 0.0F), small, smaller, random.uniform(1, 89)};
            const float right = close[i];
            const bool first = random.below(2) == 1;
            for (const bool is_wrong : {first, !first})
                record_refusal(out, "refused", [&] { return ask<foreshortening_of>(out, is_wrong ? wrong : right); });
        }
}

// Rays almost perpendicular to the view plane, and almost in it.
void record_extremes(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const float rest = std::pow(10.0F, random.uniform(-4, 0));
        const float tiny = std::pow(10.0F, random.uniform(-7, -4));
        record_angle(out, i % 4 == 0 ? tiny : i % 4 == 1 ? rest : 90 - rest);
    }
}

// Thousands of turns; angles beside the axes, on one side and the other; depths that are shown so long that the square
// of their length is no float.
void record_any_angle(Random& random, Recorder& out)
{
    const auto record_lean = [&](const Lean& lean) {
        out.append("shear", ask<oblique_shear>(out, lean));
        out.append("direction", ask<projector_direction>(out, lean));
    };
    for (int i = 0; i < 50; ++i) {
        const float length = random.uniform(0.25F, 1.5F) * (random.below(2) == 0 ? 1.0F : -1.0F);
        const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
        record_lean({sign * std::pow(10.0F, random.uniform(3.5F, 7)), length});
        const float axis = 90.0F * (static_cast<float>(random.below(8)) - 4);
        const float beside = sign * std::pow(10.0F, random.uniform(-5, -0.5F));
        record_lean({axis + beside, length});
        record_lean({axis - beside, length});
        record_lean({random.uniform(-180, 180), sign * std::pow(10.0F, random.uniform(15, 37))});
    }
}

// The island from straight before, in cabinet and in cavalier projection.
void draw_islands(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(480, 200);
    constexpr glm::vec3 sky(0.60F, 0.76F, 0.90F);
    constexpr int panels = 3;
    constexpr int gap = 8;
    const Stage stage(size.x, size.y, {0.07F, 0.07F, 0.09F});
    const Island island;
    const glm::ivec2 extent((2 * size.x - (panels - 1) * gap) / panels, 2 * size.y);
    const float half_width = vary.scaled(7.8F, 1.15F);
    const float middle = vary.near(0.3F, 0.8F);
    const float half_height = half_width * static_cast<float>(extent.y) / static_cast<float>(extent.x);
    int panel = 0;
    for (const float foreshortening : {0.0F, 0.5F, 1.0F}) {
        begin_panel({panel * (extent.x + gap), 0}, extent, sky);
        const ViewVolume box{-half_width, half_width, middle - half_height, middle + half_height, -8, 8};
        look_through(stage, glm::mat4(1),
                     ask<oblique_matrix>(out, box, Lean{vary.near(50.0F, 15.0F), vary.scaled(foreshortening, 1.3F)}));
        island.draw(stage);
        ++panel;
    }
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"extremes", [](Case& c, Recorder& out) { record_extremes(c.random, out); }},
    {"any angle", [](Case& c, Recorder& out) { record_any_angle(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_islands(c.vary, out); }},
};

}
