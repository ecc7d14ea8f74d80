#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "colors.hpp"
#include "gallery.hpp"
#include "state.hpp"

namespace umbral {
namespace {

using namespace interaction;
using Made = std::unique_ptr<IdPicker>;

Grid<std::uint32_t> ids_of(Recorder& out, const Made& picker, const PickScene& scene, const glm::ivec2& picture,
                           const glm::ivec2& pixel, int radius)
{
    if (!picker) return {};
    return ask<&IdPicker::ids_around>(out, *picker, scene, picture, pixel, radius);
}

/// A row for each pixel of the square, top row first, whatever came back. How far each is from where the answer
/// changes goes beside it.
void record_ids(Recorder& out, const Grid<std::uint32_t>& ids, const EdgesInPicture& edges, const glm::ivec2& pixel,
                int radius)
{
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const glm::ivec2 cell(x + radius, y + radius);
            const bool is_square = ids.width == 2 * radius + 1 && ids.height == 2 * radius + 1;
            out.append("ids", is_square ? std::optional(static_cast<float>(ids.at(cell.x, cell.y))) : std::nullopt);
            out.append("ids.margin", edges.distance(pixel + glm::ivec2(x, y)));
        }
}

// The middle counts before all others, a pixel straight beside it before one across, and of equals the upper and left
// one.
void record_nearest(Recorder& out, Random& random)
{
    const auto record = [&](const Grid<std::uint32_t>& ids) {
        out.append("nearest", static_cast<float>(ask<nearest_id>(out, ids)));
    };
    for (int i = 0; i < 160; ++i) {
        const int radius = i < 6 ? i / 2 : 1 + random_up_to(4, random);
        const int side = 2 * radius + 1;
        Grid<std::uint32_t> ids(side, side);
        // Rare in large squares, so that the middle is free and several are equally near.
        const int count = i % 16 == 1 ? 0 : 1 + random_up_to(i % 2 == 0 ? 4 : side, random);
        for (int k = 0; k < count; ++k) {
            const int column = random_up_to(side, random);
            ids.at(column, random_up_to(side, random)) = random_id(random);
        }
        // Nothing but in the corners.
        if (i % 32 == 17) {
            ids = Grid<std::uint32_t>(side, side);
            for (int k = 0; k < 2; ++k) {
                const int column = (side - 1) * random_up_to(2, random);
                ids.at(column, (side - 1) * random_up_to(2, random)) = random_id(random);
            }
        }
        record(ids);
    }
}

/// The same squares with their ids' bytes in another order, if inputs are to vary.
PickScene with_other_ids(Variation& vary, PickScene scene)
{
    const std::uint32_t bits = vary.one_of(0U, std::array{8U, 16U});
    for (auto& thing : scene.things) thing.id = (thing.id << bits | thing.id >> (24 - bits)) & 0xFFFFFFU;
    return scene;
}

void record_by_hand(Variation& vary, Recorder& out)
{
    const PickScene scene = with_other_ids(vary, squares_by_hand());
    const glm::ivec2 picture(8, 4);
    const Made picker = ask_new<make_id_picker>(out, "picker");
    const EdgesInPicture edges({}, picture);
    for (int y = 0; y < picture.y; ++y)
        for (int x = 0; x < picture.x; ++x)
            record_ids(out, ids_of(out, picker, scene, picture, {x, y}, 0), edges, {x, y}, 0);
    record_ids(out, ids_of(out, picker, scene, picture, {3, 1}, 2), edges, {3, 1}, 2);
}

/// Squares round things' middles, a few pixels beside.
void record_scene(Recorder& out, Random& random, const Made& picker, const RandomScene& made, int squares, int radius)
{
    const EdgesInPicture edges(made.scene, made.picture);
    for (int i = 0; i < squares; ++i) {
        const auto target = static_cast<std::size_t>(random_up_to(static_cast<int>(made.targets.size()), random));
        const int right = random_up_to(5, random) - 2;
        const glm::ivec2 pixel = made.targets[target] + glm::ivec2(right, random_up_to(5, random) - 2);
        record_ids(out, ids_of(out, picker, made.scene, made.picture, pixel, radius), edges, pixel, radius);
    }
}

/// The same picture and place again, with other ids, seen from elsewhere, with other meshes, and with fewer things or
/// none: of what was drawn before nothing may be left.
void record_changed_scene(Recorder& out, Random& random, const Made& picker, RandomScene made)
{
    const auto target = static_cast<std::size_t>(random_up_to(static_cast<int>(made.targets.size()), random));
    const glm::ivec2 pixel = made.targets[target];
    const auto record = [&] {
        const EdgesInPicture edges(made.scene, made.picture);
        record_ids(out, ids_of(out, picker, made.scene, made.picture, pixel, 1), edges, pixel, 1);
    };
    record();
    for (PickThing& thing : made.scene.things)
        if (thing.id != 0) thing.id = random_id(random);
    record();
    for (PickMesh& mesh : made.scene.meshes)
        for (glm::vec3& position : mesh.positions) position *= 0.1F;
    record();
    const glm::vec3 aside(0.4F * glm::vec2(random.in_cube()), 0);
    made.scene.view = glm::translate(glm::mat4(1), aside) * made.scene.view;
    record();
    made.scene.things.resize(1);
    record();
    made.scene.things.clear();
    record();
}

void record_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 12; ++i) {
        const RandomScene made = random_scene(random);
        const Made picker = ask_new<make_id_picker>(out, "picker");
        record_scene(out, random, picker, made, 12, i % 3);
        if (i % 3 == 0) record_changed_scene(out, random, picker, made);
    }
    for (int i = 0; i < 12; ++i) {
        const RandomScene made = layered_scene(random);
        const Made picker = ask_new<make_id_picker>(out, "picker");
        record_scene(out, random, picker, made, 6, 1);
    }
}

