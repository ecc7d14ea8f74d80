#pragma once

#include <algorithm>
#include <cstdio>
#include <glm/glm.hpp>
#include <kit/single_points.hpp>
#include <memory>
#include <string>
#include <umbral/core/grid.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/record/case.hpp>
#include <vector>

#include "../support.hpp"

/// Where the student's shaders meet OpenGL: the interface they must have, and how a scene goes through it.
namespace umbral::lighting {

inline constexpr std::size_t maximum_lights = 8;

/// What phong.vert and phong.frag are fed with, as the comment in the stubs says.
inline gl::Interface shader_interface()
{
    return {{{"position", GL_FLOAT_VEC3, 1}, {"normal", GL_FLOAT_VEC3, 1}},
            {{"model", GL_FLOAT_MAT4, 1},
             {"view", GL_FLOAT_MAT4, 1},
             {"projection", GL_FLOAT_MAT4, 1},
             {"light_count", GL_INT, 1},
             {"light_position", GL_FLOAT_VEC4, maximum_lights},
             {"light_color", GL_FLOAT_VEC3, maximum_lights},
             {"global_ambient", GL_FLOAT_VEC3, 1},
             {"emission", GL_FLOAT_VEC3, 1},
             {"ambient", GL_FLOAT_VEC3, 1},
             {"diffuse", GL_FLOAT_VEC3, 1},
             {"specular", GL_FLOAT_VEC3, 1},
             {"shininess", GL_FLOAT, 1},
             {"flat_shading", GL_INT, 1}}};
}

/// The case's shaders, compiled. Throws StudentError if they do not compile or are fed with something else.
inline std::unique_ptr<gl::Program> compile(const Case& what)
{
    auto program = std::make_unique<gl::Program>(gl::ShaderSource{"phong.vert", what.source("phong.vert")},
                                                 gl::ShaderSource{"phong.frag", what.source("phong.frag")});
    program->require_interface(shader_interface());
    return program;
}

/// The same, once for all times that the case is run.
inline const gl::Program& compiled(const Case& what)
{
    return what.once([&] { return compile(what); });
}

/// One thing in a scene.
struct Thing {
    Shape shape;
    glm::mat4 model{1};
    Material material;
};

struct Scene {
    glm::mat4 view{1};
    glm::mat4 projection{1};
    glm::vec3 global_ambient{0};
    std::vector<Light> lights;
    std::vector<Thing> things;
    bool flat = false;
    glm::vec3 unused_light{0};  ///< what stands in the entries of light_color beyond the last light
};

/// A glaring colour for entries that nothing may read.
inline constexpr glm::vec3 glaring(0.9F, 0, 0.9F);

/// Sets the lights; entries beyond the last one hold a light of the colour `unused`.
inline void set_lights(const gl::Program& program, const std::vector<Light>& lights, const glm::vec3& global_ambient,
                       const glm::vec3& unused)
{
    std::vector<glm::vec4> positions(maximum_lights, glm::vec4(0.3F, -0.4F, 1, 0));
    std::vector<glm::vec3> colors(maximum_lights, unused);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        positions[i] = lights[i].position;
        colors[i] = lights[i].color;
    }
    program.set("light_count", static_cast<int>(lights.size()));
    program.set("light_position", positions);
    program.set("light_color", colors);
    program.set("global_ambient", global_ambient);
}

inline void set_material(const gl::Program& program, const Material& material)
{
    program.set("emission", material.emission);
    program.set("ambient", material.ambient);
    program.set("diffuse", material.diffuse);
    program.set("specular", material.specular);
    program.set("shininess", material.shininess);
}

/// Says on the standard output what may be the cause of an empty picture: it is shown beside the result.
inline void comment_on(const Image& picture, const gl::Program& program)
{
    for (const glm::u8vec4& pixel : picture.cells)
        if (pixel != picture.cells.front()) return;
    std::string names;
    for (const std::string& name : gl::missing_names(shader_interface(), program.interface()))
        names += (names.empty() ? "" : ", ") + name;
    if (!names.empty()) std::printf("Nothing was drawn. Your shaders do not use: %s\n", names.c_str());
}

inline constexpr glm::vec3 default_background(0.09F, 0.10F, 0.13F);

/// A scene as the shaders draw it, 256 x 256.
inline Image draw(const Scene& scene, const gl::Program& program, const glm::vec3& background = default_background)
{
    const gl::Framebuffer frame(256, 256);
    frame.clear({background, 1});
    glEnable(GL_DEPTH_TEST);
    program.set("view", scene.view);
    program.set("projection", scene.projection);
    program.set("flat_shading", scene.flat ? 1 : 0);
    set_lights(program, scene.lights, scene.global_ambient, scene.unused_light);
    for (const Thing& thing : scene.things) {
        program.set("model", thing.model);
        set_material(program, thing.material);
        gl::Mesh(thing.shape.positions, thing.shape.normals, thing.shape.indices).draw(program);
    }
    Image picture = frame.read_pixels();
    comment_on(picture, program);
    return picture;
}

