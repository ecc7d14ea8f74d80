#include <kit/numbers_changed.hpp>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "scenes.hpp"

namespace umbral {
namespace {

using namespace lighting;

constexpr const char* color_columns = "GL_AMBIENT/3, GL_DIFFUSE/3, GL_SPECULAR/3";
constexpr const char* material_columns = "GL_EMISSION/4, GL_AMBIENT/4, GL_DIFFUSE/4, GL_SPECULAR/4, GL_SHININESS";

// What OpenGL keeps of the lights.
void record_lights(Recorder& out, const FrameLighting& lighting, const glm::mat4& view)
{
    ask<set_lighting>(out, lighting, view);
    std::array<float, 8> on{};
    for (int i = 0; i < 8; ++i) on[static_cast<std::size_t>(i)] = glIsEnabled(light_name(i)) == GL_TRUE ? 1 : 0;
    out.append("on", std::span<const float>(on));
    for (int i = 0; i < static_cast<int>(std::min<std::size_t>(lighting.lights.size(), 8)); ++i) {
        out.append("positions", position_of_light(i));
        const std::array<float, 9> colors = colors_of_light(i);
        out.append("colors", std::span<const float>(colors));
    }
}

void record_material(Recorder& out, const Material& material)
{
    // As set_lighting leaves it.
    glDisable(GL_COLOR_MATERIAL);
    ask<set_material>(out, material);
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        const std::array<float, 17> numbers = material_of(face);
        out.append("materials", std::span<const float>(numbers));
    }
}

void name_columns(Recorder& out)
{
    out.columns("on", "GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7");
    out.columns("colors", color_columns);
    out.columns("materials", material_columns);
}

void by_hand(Variation& vary, Recorder& out)
{
    name_columns(out);
    PlacedLight lamp{{{1, 2, 3, 1}, {1, 0.5F, 0.25F}}, LightFrame::world};
    PlacedLight sun{{{0, 1, 0, 0}, {0.25F, 0.5F, 1}}, LightFrame::world};
    PlacedLight torch{{{0.5F, 0, -2, 1}, {0, 0.75F, 0}}, LightFrame::camera};
    PlacedLight headlight{{{0, 0, 1, 0}, {2, 2, 2}}, LightFrame::camera};
    const glm::mat4 away = glm::translate(glm::mat4(1), {0, 0, -10});
    const glm::mat4 quarter({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {2, -1, -5, 1});
    // One that is out has its place all the same.
    PlacedLight out_of_order{{{3, 1, -2, 1}, {0, 0, 0}}, LightFrame::world};
    for (PlacedLight* placed : {&lamp, &sun, &torch, &headlight, &out_of_order}) {
        glm::vec4& position = placed->light.position;
        position = vary.exact_map().place(position);
        placed->light.color *= vary.near(glm::vec3(1), 0.25F);
    }
    const std::vector<std::vector<PlacedLight>> sets = {{lamp},           {lamp, sun, torch, headlight}, {torch}, {},
                                                        {headlight, sun}, {sun, out_of_order, lamp}};
    for (const std::vector<PlacedLight>& lights : in_random_order(vary, sets))
        for (const glm::mat4& view : {glm::mat4(1), away, quarter})
            record_lights(out, {lights, glm::vec3(0), true, false}, view);

    record_material(out, {});
    const auto color = [&](const glm::vec3& written) { return written * vary.near(glm::vec3(1), 0.25F); };
    record_material(out, {color({0.125F, 0, 0.25F}), color({0.25F, 0.5F, 0.125F}), color({0.5F, 0.25F, 1}),
                          color({0.5F, 1, 0.25F}), vary.scaled(2.0F, 2)});
    for (const float e : in_random_order(vary, std::vector{0.0F, 5.0F, 129.0F, 3.0F, 128.0F, 7.0F, 10'000.0F}))
        record_material(out, {{}, {}, {}, color(glm::vec3(1)), e});

    const LinearFrame frame(1, 1);
    for (const Probe& probe : probes_by_hand(vary)) out.append("light", light_of(out, frame, probe));
}

// What is new at this vertex: all of it, all but the material, or the material and the modelview matrix alone.
Probe next_probe(Random& random, const Probe& before, int i)
{
    Probe next = random_probe(random);
    if (i % 3 == 1) next.material = before.material;
    if (i % 3 != 2) return next;
    Probe same = before;
    same.material = next.material;
    same.modelview = next.modelview;
    return same;
}

// The same lights and the same material but for one number; then one of the lights twice.
void record_changed(Random& random, Recorder& out, FrameLighting lighting, const glm::mat4& view,
                    const Material& material)
{
    const auto is_placed = [](const PlacedLight& placed) {
        const glm::vec4& position = placed.light.position;
        return position.w == 1 || (position.w == 0 && glm::vec3(position) != glm::vec3(0));
    };
    for (const FrameLighting& changed : numbers_changed(
             random, lighting, 4, [&](const FrameLighting& one) { return std::ranges::all_of(one.lights, is_placed); }))
        record_lights(out, changed, view);
    lighting.lights.resize(std::min<std::size_t>(lighting.lights.size(), 2));
    if (!lighting.lights.empty()) lighting.lights.push_back(lighting.lights.front());
    record_lights(out, lighting, view);
    for (const Material& changed :
         numbers_changed(random, material, 6, [](const Material& one) { return one.shininess >= 0; }))
        record_material(out, changed);
}

// Whatever OpenGL was told before; up to eleven lights. Of three frames one is lit as the one before, and of three
// materials one is that of before: in the meantime somebody else has set others.
void at_random(Random& random, Recorder& out)
{
    name_columns(out);
    const LinearFrame frame(1, 1);
    FrameLighting lighting;
    glm::mat4 view(1);
    Material material;
    for (int i = 0; i < 36; ++i) {
        disturb(random);
        if (i % 3 != 2) {
            view = random_view(random);
            lighting.lights = lights_of_all_kinds(random, view, i % 4 == 0 ? 9 + random.below(3) : random.below(9));
        }
        record_lights(out, lighting, view);
        if (i % 3 != 1) material = random_extreme_material(random);
        record_material(out, material);
        if (i % 4 == 1) record_changed(random, out, lighting, view, material);
    }
    Probe probe = random_probe(random);
    for (int i = 0; i < 80; ++i) {
        disturb(random);
        // What the unit need not set, and Mesa would compile programs of its own for.
        glDisable(GL_RESCALE_NORMAL);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
        probe = next_probe(random, probe, i);
        out.append("light", light_of(out, frame, probe));
    }
}

// What set_lighting must leave alone, and errors that nobody may leave behind.
void matrices(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        disturb(random);
        const glm::mat4 view = random_view(random);
        FrameLighting lighting;
        lighting.lights = random_lights(random, {}, view, i < 6 ? 3 : 10);
        ask<set_lighting>(out, lighting, view);
        std::vector<float> row;
        for (const GLenum name : {GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH})
            append_integer(row, name);
        row.push_back(static_cast<float>(glGetError()));
        for (const GLenum name : {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX}) {
            row.resize(row.size() + 16);
            glGetFloatv(name, &row[row.size() - 16]);
        }
        // Who sets no light has left all matrices alone, too.
        const glm::vec4 position = position_of_light(0);
        row.insert(row.end(), {position.x, position.y, position.z, position.w});
        out.columns("state",
                    "GL_MATRIX_MODE, modelview depth, projection depth, glGetError, modelview/16, projection/16, "
                    "light 0 position/4");
        out.append("state", std::span<const float>(row));
    }
}

Image picture_of(Recorder& out, const LitScene& scene, int size)
{
    const LinearFrame frame(2 * size, 2 * size);
    frame.clear({0.004F, 0.005F, 0.009F});
    glEnable(GL_DEPTH_TEST);
    ask<draw_lit>(out, scene);
    return frame.picture();
}

void record_picture(Recorder& out, std::string_view name, const LitScene& scene, int size = 128)
{
    out.image(name, picture_of(out, scene, size));
}

// Each scene after what another one left, and in a state that no scene can have expected.
void pictures(Case& what, Recorder& out)
{
    const std::pair<const char*, LitScene> scenes[] = {
        {"stretched", stretched()}, {"mirrored", mirrored()}, {"facets", facets()}, {"parallel", parallel()}};
    for (const auto& [name, scene] : scenes) {
        disturb(what.random);
        record_picture(out, name, varied(what.vary, scene));
    }
}

// The world turned under the camera, lights and all, first without the camera and then with it.
void record_laws(Variation& vary, Recorder& out)
{
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.9F, normalize(glm::vec3(0.4F, 1, -0.3F)));
    LitScene scene = varied(vary, mirrored());
    record_picture(out, "straight", scene, 96);
    for (LitThing& thing : scene.things) thing.model = turned * thing.model;
    for (PlacedLight& placed : scene.lighting.lights)
        if (placed.frame == LightFrame::world) placed.light.position = turned * placed.light.position;
    record_picture(out, "turned alone", scene, 96);
    scene.view = scene.view * inverse(turned);
    record_picture(out, "turned together", scene, 96);
}

// What is seen belongs to the row: who draws nothing leaves all state alone.
void record_state(Random& random, Recorder& out)
{
    const LinearFrame frame(16, 16);
    out.columns("state", std::string(neutral_columns) + ", light in the middle/3");
    LitScene scene;
    for (int i = 0; i < 12; ++i) {
        LitScene next = random_scene(random, coin(random));
        if (i % 4 == 1) next.meshes[0] = behind_others(next.meshes[0]);
        // A ball in the middle, before all others; every second one is mirrored.
        const glm::vec3 size = glm::vec3(i % 2 == 0 ? 1 : -1, 1, 1) * 0.9F / unit_of_balls;
        next.things.push_back({0, inverse(next.view) * placed({0, 0, -2}, size), random_material(random)});
        if (i == 9) next = {};
        // Of three scenes one is what was drawn last, alone and in the same light; one is empty.
        if (i % 3 == 2)
            scene.things = {scene.things.back()};
        else
            scene = std::move(next);
        // That one twice, as one frame after the other: whatever was done in between.
        for (int frames = i % 3 == 2 ? 2 : 1; frames > 0; --frames) {
            disturb(random);
            frame.clear();
            switch_on(GL_DEPTH_TEST, coin(random));
            ask<draw_lit>(out, scene);
            std::vector<float> row = neutral_state();
            const glm::vec3 seen = frame.light().at(8, 8);
            row.insert(row.end(), {seen.r, seen.g, seen.b});
            out.append("state", std::span<const float>(row));
        }
    }
}

void record_calls(Variation& vary, Recorder& out)
{
    const LinearFrame frame(16, 16);
    LitScene scene = varied(vary, facets());
    for (int i = 0; i < 3; ++i) scene.things.push_back(scene.things.front());
    // A mesh that nobody may cut into pieces; who draws vertex by vertex needs fewer calls than a trace holds.
    scene.meshes.push_back(tables_of(sphere(80, 40)));
    scene.things.push_back({scene.meshes.size() - 1, glm::mat4(1), scene.things.front().material});
    gl::begin_trace();
    ask<draw_lit>(out, scene);
    gl::record_trace(out, "calls", gl::end_trace());
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"matrices", [](Case& c, Recorder& out) { matrices(c.random, out); }},
    {"pictures", [](Case& c, Recorder& out) { pictures(c, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.vary, out); }},
    {"state", [](Case& c, Recorder& out) { record_state(c.random, out); }},
    {"calls", [](Case& c, Recorder& out) { record_calls(c.vary, out); }},
    {"scene",
     [](Case& c, Recorder& out) {
         disturb(c.random);
         record_picture(out, "smooth", crowded(c.random, random_scene(c.random, false)));
         LitScene flat = crowded(c.random, random_scene(c.random, true));
         flat.meshes[0] = behind_others(flat.meshes[0]);
         record_picture(out, "flat", flat);
     }},
    {"wreath", [](Case& c, Recorder& out) { record_picture(out, "picture", varied(c.vary, wreath()), 288); }},
};

}
