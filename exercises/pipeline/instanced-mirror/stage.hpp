#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/color.hpp>
#include <kit/double_frame.hpp>
#include <kit/shapes.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/case.hpp>

/// Where the student's vertex shader meets OpenGL: its interface, the fragment shader behind it, and how a scene is
/// drawn in two instances.
namespace umbral::pipeline {

/// What of the scene is seen: most pictures look at one thing only, so that one mistake does not spoil them all.
enum class Look {
    all,     ///< light, and outside and inside in different colours
    places,  ///< two colours: things and images
    light,   ///< light, as if all of the mesh were seen from outside
    sides,   ///< outside and inside, without light
};

inline const char* const mirror_fragment_shader = R"(#version 330
in vec3 world_position;
in vec3 world_normal;
flat in int is_image;
flat in int winding;
uniform vec3 outside_color;
uniform vec3 inside_color;
uniform vec3 light;
uniform int look;
out vec4 pixel;
void main()
{
    bool outside = look == 2 || gl_FrontFacing == (winding > 0);
    vec3 n = normalize(world_normal) * (outside ? 1.0 : -1.0);
    float cosine = look == 3 ? 1.0 : max(0.0, dot(n, normalize(light - world_position)));
    vec3 color = (outside ? outside_color : inside_color) * (0.22 + 0.78 * cosine);
    if (look == 1) color = is_image == 1 ? vec3(0.20, 0.45, 0.65) : vec3(0.90, 0.62, 0.10);
    pixel = vec4(is_image == 1 ? mix(color, vec3(0.10, 0.22, 0.32), 0.35) : color, 1.0);
}
)";

inline gl::Interface mirror_interface()
{
    return {{{"position", GL_FLOAT_VEC3, 1}, {"normal", GL_FLOAT_VEC3, 1}},
            {{"model", GL_FLOAT_MAT4, 1},
             {"view", GL_FLOAT_MAT4, 1},
             {"projection", GL_FLOAT_MAT4, 1},
             {"mirror", GL_FLOAT_VEC4, 1},
             {"outside_color", GL_FLOAT_VEC3, 1},
             {"inside_color", GL_FLOAT_VEC3, 1},
             {"light", GL_FLOAT_VEC3, 1},
             {"look", GL_INT, 1}}};
}

struct Thing {
    shapes::Shape shape;
    glm::mat4 model{1};
    glm::vec3 outside{0.8F};
    glm::vec3 inside{0.3F};
};

struct Scene {
    std::vector<Thing> things;
    glm::vec4 mirror{0, 1, 0, 0};
    glm::vec3 eye{0, 1.5F, 6};
    glm::vec3 target{0};
    glm::vec3 light{4, 6, 5};
    bool lake = false;  ///< with a horizon, below which there is water
    Look look = Look::all;
    int instances = 2;
    float unit = 1;  ///< of length: how far near and far plane lie
};

/// The program with the case's vertex shader. Throws StudentError if it does not compile, link or fit.
inline gl::Program mirror_program(const Case& what)
{
    return gl::Program(gl::ShaderSource{"mirror.vert", what.source("mirror.vert")},
                       gl::ShaderSource{"driver.frag", mirror_fragment_shader});
}

/// Sky above the horizon, and water below it.
inline void paint_water(const glm::mat4& view, const glm::mat4& projection, int width, int height)
{
    const glm::vec4 far = projection * view * glm::vec4(0, 0, -1, 0);
    const auto rows = static_cast<int>(0.5F * (far.y / far.w + 1) * static_cast<float>(height));
    glEnable(GL_SCISSOR_TEST);
    constexpr int bands = 24;
    for (int i = 0; i < bands; ++i) {
        const float share = static_cast<float>(i + 1) / bands;
        glScissor(0, rows * i / bands, width, rows * (i + 1) / bands - rows * i / bands);
        glClearColor(0.03F + 0.05F * share, 0.06F + 0.12F * share, 0.10F + 0.14F * share, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
}

/// What is drawn next, as the uniforms that the shader is given.
inline void ask_scene(Recorder& out, const Scene& scene)
{
    ask_in_words(out, [&] {
        const auto line = [](const char* name, const auto& value) {
            return std::string(name) + " = " + literal::of_value(value, true, {}) + "\n";
        };
        constexpr std::size_t most = 3;
        std::string text = line("mirror", scene.mirror) + "view = glm::lookAt(" +
                           literal::of_value(scene.eye, true, {}) + ", " + literal::of_value(scene.target, true, {}) +
                           ", glm::vec3{0, 1, 0})\n";
        for (std::size_t i = 0; i < std::min(scene.things.size(), most); ++i)
            text += line("model", scene.things[i].model);
        if (scene.things.size() > most) text += "// … " + std::to_string(scene.things.size() - most) + " things more\n";
        return text + "// each thing is drawn " + (scene.instances == 1 ? "once" : "twice: gl_InstanceID is 0, then 1");
    });
}

inline Image draw(Recorder& out, const Scene& scene, const gl::Program& program, int width, int height)
{
    ask_scene(out, scene);
    const DoubleFrame frame(width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CLIP_DISTANCE0);
    const glm::mat4 view = glm::lookAt(scene.eye, scene.target, glm::vec3(0, 1, 0));
    const glm::mat4 projection =
        glm::perspective(glm::radians(40.0F), static_cast<float>(width) / static_cast<float>(height), 0.5F * scene.unit,
                         60 * scene.unit);
    if (scene.lake) paint_water(view, projection, 2 * width, 2 * height);
    program.set("view", view);
    program.set("projection", projection);
    program.set("mirror", scene.mirror);
    program.set("light", scene.light);
    program.set("look", static_cast<int>(scene.look));
    for (const Thing& thing : scene.things) {
        program.set("model", thing.model);
        program.set("outside_color", thing.outside);
        program.set("inside_color", thing.inside);
        AttributeMesh(program, thing.shape.indices,
                      {{"position", thing.shape.positions}, {"normal", thing.shape.normals}})
            .draw(scene.instances);
    }
    return frame.picture();
}

}
