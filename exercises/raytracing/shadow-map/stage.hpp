#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/shapes.hpp>
#include <kit/single_points.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <umbral/gl/program.hpp>
#include <umbral/record/case.hpp>
#include <umbral/record/recorder.hpp>
#include <vector>

/// Where the student's four shaders meet OpenGL: the interface they must have, the map, and how scenes go through both
/// passes.
namespace umbral::raytracing {

inline std::unique_ptr<gl::Program> compile_pass(const Case& what, const std::string& name, const gl::Interface& given)
{
    const std::string vertex = name + ".vert";
    const std::string fragment = name + ".frag";
    auto program = std::make_unique<gl::Program>(gl::ShaderSource{vertex, what.source(vertex)},
                                                 gl::ShaderSource{fragment, what.source(fragment)});
    program->require_interface(given);
    return program;
}

inline std::unique_ptr<gl::Program> compile_distances(const Case& what)
{
    return compile_pass(what, "distances",
                        {{{"position", GL_FLOAT_VEC3, 1}},
                         {{"model", GL_FLOAT_MAT4, 1},
                          {"light_view", GL_FLOAT_MAT4, 1},
                          {"light_projection", GL_FLOAT_MAT4, 1},
                          {"light", GL_FLOAT_VEC4, 1}}});
}

inline std::unique_ptr<gl::Program> compile_shadows(const Case& what)
{
    return compile_pass(what, "shadows",
                        {{{"position", GL_FLOAT_VEC3, 1}, {"normal", GL_FLOAT_VEC3, 1}, {"color", GL_FLOAT_VEC3, 1}},
                         {{"model", GL_FLOAT_MAT4, 1},
                          {"view", GL_FLOAT_MAT4, 1},
                          {"projection", GL_FLOAT_MAT4, 1},
                          {"light_view", GL_FLOAT_MAT4, 1},
                          {"light_projection", GL_FLOAT_MAT4, 1},
                          {"distances", GL_SAMPLER_2D, 1},
                          {"light", GL_FLOAT_VEC4, 1},
                          {"light_color", GL_FLOAT_VEC3, 1},
                          {"ambient", GL_FLOAT_VEC3, 1}}});
}

/// The same, once for all times that the case is run.
inline const gl::Program& compiled_shadows(const Case& what)
{
    return what.once([&] { return compile_shadows(what); });
}

/// What a map holds where the light sees nothing.
inline constexpr float nothing_seen = 1e30F;

/// The light's view plane: a texture of one float a texel, to draw into and to read, on texture unit 3 while it lives.
/// It repeats itself: who does not ask whether a point lies on the map sees its shadows again.
class DistanceMap {
public:
    static constexpr int unit = 3;

    DistanceMap(int width, int height) : width_(width), height_(height)
    {
        glGenTextures(1, &texture_);
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(1, &depth_);
        fill(Grid<float>(width, height, nothing_seen));
        glBindRenderbuffer(GL_RENDERBUFFER, depth_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("shadow-map: the driver refuses to draw floats");
    }
    DistanceMap(const DistanceMap&) = delete;
    DistanceMap& operator=(const DistanceMap&) = delete;
    ~DistanceMap()
    {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(1, &depth_);
        glDeleteTextures(1, &texture_);
    }

    /// Sets all texels; the first row of `cells` is the lowest of the map.
    void fill(const Grid<float>& cells) const
    {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, cells.width, cells.height, 0, GL_RED, GL_FLOAT, cells.cells.data());
        glActiveTexture(GL_TEXTURE0);
    }

    /// Draws from now on go here; it is emptied first.
    void begin() const
    {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glViewport(0, 0, width_, height_);
        const glm::vec4 empty(nothing_seen);
        glClearBufferfv(GL_COLOR, 0, &empty.x);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
    }