inline std::string lights_text(const std::vector<Light>& lights, const glm::vec3& global_ambient)
{
    std::vector<glm::vec4> positions;
    std::vector<glm::vec3> colors;
    for (const auto& [position, color] : lights) {
        positions.push_back(position);
        colors.push_back(color);
    }
    return uniform_line("global_ambient", global_ambient) + uniform_line("light_position", positions) +
           uniform_line("light_color", colors);
}

inline std::string material_text(const Material& material)
{
    return uniform_line("emission", material.emission) + uniform_line("ambient", material.ambient) +
           uniform_line("diffuse", material.diffuse) + uniform_line("specular", material.specular) +
           uniform_line("shininess", material.shininess);
}

/// What is drawn next, as the uniforms that the shaders are given; of many things, the first.
inline void ask_scene(Recorder& out, const Scene& scene)
{
    ask_in_words(out, [&] {
        std::string text = uniform_line("flat_shading", scene.flat ? 1 : 0) +
                           lights_text(scene.lights, scene.global_ambient) + uniform_line("view", scene.view);
        if (scene.things.empty()) return text;
        text += uniform_line("model", scene.things.front().model) + material_text(scene.things.front().material);
        const std::size_t more = scene.things.size() - 1;
        return text + "// a mesh of " + std::to_string(scene.things.front().shape.positions.size()) + " vertices" +
               (more > 0 ? "; and " + std::to_string(more) + " things more" : "");
    });
}

/// One point of a surface: its place and unit normal in eye coordinates, what it is made of and what lights it.
struct Probe {
    glm::vec3 position;
    glm::vec3 normal;
    Material material;
    std::vector<Light> lights;
    glm::vec3 global_ambient{0};
    glm::mat4 model{1};
    glm::mat4 view{1};
};

/// What the shaders are fed with for one point, under the names that they know.
struct PointInputs {
    glm::vec3 position{0};
    glm::vec3 normal{0};
    glm::mat4 view{1};
    glm::mat4 model{1};
    glm::vec3 global_ambient{0};
    std::vector<glm::vec4> light_position{};
    std::vector<glm::vec3> light_color{};
    glm::vec3 emission{0};
    glm::vec3 ambient{0};
    glm::vec3 diffuse{0};
    glm::vec3 specular{0};
    float shininess = 0;
};

inline PointInputs inputs_of(const Probe& probe)
{
    const Material& made_of = probe.material;
    PointInputs inputs{
        probe.position,   probe.normal,    probe.view,      probe.model,      probe.global_ambient, {}, {},
        made_of.emission, made_of.ambient, made_of.diffuse, made_of.specular, made_of.shininess};
    for (const auto& [position, color] : probe.lights) {
        inputs.light_position.push_back(position);
        inputs.light_color.push_back(color);
    }
    return inputs;
}

inline Probe probe_of(const PointInputs& inputs)
{
    Probe probe{inputs.position,
                inputs.normal,
                {inputs.emission, inputs.ambient, inputs.diffuse, inputs.specular, inputs.shininess},
                {},
                inputs.global_ambient,
                inputs.model,
                inputs.view};
    for (std::size_t i = 0; i < std::min(inputs.light_position.size(), inputs.light_color.size()); ++i)
        probe.lights.push_back({inputs.light_position[i], inputs.light_color[i]});
    return probe;
}

/// The colours (0 to 1) of single points, each drawn as one pixel: no triangle, no interpolation, smooth shading.
inline std::vector<glm::vec3> colors_of(const std::vector<Probe>& probes, const gl::Program& program)
{
    const auto size = static_cast<int>(probes.size());
    const gl::Framebuffer frame(size, 1);
    frame.clear();
    glEnable(GL_DEPTH_TEST);
    glPointSize(1);
    // Every point goes to the middle of its own pixel, wherever it lies.
    program.set("projection", to_centre());
    program.set("flat_shading", 0);
    for (int i = 0; i < size; ++i) {
        const Probe& probe = probes[static_cast<std::size_t>(i)];
        glViewport(i, 0, 1, 1);
        program.set("model", probe.model);
        program.set("view", probe.view);
        set_material(program, probe.material);
        set_lights(program, probe.lights, probe.global_ambient, glaring);
        // Back to the coordinates of the object; normals through the transpose, since the shader's way is the inverse
        // transpose.
        const glm::mat4 modelview = probe.view * probe.model;
        const std::vector positions(3, glm::vec3(inverse(modelview) * glm::vec4(probe.position, 1)));
        const std::vector normals(3, normalize(transpose(glm::mat3(modelview)) * probe.normal));
        gl::Mesh(positions, normals, std::vector<std::uint32_t>{0, 1, 2}).draw_points(program);
    }
    std::vector<glm::vec3> colors;
    for (const glm::u8vec4& pixel : frame.read_pixels().cells) colors.push_back(glm::vec3(pixel) / 255.0F);
    return colors;
}

}
