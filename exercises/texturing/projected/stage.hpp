#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/picture.hpp>
#include <kit/shapes.hpp>
#include <kit/single_points.hpp>
#include <memory>
#include <string>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/case.hpp>
#include <vector>

#include "../support.hpp"

/// Where the student's shaders meet OpenGL: the interface they must have, and how scenes and points go through them.
namespace umbral::texturing {

inline gl::Interface projected_interface()
{
    return {{{"position", GL_FLOAT_VEC3, 1}, {"normal", GL_FLOAT_VEC3, 1}, {"color", GL_FLOAT_VEC3, 1}},
            {{"model", GL_FLOAT_MAT4, 1},
             {"view", GL_FLOAT_MAT4, 1},
             {"projection", GL_FLOAT_MAT4, 1},
             {"projector_view", GL_FLOAT_MAT4, 1},
             {"projector_projection", GL_FLOAT_MAT4, 1},
             {"slide", GL_SAMPLER_2D, 1},
             {"projector_position", GL_FLOAT_VEC3, 1},
             {"lamp_color", GL_FLOAT_VEC3, 1},
             {"ambient", GL_FLOAT_VEC3, 1}}};
}

/// The case's shaders, compiled. Throws StudentError if they do not compile or are fed with something else.
inline std::unique_ptr<gl::Program> compile(const Case& what)
{
    auto program = std::make_unique<gl::Program>(gl::ShaderSource{"projected.vert", what.source("projected.vert")},
                                                 gl::ShaderSource{"projected.frag", what.source("projected.frag")});
    program->require_interface(projected_interface());
    return program;
}

/// The same, once for all times that the case is run.
inline const gl::Program& compiled(const Case& what)
{
    return what.once([&] { return compile(what); });
}

/// A slide, bound to texture unit 3 while it lives: decoded from sRGB when it is read, blended between texels. Its
/// alpha is no part of the light, and differs from texel to texel.
class Slide {
public:
    static constexpr int unit = 3;

    explicit Slide(const Grid<glm::vec4>& linear)
    {
        Image picture(linear.width, linear.height);
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column) {
                glm::u8vec4& texel = picture.at(column, picture.height - 1 - row);
                texel = pixel_of(glm::dvec3(linear.at(column, row)));
                texel.a = static_cast<std::uint8_t>(64 + (37 * column + 53 * row) % 192);
            }
        glGenTextures(1, &name_);
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture.cells.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        // Repeated: who does not ask whether a point lies in the beam sees more than one picture.
        glActiveTexture(GL_TEXTURE0);
    }
    Slide(const Slide&) = delete;
    Slide& operator=(const Slide&) = delete;
    ~Slide() { glDeleteTextures(1, &name_); }

private:
    GLuint name_ = 0;
};

/// Where a projector stands, how it projects, and its light.
struct Projector {
    glm::vec3 position{0};
    glm::mat4 view{1};
    glm::mat4 projection{1};
    glm::vec3 lamp{1};
    glm::vec3 ambient{0.05F};
};

/// A projector that looks at a place, its beam `width` times as wide as high.
inline Projector projector_at(const glm::vec3& position, const glm::vec3& target, float fovy_degrees, float width = 1)
{
    const glm::vec3 up =
        std::abs(glm::normalize(target - position).y) > 0.99F ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    return {position, glm::lookAt(position, target, up),
            glm::perspective(glm::radians(fovy_degrees), width, 0.1F, 50.0F)};
}

inline void set_projector(const gl::Program& program, const Projector& projector)
{
    program.set("projector_view", projector.view);
    program.set("projector_projection", projector.projection);
    program.set("projector_position", projector.position);
    program.set("lamp_color", projector.lamp);
    program.set("ambient", projector.ambient);
    program.set("slide", Slide::unit);
}

/// One thing in a scene, of one colour.
struct Thing {
    shapes::Shape shape;
    glm::mat4 model{1};
    glm::vec3 color{0.8F};
};

