#include <umbral/record/driver.hpp>

#include "crowds.hpp"
#include "extremes.hpp"
#include "glasses.hpp"

namespace umbral {
namespace {

using namespace raytracing;

/// The frame with these fragments, and, if wanted, with an empty list after them, of which nothing may come: neither
/// from the list before, nor from one that was drawn into another frame.
template <auto Draw, class Fragments>
void record_drawn(Recorder& out, GlassFrame frame, const Fragments& fragments, bool then_none = false)
{
    const int width = frame.light.width;
    const int height = frame.light.height;
    ask<Draw>(out, frame, fragments);
    record_frame(out, frame, width, height);
    if (!then_none) return;
    ask<Draw>(out, frame, Fragments());
    record_frame(out, frame, width, height);
    // The same fragments into a frame that has them at other depths.
    for (float& depth : frame.depths.cells) depth = std::isfinite(depth) ? 1 - depth : 0.5F;
    ask<Draw>(out, frame, fragments);
    record_frame(out, frame, width, height);
}

void record_empty(Case& what, Recorder& out)
{
    out.columns("sizes", "columns, rows, columns of depths, rows of depths");
    for (int i = 0; i < 12; ++i) {
        // Every third one has no cell.
        const int width = i % 6 == 0 ? 0 : 1 + static_cast<int>(what.random.below(6));
        const int height = i % 6 == 3 ? 0 : 1 + static_cast<int>(what.random.below(6));
        // Each size twice, before different backgrounds.
        for (const float most : {1.0F, 5.0F}) {
            const GlassFrame frame = ask<empty_glass_frame>(out, width, height, random_light(what.random, most));
            for (const glm::vec4& row : rows_of(frame, width, height)) out.append("cells", row);
            out.append("sizes",
                       glm::vec4(frame.light.width, frame.light.height, frame.depths.width, frame.depths.height));
        }
    }
}

void record_opaque(Case& what, Recorder& out)
{
    for (int i = 0; i < 52; ++i) {
        const GlassTask task = i < 12 ? nan_task(what.random) : random_task(what.random);
        record_drawn<draw_opaque>(out, task.frame, task.opaque, i % 2 == 1);
    }
}

void record_filtered(Case& what, Recorder& out)
{
    const GlassTask sheets = three_sheets(what.vary);
    record_drawn<filter_glass>(out, sheets.frame, sheets.glass);
    for (int i = 0; i < 52; ++i) {
        const GlassTask task = i < 12 ? nan_task(what.random) : random_task(what.random);
        record_drawn<filter_glass>(out, task.frame, task.glass, i % 2 == 1);
    }
}

void record_blended(Case& what, Recorder& out)
{
    for (int i = 0; i < 52; ++i) {
        const GlassTask task = i < 12 ? nan_task(what.random) : random_task(what.random);
        record_drawn<blend_glass>(out, task.frame, task.glass, i % 2 == 1);
    }
}

// Each kind of rare fragments several times, with all functions.
void record_extremes(Case& what, Recorder& out)
{
    const auto record = [&](const char* light, const GlassFrame& frame) {
        for (const glm::vec4& row : rows_of(frame, 4, 1)) {
            out.append(light, glm::vec3(row));
            out.append("depths", row.w);
        }
    };
    for (int i = 0; i < 6; ++i)
        for (const Rare kind : rare_kinds) {
            const GlassTask task = rare_task(what.random, kind);
            GlassFrame frame = task.frame;
            ask<draw_opaque>(out, frame, task.opaque);
            record("opaque light", frame);
            frame = task.frame;
            ask<filter_glass>(out, frame, task.glass);
            record("filtered light", frame);
            frame = task.frame;
            ask<blend_glass>(out, frame, task.glass);
            record("blended light", frame);
        }
}

// One frame through all functions, some of them twice, also with nothing to draw: nothing stays behind from a call, and
// none closes the frame.
void record_in_turn(Case& what, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        GlassTask task = random_task(what.random);
        GlassFrame& frame = task.frame;
        const int width = frame.light.width;
        const int height = frame.light.height;
        const std::vector<GlassFragment> first(task.glass.begin(), task.glass.begin() + task.glass.size() / 2);
        const std::vector<GlassFragment> none;
        // Where all were drawn, nothing would be left of what is before and behind.
        const std::vector<OpaqueFragment> few(task.opaque.begin(), task.opaque.begin() + task.opaque.size() / 4);
        const std::vector<GlassFragment> second(task.glass.begin() + task.glass.size() / 2, task.glass.end());
        ask<blend_glass>(out, frame, first);
        ask<blend_glass>(out, frame, second);
        ask<blend_glass>(out, frame, none);
        ask<draw_opaque>(out, frame, few);
        ask<filter_glass>(out, frame, second);
        ask<blend_glass>(out, frame, first);
        if (i % 2 == 0) ask<blend_glass>(out, frame, none);
        record_frame(out, frame, width, height);
    }
}

}

const Driver driver = {
    {"picture", [](Case& c, Recorder& out) { out.image("glasses", glass_image(c.vary, out, 400, 300, true)); }},
    {"window", [](Case& c, Recorder& out) { out.image("panes", glass_image(c.vary, out, 160, 120, false)); }},
    {"empty", record_empty},
    {"opaque", record_opaque},
    {"filtered", record_filtered},
    {"sheets",
     [](Case& c, Recorder& out) {
         const GlassTask task = three_sheets(c.vary);
         record_drawn<blend_glass>(out, task.frame, task.glass);
     }},
    {"blended", record_blended},
    {"deep",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 6; ++i) {
             const GlassTask task = deep_task(c.random);
             record_drawn<blend_glass>(out, task.frame, task.glass);
         }
     }},
    {"in turn", record_in_turn},
    {"extremes", record_extremes},
};

}