// Squares that leave the picture at its sides and corners, and some that lie outside.
void record_borders(Recorder& out, Random& random)
{
    for (int i = 0; i < 8; ++i) {
        RandomScene made = random_scene(random);
        // A wall behind all, so that every pixel of the picture has an id.
        const glm::mat4 wall =
            glm::scale(glm::translate(glm::inverse(made.scene.view), {0, 0, -38}), glm::vec3(60, 60, 1));
        made.scene.things.insert(made.scene.things.begin(), {made.square, wall, random_id(random)});
        const Made picker = ask_new<make_id_picker>(out, "picker");
        const EdgesInPicture edges(made.scene, made.picture);
        const glm::ivec2 last = made.picture - 1;
        for (const glm::ivec2& pixel : {glm::ivec2(0, 0),
                                        {last.x, 1},
                                        {1, last.y},
                                        last,
                                        {random_up_to(last.x, random), -2},
                                        {last.x + 1, random_up_to(last.y, random)},
                                        {-1, random_up_to(last.y, random)},
                                        {random_up_to(last.x, random), last.y + 2},
                                        {-9, -9},
                                        {last.x / 2, -9},
                                        {last.x + 9, last.y / 2},
                                        {last.x / 2, last.y + 9},
                                        {-9, last.y / 2}}) {
            const int radius = 1 + random_up_to(3, random);
            record_ids(out, ids_of(out, picker, made.scene, made.picture, pixel, radius), edges, pixel, radius);
        }
    }
}

// Whatever OpenGL was told before; and what is left afterwards. The id in the middle belongs to the row: who draws
// nothing leaves all state alone.
void record_any_state(Recorder& out, Random& random)
{
    const OthersWork others;
    const Made picker = ask_new<make_id_picker>(out, "picker");
    const std::string columns = std::string(state_columns) + ", pixels changed in other pictures, id seen";
    out.columns("left", columns);
    for (int i = 0; i < 24; ++i) {
        RandomScene made = random_scene(random);
        // In every second row of two the framebuffer is there already.
        made.picture = {64 + 8 * (i / 2 % 2), 48};
        others.disturb(random);
        glm::ivec2 pixel = made.picture / 2;
        for (const PickThing& thing : made.scene.things)
            if (thing.id != 0 && !is_empty(made.scene, thing))
                pixel = pixel_of_point(made.scene, made.picture, glm::vec3(thing.model[3]));
        const Grid<std::uint32_t> ids = ids_of(out, picker, made.scene, made.picture, pixel, 1);
        std::vector<float> row = state_row();
        record_ids(out, ids, EdgesInPicture(made.scene, made.picture), pixel, 1);
        row.push_back(others.changed_pixels());
        row.push_back(ids.width == 3 && ids.height == 3 ? static_cast<float>(ids.at(1, 1)) : 0.0F);
        out.append("left", std::span<const float>(row));
    }
}