struct Scene {
    Projector projector;
    std::vector<Thing> things;
    glm::vec3 eye{0, 2, 6};
    glm::vec3 target{0};
    float fovy_degrees = 40;
};

inline std::string projector_text(const Projector& projector)
{
    return uniform_line("projector_view", projector.view) + uniform_line("projector_projection", projector.projection) +
           uniform_line("projector_position", projector.position) + uniform_line("lamp_color", projector.lamp) +
           uniform_line("ambient", projector.ambient);
}

/// A scene as the shaders draw it.
inline Image draw(Recorder& out, const gl::Program& program, const Scene& scene, int width, int height)
{
    ask_in_words(out, [&] {
        return projector_text(scene.projector) + "// " + std::to_string(scene.things.size()) + " things, seen from " +
               literal::of_value(scene.eye, true, {});
    });
    const DoubleFrame frame(width, height, {0.015F, 0.018F, 0.03F});
    glEnable(GL_DEPTH_TEST);
    program.set("view", glm::lookAt(scene.eye, scene.target, glm::vec3(0, 1, 0)));
    program.set("projection", glm::perspective(glm::radians(scene.fovy_degrees),
                                               static_cast<float>(width) / static_cast<float>(height), 0.1F, 60.0F));
    set_projector(program, scene.projector);
    for (const Thing& thing : scene.things) {
        const std::vector<glm::vec3> colors(thing.shape.positions.size(), thing.color);
        const AttributeMesh mesh(
            program, thing.shape.indices,
            {{"position", thing.shape.positions}, {"normal", thing.shape.normals}, {"color", colors}});
        program.set("model", thing.model);
        mesh.draw();
    }
    return frame.picture();
}

/// One point of a surface: its place and unit normal in the world, its colour, and the matrix it comes through.
struct Point {
    Projector projector;
    glm::vec3 place{0};
    glm::vec3 normal{0, 1, 0};
    glm::vec3 color{1};
    glm::mat4 model{1};
};

/// The colours (0 to 1, encoded) of single points, each drawn as one pixel: no triangle, no interpolation.
inline std::vector<glm::vec3> colors_of(const std::vector<Point>& points, const gl::Program& program)
{
    const auto size = static_cast<int>(points.size());
    const gl::Framebuffer frame(size, 1);
    frame.clear({1, 0, 1, 1});
    program.set("view", glm::mat4(1));
    program.set("projection", to_centre());
    draw_single_points(size, [&](std::size_t i) {
        const Point& point = points[i];
        program.set("model", point.model);
        set_projector(program, point.projector);
        // Back to the coordinates of the object; normals through the transpose, since the shader's way is the inverse
        // transpose.
        feed(program, "position", glm::vec3(inverse(point.model) * glm::vec4(point.place, 1)));
        feed(program, "normal", normalize(transpose(glm::mat3(point.model)) * point.normal));
        feed(program, "color", point.color);
    });
    std::vector<glm::vec3> colors;
    for (const glm::u8vec4& pixel : frame.read_pixels().cells) colors.push_back(glm::vec3(pixel) / 255.0F);
    return colors;
}

/// What the shaders are fed with for a point, under the names that they know; its place and normal in the world.
template <class Visit>
void for_each_input(Point& point, const Visit& visit)
{
    visit("position", point.place);
    visit("normal", point.normal);
    visit("color", point.color);
    visit("model", point.model);
    visit("projector_view", point.projector.view);
    visit("projector_projection", point.projector.projection);
    visit("projector_position", point.projector.position);
    visit("lamp_color", point.projector.lamp);
    visit("ambient", point.projector.ambient);
}

inline void record_points(Recorder& out, std::string_view name, const std::vector<Point>& points,
                          const gl::Program& program)
{
    record_single_points(
        out, name, "the shaders", points, [](const Point&) { return "// a point that lies here in the world:\n"; },
        [&](const std::vector<Point>& asked) { return colors_of(asked, program); });
}

}
