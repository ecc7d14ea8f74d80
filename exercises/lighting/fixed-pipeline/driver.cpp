#include <kit/varied.hpp>
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

// Whatever OpenGL was told before; up to eleven lights.
void at_random(Random& random, Recorder& out)
{
    name_columns(out);
    const LinearFrame frame(1, 1);
    for (int i = 0; i < 24; ++i) {
        disturb(random);
        const glm::mat4 view = random_view(random);
        const std::uint32_t count = i % 4 == 0 ? 9 + random.below(3) : random.below(9);
        std::vector<PlacedLight> lights = random_lights(random, {}, view, count);
        for (PlacedLight& placed : lights)
            if (random.below(6) == 0) placed.light.color = glm::vec3(0);
        record_lights(out, {lights, random_color(random), true, false}, view);
        record_material(out, random_material(random));
    }
    for (int i = 0; i < 80; ++i) {
        disturb(random);
        out.append("light", light_of(out, frame, random_probe(random)));
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
    for (int i = 0; i < 8; ++i) {
        LitScene scene = random_scene(random, coin(random));
        // A ball in the middle, before all others; every second one is mirrored.
        const glm::vec3 size = glm::vec3(i % 2 == 0 ? 1 : -1, 1, 1) * 0.9F / unit_of_balls;
        scene.things.push_back({0, inverse(scene.view) * placed({0, 0, -2}, size), random_material(random)});
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

void record_calls(Variation& vary, Recorder& out)
{
    const LinearFrame frame(16, 16);
    LitScene scene = varied(vary, facets());
    for (int i = 0; i < 3; ++i) scene.things.push_back(scene.things.front());
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
         record_picture(out, "smooth", random_scene(c.random, false));
         record_picture(out, "flat", random_scene(c.random, true));
     }},
    {"wreath", [](Case& c, Recorder& out) { record_picture(out, "picture", varied(c.vary, wreath()), 288); }},
};

}
