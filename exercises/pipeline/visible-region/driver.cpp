#include <array>
#include <cmath>
#include <kit/script_questions.hpp>
#include <span>
#include <string>
#include <umbral/input/script.hpp>
#include <umbral/record/driver.hpp>

#include "boxes.hpp"
#include "windows.hpp"

namespace umbral {
namespace {

using namespace pipeline;

void record(Recorder& out, const Box& contents, int width, int height)
{
    const auto [low, high] = ask<visible_region>(out, contents, width, height);
    out.columns("region", "low/3, high/3");
    out.append("region", std::span<const float>(std::array{low.x, low.y, low.z, high.x, high.y, high.z}));
}

/// A script that is written down, with other sizes of windows: equal ones remain so, and those of a pixel or none.
input::EventScript varied_script(Variation& vary, const char* text)
{
    input::EventScript script = input::parse_script(text);
    constexpr std::array factors{0.75, 1.25, 1.5};
    const glm::dvec2 factor(vary.one_of(1.0, factors), vary.one_of(1.0, factors));
    for (input::TimedEvent& event : script)
        if (auto* const resize = std::get_if<input::Resize>(&event.event))
            for (int axis = 0; axis < 2; ++axis)
                if (int& length = resize->size[axis]; length > 1) length = static_cast<int>(length * factor[axis]);
    return script;
}

// Boxes whose matrices can be worked out by hand.
void known_matrices(Case& c, Recorder& out)
{
    const Box boxes[] = {cube,
                         {{-2, -1, -1}, {2, 1, 1}},
                         {{0, 0, 0}, {4, 2, 1}},
                         {{1, -2, -1}, {4, 0, 1}},
                         {{-3, 5, 10}, {-1, 13, 12}},
                         {{0, 0, -8}, {0.5F, 0.25F, -4}}};
    for (const Box& box : boxes) out.append("projection", ask<projection_of>(out, varied(c.vary, box)));
}

void random_matrices(Case& c, Recorder& out)
{
    for (int i = 0; i < 12; ++i)
        for (const auto& [box, point] : changed_boxes(c.random)) out.append("projection", ask<projection_of>(out, box));
    for (int i = 0; i < 200; ++i)
        out.append("projection",
                   ask<projection_of>(out, i % 4 == 3 ? nearly_flat(c.random) : box_in_any_unit(c.random, 5)));
}

// Mirrored, flat, or both: every second one is ordinary.
void odd_boxes(Case& c, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        Box box = random_box(c.random, 3);
        const auto axis = static_cast<glm::vec3::length_type>(c.random.below(3));
        if (i % 4 == 1) std::swap(box.low[axis], box.high[axis]);
        if (i % 4 == 3) box.high[axis] = box.low[axis];
        const glm::vec3 point = 0.5F * (box.low + box.high) + 0.3F * c.random.in_cube();
        const float unit = random_unit(c.random, -60, 60);
        out.append("projection", ask<projection_of>(out, in_unit(box, unit)));
        out.append("ndc", ask<ndc_of>(out, in_unit(box, unit), unit * point));
        if (i % 4 == 3) out.append("projection", ask<projection_of>(out, nearly_flat(c.random)));
    }
}

void changed_points(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        for (const auto& [box, point] : changed_boxes(random)) {
            out.append("ndc", ask<ndc_of>(out, box, point));
            out.append("ndc", ask<ndc_of>(out, box, box.low));
        }
    }
}

// Points in boxes, a part of them up to a quarter of the box outside.
void record_points(Random& random, Recorder& out, float away, bool outside)
{
    for (int i = 0; i < 100; ++i) {
        const Box box = box_in_any_unit(random, away);
        const float reach = outside && i % 4 == 1 ? 0.75F : 0.5F;
        const glm::vec3 share = reach * random.in_cube() + 0.5F;
        out.append("ndc", ask<ndc_of>(out, box, box.low + share * (box.high - box.low)));
    }
}

void known_regions(Case& c, Recorder& out)
{
    constexpr glm::ivec2 sizes[] = {{512, 512}, {1024, 512},  {512, 1024}, {800, 600},
                                    {600, 800}, {1920, 1080}, {333, 500},  {3, 7}};
    for (const glm::ivec2& size : sizes)
        for (const Box& contents : {cube, Box{{-3, -1, -1}, {3, 1, 1}}, tile}) {
            const int width = c.vary.near(size.x, size.x / 8);
            record(out, varied(c.vary, contents), width, c.vary.near(size.y, size.y / 8));
        }
}