    /// What was drawn, top row first.
    [[nodiscard]] Grid<float> read() const
    {
        Grid<float> cells(width_, height_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        for (int y = 0; y < height_; ++y)
            glReadPixels(0, height_ - 1 - y, width_, 1, GL_RED, GL_FLOAT, &cells.at(0, y));
        return cells;
    }

private:
    int width_;
    int height_;
    GLuint texture_ = 0;
    GLuint framebuffer_ = 0;
    GLuint depth_ = 0;
};

/// A light with its view plane.
struct MapLight {
    glm::vec4 place{0, 0, 0, 1};  ///< as the shaders' `light`
    glm::mat4 view{1};
    glm::mat4 projection{1};
    glm::vec3 color{1};
    glm::vec3 ambient{0.05F};
    glm::ivec2 texels{512};
};

inline glm::mat4 light_view_of(const glm::vec3& from, const glm::vec3& to)
{
    const bool upright = std::abs(normalize(to - from).y) > 0.95F;
    return glm::lookAt(from, to, upright ? glm::vec3(0.3F, 0, -1) : glm::vec3(0, 1, 0));
}

/// A lamp at a place, its pyramid of light round the direction to `target`.
inline MapLight lamp_at(const glm::vec3& position, const glm::vec3& target, float fovy_degrees, float aspect = 1)
{
    return {glm::vec4(position, 1), light_view_of(position, target),
            glm::perspective(glm::radians(fovy_degrees), aspect, 0.05F, 60.0F)};
}

/// A sun far away in the direction of `towards`; its map is a box round `centre`, this far to each side.
inline MapLight sun_from(const glm::vec3& towards, const glm::vec3& centre, const glm::vec2& reach)
{
    const glm::vec3 direction = normalize(towards);
    return {glm::vec4(direction, 0), light_view_of(centre + 20.0F * direction, centre),
            glm::ortho(-reach.x, reach.x, -reach.y, reach.y, 0.1F, 60.0F)};
}

inline void set_light(const gl::Program& program, const MapLight& light)
{
    program.set("light_view", light.view);
    program.set("light_projection", light.projection);
    program.set("light", light.place);
    program.set("light_color", light.color);
    program.set("ambient", light.ambient);
    program.set("distances", DistanceMap::unit);
}

inline std::string light_text(const MapLight& light)
{
    return uniform_line("light", light.place) + uniform_line("light_view", light.view) +
           uniform_line("light_projection", light.projection);
}

struct ShadowThing {
    shapes::Shape shape;
    glm::mat4 model{1};
    glm::vec3 color{0.8F};
};

struct ShadowScene {
    MapLight light;
    std::vector<ShadowThing> things;
    glm::vec3 eye{0, 2, 6};
    glm::vec3 target{0};
    float fovy_degrees = 40;
    glm::vec3 background{0.015F, 0.018F, 0.03F};  ///< sRGB
};

inline void draw_things(const gl::Program& program, const ShadowScene& scene)
{
    set_light(program, scene.light);
    for (const ShadowThing& thing : scene.things) {
        const std::vector<glm::vec3> colors(thing.shape.positions.size(), thing.color);
        program.set("model", thing.model);
        AttributeMesh(program, thing.shape.indices,
                      {{"position", thing.shape.positions}, {"normal", thing.shape.normals}, {"color", colors}})
            .draw();
    }
}

inline std::string scene_text(const ShadowScene& scene)
{
    return light_text(scene.light) + "// " + std::to_string(scene.things.size()) + " things, and a map of " +
           std::to_string(scene.light.texels.x) + " x " + std::to_string(scene.light.texels.y) + " texels";
}

/// The first pass: the light's view of the scene.
inline Grid<float> map_of(Recorder& out, const gl::Program& distances, const ShadowScene& scene)
{
    ask_in_words(out, [&] { return "// the first pass\n" + scene_text(scene); });
    const DistanceMap map(scene.light.texels.x, scene.light.texels.y);
    map.begin();
    draw_things(distances, scene);
    return map.read();
}

/// Both passes.
inline Image picture_of(Recorder& out, const gl::Program& distances, const gl::Program& shadows,
                        const ShadowScene& scene, int width, int height)
{
    ask_in_words(out, [&] {
        return "// both passes\n" + scene_text(scene) + ", seen from " + literal::of_value(scene.eye, true, {});
    });
    const DistanceMap map(scene.light.texels.x, scene.light.texels.y);
    map.begin();
    draw_things(distances, scene);
    const DoubleFrame frame(width, height, scene.background);
    shadows.set("view", glm::lookAt(scene.eye, scene.target, glm::vec3(0, 1, 0)));
    shadows.set("projection", glm::perspective(glm::radians(scene.fovy_degrees),
                                               static_cast<float>(width) / static_cast<float>(height), 0.1F, 60.0F));
    draw_things(shadows, scene);
    return frame.picture();
}

}