/// How often a picker that comes and goes without being asked anything calls OpenGL.
double calls_without_use(Recorder& out)
{
    gl::begin_trace();
    (void)ask_new<make_id_picker>(out, "idle");
    double calls = 0;
    for (const auto& [name, count] : gl::end_trace().counts) calls += static_cast<double>(count);
    return calls;
}

// Objects of OpenGL: none before they are needed, none at a second call, none left at the end.
void record_life(Recorder& out, Random& random)
{
    PickScene scene = squares_by_hand();
    out.columns("objects", "those that are left when the picker has gone, id seen, calls by a picker without use");
    // A deleted program lives on while it is in use.
    glUseProgram(0);
    for (int i = 0; i < 4; ++i) {
        // That of the square at the picture's lower right.
        scene.things[2].id = random_id(random);
        const double idle_calls = calls_without_use(out);
        const int before = living_objects();
        Made picker = ask_new<make_id_picker>(out, "picker");
        const int unused = living_objects() - before;
        const int columns = 8 * (1 + random_up_to(3, random));
        const Grid<std::uint32_t> ids = ids_of(out, picker, scene, {columns, 4}, {columns - 1, 3}, 0);
        if (i == 0) {
            gl::begin_trace();
            (void)ids_of(out, picker, scene, {columns, 4}, {1, 1}, 1);
            gl::record_trace(out, "second call", gl::end_trace());
        }
        (void)ids_of(out, picker, scene, {i % 2 == 0 ? 1 : 13, 11}, {0, 3}, 1);
        picker.reset();
        const int left = living_objects() - before;
        const bool is_one = ids.width == 1 && ids.height == 1;
        out.append("objects", glm::vec3(unused + left, is_one ? static_cast<float>(ids.at(0, 0)) : 0, idle_calls));
    }
}

// Three pickers by turns, each with pictures of several sizes; one of them goes. Then others for two pictures each: the
// second is higher or wider, or has the sides exchanged.
void record_several(Recorder& out, Random& random)
{
    std::array<Made, 3> pickers;
    std::array<RandomScene, 3> scenes;
    for (std::size_t i = 0; i < pickers.size(); ++i) {
        pickers[i] = ask_new<make_id_picker>(out, "picker" + std::to_string(i));
        scenes[i] = random_scene(random);
    }
    for (int i = 0; i < 24; ++i) {
        const auto which = static_cast<std::size_t>(random_up_to(i < 14 ? 3 : 2, random));
        if (i == 14) pickers[2].reset();
        const auto scene = static_cast<std::size_t>(random_up_to(3, random));
        record_scene(out, random, pickers[which], scenes[scene], 1, 1);
    }
    const int width = 60 + random_up_to(40, random);
    const glm::ivec2 size(width, 30 + random_up_to(20, random));
    for (const glm::ivec2& second : {glm::ivec2(size.x, 2 * size.y), {2 * size.x, size.y}, {size.y, size.x}}) {
        const Made picker = ask_new<make_id_picker>(out, "picker");
        record_scene(out, random, picker, random_scene(random, size), 1, 1);
        record_scene(out, random, picker, random_scene(random, second), 8, 1);
    }
}

void record_picture(Recorder& out)
{
    const Made picker = ask_new<make_id_picker>(out, "picker");
    constexpr int size = 121;
    const Grid<std::uint32_t> ids =
        ids_of(out, picker, gallery_scene(1.5F), {size, size * 2 / 3}, {size / 2, size / 3}, size / 2);
    out.buffer("ids", ids);
    out.image("gallery", gallery(out, 480, 320));
}

}

const Driver driver = {
    {"colors", [](Case& c, Recorder& out) { record_colors(out, c.random); }},
    {"nearest", [](Case& c, Recorder& out) { record_nearest(out, c.random); }},
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"borders", [](Case& c, Recorder& out) { record_borders(out, c.random); }},
    {"any state", [](Case& c, Recorder& out) { record_any_state(out, c.random); }},
    {"life", [](Case& c, Recorder& out) { record_life(out, c.random); }},
    {"several", [](Case& c, Recorder& out) { record_several(out, c.random); }},
    {"picture", [](Case&, Recorder& out) { record_picture(out); }},
};

}