void random_regions(Case& c, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        Box contents = box_in_any_unit(c.random, 4);
        const auto mirrored = static_cast<glm::vec3::length_type>(c.random.below(2));
        if (i % 2 == 1) std::swap(contents.low[mirrored], contents.high[mirrored]);
        const int width = 1 + static_cast<int>(c.random.below(2000));
        const int height = 1 + static_cast<int>(c.random.below(2000));
        record(out, i % 4 == 0 ? fitting_box(c.random, width, height) : contents, width, height);
        // Then another width alone, another height, and the other way round; other contents alone.
        if (i % 10 != 0) continue;
        for (const glm::ivec2& size :
             {glm::ivec2(width + 50, height), {width + 50, 2 * height}, {2 * height, width + 50}})
            record(out, contents, size.x, size.y);
        for (const auto& [box, point] : changed_boxes(c.random)) record(out, box, width, height);
    }
}

// No pixels, hardly any, and far too many; contents that are flat, mirrored, or nothing but a point. Half of the rows
// are ordinary.
void odd_windows(Case& c, Recorder& out)
{
    constexpr glm::ivec2 sizes[] = {{0, 0},    {640, 0},  {0, 480},   {1, 1},
                                    {1, 1000}, {4096, 1}, {1, 65535}, {32767, 32766}};
    const Box boxes[] = {cube,
                         {{1, 2, 3}, {2, 4, 3}},
                         {{1, 2, 3}, {6, 2, 5}},
                         {{1, 2, 3}, {1, 8, 5}},
                         {{1, 2, 3}, {1, 2, 3}},
                         {{4, 0, 1}, {1, 2, -1}},
                         {{1, 9, 0}, {5, 2, 1}}};
    const auto ordinary = [&] {
        record(out, random_box(c.random, 4), 700, 300 + static_cast<int>(c.random.below(800)));
    };
    for (const glm::ivec2& size : sizes) {
        for (const Box& contents : boxes) {
            record(out, varied(c.vary, contents), size.x, size.y);
            ordinary();
        }
        const Box fitting = fitting_box(c.random, std::max(size.x, 1), std::max(size.y, 1));
        record(out, fitting, size.x, size.y);
        ordinary();
    }
}

// A window, and all events up to the one at which something was shown.
std::string session_text(const input::EventScript& script, glm::dvec2 content_scale, const LoggedViewer::Moment& moment,
                         const std::string& start)
{
    constexpr std::size_t most = 8;
    const std::size_t count = std::min(moment.events, script.size());
    const std::size_t left_out = count > most ? count - most : 0;
    std::string text =
        "// a window of 640 x 480, " + literal::of(content_scale.x) + " pixels a screen coordinate\n" + start + '\n';
    if (left_out > 0) text += "// … " + std::to_string(left_out) + " events left out\n";
    const auto at = [&](std::size_t place) { return script.begin() + static_cast<std::ptrdiff_t>(place); };
    text += input::to_text({at(left_out), at(count)});
    return text + "// viewer.contents() is now " + literal::of_value(moment.contents, true, {});
}

void append_rows(Recorder& out, const input::EventScript& script, glm::dvec2 content_scale, const LoggedViewer& viewer,
                 float code, const std::string& start = "keep_proportions(window);")
{
    for (std::size_t i = 0; i < viewer.rows.size(); ++i) {
        const auto events = [&] {
            const std::size_t count = std::min(viewer.moments[i].events, script.size());
            return input::EventScript(script.begin(), script.begin() + static_cast<std::ptrdiff_t>(count));
        };
        ask_in_script(out, "the session", events,
                      [&] { return session_text(script, content_scale, viewer.moments[i], start); });
        std::vector<float> row = viewer.rows[i];
        row[0] = code;
        out.append("commands", std::span<const float>(row));
    }
}

void record_commands(Recorder& out, const input::EventScript& events, glm::dvec2 content_scale,
                     const std::vector<Box>& contents)
{
    const input::EventScript script = script_asked(out, "the session", events);
    LoggedViewer viewer(contents);
    play(script, content_scale, viewer);
    append_rows(out, script, content_scale, viewer, 1);
}

constexpr const char* names =
    "1 show, size and P[0].x, P[1].y, P[3].x, P[3].y\n2 show to the second viewer, size and P[0].x, P[1].y, P[3].x, "
    "P[3].y\n";

