#pragma once

#include <kit/double_frame.hpp>
#include <memory>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/record/ask_inputs.hpp>
#include <umbral/record/case.hpp>
#include <umbral/record/recorder.hpp>
#include <vector>

/// Where the student's two fragment shaders meet OpenGL: one triangle that covers the picture, and what they are given.
namespace umbral::raytracing {

inline constexpr const char* whole_picture_shader = R"(#version 330
in vec2 corner;
uniform float aspect;
uniform vec2 shift;
out vec2 place;
void main()
{
    place = vec2(aspect * corner.x, corner.y) + shift;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

inline std::unique_ptr<gl::Program> compile_rays(const Case& what, const std::string& file, gl::Interface given)
{
    auto program = std::make_unique<gl::Program>(gl::ShaderSource{"driver.vert", whole_picture_shader},
                                                 gl::ShaderSource{file, what.source(file)});
    given.attributes = {{"corner", GL_FLOAT_VEC2, 1}};
    for (const gl::Variable& variable : std::vector<gl::Variable>{{"aspect", GL_FLOAT, 1},
                                                                  {"shift", GL_FLOAT_VEC2, 1},
                                                                  {"eye", GL_FLOAT_VEC3, 1},
                                                                  {"camera", GL_FLOAT_MAT3, 1},
                                                                  {"half_height", GL_FLOAT, 1},
                                                                  {"ambient", GL_FLOAT_VEC3, 1},
                                                                  {"horizon", GL_FLOAT_VEC3, 1},
                                                                  {"zenith", GL_FLOAT_VEC3, 1}})
        given.uniforms.push_back(variable);
    program->require_interface(given);
    return program;
}

inline std::unique_ptr<gl::Program> compile_ray_tracer(const Case& what)
{
    return compile_rays(what, "ray_tracer.frag",
                        {{},
                         {{"sphere_count", GL_INT, 1},
                          {"spheres", GL_FLOAT_VEC4, 8},
                          {"sphere_colors", GL_FLOAT_VEC3, 8},
                          {"mirrors", GL_FLOAT, 8},
                          {"tiles", GL_FLOAT_VEC3, 2},
                          {"floor_mirror", GL_FLOAT, 1},
                          {"floor_radius", GL_FLOAT, 1},
                          {"light_position", GL_FLOAT_VEC3, 1},
                          {"light_color", GL_FLOAT_VEC3, 1},
                          {"levels", GL_INT, 1}}});
}

inline std::unique_ptr<gl::Program> compile_distance_field(const Case& what)
{
    return compile_rays(what, "distance_field.frag",
                        {{},
                         {{"depth", GL_INT, 1},
                          {"ball", GL_FLOAT_VEC4, 1},
                          {"sponge_color", GL_FLOAT_VEC3, 1},
                          {"ball_color", GL_FLOAT_VEC3, 1},
                          {"sun", GL_FLOAT_VEC3, 1},
                          {"sun_color", GL_FLOAT_VEC3, 1}}});
}

/// A camera and a background, for both shaders.
struct RayLook {
    glm::vec3 eye{0, 1, 5};
    glm::vec3 target{0};
    float half_height = 0.5F;
    glm::vec3 ambient{0.15F};
    glm::vec3 horizon{0.6F};
    glm::vec3 zenith{0.2F};
};

inline glm::mat3 axes_of(const RayLook& look)
{
    const glm::vec3 back = normalize(look.eye - look.target);
    const glm::vec3 right = normalize(cross(glm::vec3(0.05F, 1, 0.02F), back));
    return {right, cross(back, right), back};
}

struct TracedBall {
    glm::vec4 sphere;
    glm::vec3 color;
    float mirror;
};

struct BallScene {
    RayLook look;
    std::vector<TracedBall> balls;
    glm::vec3 tiles[2] = {glm::vec3(0.8F), glm::vec3(0.15F)};
    float floor_mirror = 0;
    float floor_radius = 8;
    glm::vec3 light_position{3, 6, 4};
    glm::vec3 light_color{1};
    int levels = 4;
};

struct SpongeScene {
    RayLook look;
    int depth = 3;
    glm::vec4 ball{1, 1, 1, 0.8F};
    glm::vec3 sponge_color{0.8F};
    glm::vec3 ball_color{0.9F, 0.5F, 0.2F};
    glm::vec3 sun{0.3F, 0.8F, 0.5F};
    glm::vec3 sun_color{1};
};

inline void give_look(const gl::Program& program, const RayLook& look)
{
    program.set("eye", look.eye);
    program.set("camera", axes_of(look));
    program.set("half_height", look.half_height);
    program.set("ambient", look.ambient);
    program.set("horizon", look.horizon);
    program.set("zenith", look.zenith);
}

inline std::string camera_text(const RayLook& look)
{
    return uniform_line("eye", look.eye) + uniform_line("camera", axes_of(look));
}

inline std::string look_text(const RayLook& look)
{
    return camera_text(look) + uniform_line("half_height", look.half_height);
}

inline void give(const gl::Program& program, const BallScene& scene)
{
    give_look(program, scene.look);
    // Those beyond the count would be seen: some are round everything, others stand on the floor.
    std::vector<glm::vec4> spheres(8, glm::vec4(0, 1, 0, 100));
    for (std::size_t i = 0; i < spheres.size(); i += 2)
        spheres[i] = {0.45F * static_cast<float>(i) - 1.5F, 0.9F, 0.3F, 0.7F};
    std::vector<glm::vec3> colors(8, glm::vec3(1, 0, 1));
    std::vector<float> mirrors(8, 1.0F);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        spheres[i] = scene.balls[i].sphere;
        colors[i] = scene.balls[i].color;
        mirrors[i] = scene.balls[i].mirror;
    }
    program.set("sphere_count", static_cast<int>(scene.balls.size()));
    program.set("spheres", std::span<const glm::vec4>(spheres));
    program.set("sphere_colors", std::span<const glm::vec3>(colors));
    program.set("mirrors", std::span<const float>(mirrors));
    program.set("tiles", std::span<const glm::vec3>(scene.tiles));
    program.set("floor_mirror", scene.floor_mirror);
    program.set("floor_radius", scene.floor_radius);
    program.set("light_position", scene.light_position);
    program.set("light_color", scene.light_color);
    program.set("levels", scene.levels);
}

inline std::string balls_text(const BallScene& scene)
{
    std::string text;
    for (const TracedBall& ball : scene.balls)
        text += "// sphere " + literal::of_value(ball.sphere, true, {}) + ", color " +
                literal::of_value(ball.color, true, {}) + ", mirror " + literal::of_value(ball.mirror, true, {}) + "\n";
    return text;
}

inline std::string scene_text(const BallScene& scene)
{
    return look_text(scene.look) + uniform_line("light_position", scene.light_position) +
           uniform_line("levels", scene.levels) + uniform_line("floor_mirror", scene.floor_mirror) +
           uniform_line("floor_radius", scene.floor_radius) + balls_text(scene);
}

inline void give(const gl::Program& program, const SpongeScene& scene)
{
    give_look(program, scene.look);
    program.set("depth", scene.depth);
    program.set("ball", scene.ball);
    program.set("sponge_color", scene.sponge_color);
    program.set("ball_color", scene.ball_color);
    program.set("sun", normalize(scene.sun));
    program.set("sun_color", scene.sun_color);
}

inline std::string scene_text(const SpongeScene& scene)
{
    return look_text(scene.look) + uniform_line("depth", scene.depth) + uniform_line("ball", scene.ball) +
           uniform_line("sun", normalize(scene.sun));
}

/// One triangle over all of the viewport, while it lives.
class WholePicture {
public:
    explicit WholePicture(const gl::Program& program)
    {
        constexpr float corners[] = {-1, -1, 3, -1, -1, 3};
        glGenVertexArrays(1, &array_);
        glGenBuffers(1, &buffer_);
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
        const auto location = static_cast<GLuint>(program.attribute_location("corner"));
        glVertexAttribPointer(location, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(location);
        glDisable(GL_DEPTH_TEST);
    }
    WholePicture(const WholePicture&) = delete;
    WholePicture& operator=(const WholePicture&) = delete;
    ~WholePicture()
    {
        glDeleteVertexArrays(1, &array_);
        glDeleteBuffers(1, &buffer_);
    }

    void draw() const { glDrawArrays(GL_TRIANGLES, 0, 3); }

private:
    GLuint array_ = 0;
    GLuint buffer_ = 0;
};

template <class Scene>
Image drawn(Recorder& out, const gl::Program& program, const Scene& scene, int width, int height)
{
    ask_in_words(out, [&] { return "// a picture of\n" + scene_text(scene); });
    const DoubleFrame frame(width, height);
    program.set("aspect", static_cast<float>(width) / static_cast<float>(height));
    program.set("shift", glm::vec2(0));
    give(program, scene);
    WholePicture(program).draw();
    return frame.picture();
}

}