// The second window begins with nothing of the first; what is shown changes between events. The third one is handed to
// another viewer. The last two are there at the same time, and may be one pixel wide or high.
void two_windows(Case& c, Recorder& out)
{
    out.text("commands.names", names);
    record_commands(out, varied_script(c.vary, "0.1 resize 700 350\n0.2 resize 350 700\n"), {1, 1},
                    varied(c.vary, std::vector<Box>{cube, tile, {{0, 0, 0}, {5, 1, 1}}}));
    record_commands(out, varied_script(c.vary, "0.1 refresh\n0.2 resize 900 450\n0.3 resize 450 901\n"), {2, 2},
                    varied(c.vary, std::vector<Box>{{{-2, -1, 0}, {0, 5, 1}}, cube}));
    LoggedViewer first({varied(c.vary, cube)});
    LoggedViewer second({varied(c.vary, tile)});
    const input::EventScript script =
        varied_script(c.vary, "0.1 resize 320 480\n0.2 resize 600 200\n0.3 resize 210 700\n0.4 resize 800 100\n");
    play(script, {1, 1}, first, &second);
    append_rows(out, script, {1, 1}, first, 1);
    append_rows(out, script, {1, 1}, second, 2);
    LoggedViewer left(varied(c.vary, std::vector<Box>{cube, tile}));
    LoggedViewer right(varied(c.vary, std::vector<Box>{{{0, 0, 0}, {5, 1, 1}}, cube}));
    const input::EventScript narrow =
        varied_script(c.vary, "0.1 resize 1 300\n0.2 resize 420 1\n0.3 resize 200 300\n0.4 resize 1 1\n");
    play_beside(narrow, left, right);
    append_rows(out, narrow, {1, 1}, left, 1);
    append_rows(out, narrow, {1, 1}, right, 2);
}

// A window that has no pixels, or has had events, when keep_proportions is called; then it is called again, for another
// viewer.
void late_windows(Case& c, Recorder& out)
{
    out.text("commands.names", names);
    const auto record_late = [&](const char* written, const std::vector<std::size_t>& after, const std::string& start) {
        LoggedViewer viewer(varied(c.vary, std::vector<Box>{tile, cube}));
        LoggedViewer heir(varied(c.vary, std::vector<Box>{{{0, 0, 0}, {5, 1, 1}}, {{-1, 2, 0}, {0, 6, 1}}}));
        const input::EventScript script = varied_script(c.vary, written);
        play_registered(script, after, viewer, heir);
        append_rows(out, script, {1, 1}, viewer, 1, start);
        append_rows(out, script, {1, 1}, heir, 2, start);
    };
    record_late("0.1 resize 0 0\n0.2 resize 500 300\n0.3 resize 300 800\n0.4 resize 640 200\n", {1},
                "// keep_proportions(window) after the first event");
    record_late("0.1 resize 0 400\n0.2 resize 410 310\n0.3 key A press\n0.4 resize 600 800\n", {1},
                "// keep_proportions(window) after the first event");
    record_late("0.1 resize 300 700\n0.2 resize 900 500\n0.3 resize 320 480\n0.4 resize 700 90\n", {0, 2},
                "// keep_proportions(window) at once, and after two events for a second viewer");
    record_late("0.1 resize 350 720\n0.2 key A press\n0.3 resize 330 470\n0.4 resize 720 80\n", {1, 2},
                "// keep_proportions(window) after the first event, and after the next one for a second viewer");
}

void random_windows(Case& c, Recorder& out)
{
    out.text("commands.names", names);
    std::string script;
    std::uint32_t width = 0;
    std::uint32_t height = 1;
    for (int i = 0; i < 40; ++i) {
        // Now and then only one side is dragged.
        if (i % 5 == 3) {
            width += 10 + c.random.below(500);
        } else if (i % 5 == 4) {
            height += 10 + c.random.below(500);
        } else {
            width = c.random.below(8) == 0 ? 0 : 1 + c.random.below(2000);
            height = 1 + c.random.below(1500);
        }
        script += std::to_string(0.1 * i) + " resize " + std::to_string(width) + " " + std::to_string(height) + "\n";
    }
    const Box first = random_box(c.random, 3);
    record_commands(out, input::parse_script(script), {1.5, 1.5}, {first, random_box(c.random, 3)});
}

}

const Driver driver = {
    {"known boxes", known_matrices},
    {"random boxes", random_matrices},
    {"odd boxes", odd_boxes},
    {"points",
     [](Case& c, Recorder& out) {
         record_points(c.random, out, 4, true);
         changed_points(c.random, out);
     }},
    {"far away",
     [](Case& c, Recorder& out) {
         for (const float away : {1e3F, 1e4F, 1e5F, 1e6F}) record_points(c.random, out, away, false);
     }},
    {"known windows", known_regions},
    {"random windows", random_regions},
    {"odd windows", odd_windows},
    {"resize",
     [](Case& c, Recorder& out) {
         out.text("commands.names", names);
         record_commands(out, varied_script(c.vary, resizing), {2, 2}, {varied(c.vary, tile)});
     }},
    {"two windows", two_windows},
    {"late windows", late_windows},
    {"random sessions", random_windows},
    {"picture", [](Case& c, Recorder& out) { out.image("windows", windows_picture(out, c.vary)); }},
};

}
