#pragma once

#include <array>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/drawing.hpp>
#include <kit/shapes.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/pipeline/program.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// Where the student's shaders draw. They are compiled by gl::Program here, so that pictures do not depend on the
/// student's own class.
namespace umbral::pipeline {

inline gl::Interface minimal_interface()
{
    return {{{"position", GL_FLOAT_VEC3, 1}, {"color", GL_FLOAT_VEC3, 1}},
            {{"modelview", GL_FLOAT_MAT4, 1}, {"projection", GL_FLOAT_MAT4, 1}}};
}

inline gl::Interface lit_interface()
{
    return {{{"position", GL_FLOAT_VEC3, 1},
             {"normal", GL_FLOAT_VEC3, 1},
             {"color", GL_FLOAT_VEC3, 1},
             {"tex_coord", GL_FLOAT_VEC2, 1}},
            {{"modelview", GL_FLOAT_MAT4, 1},
             {"projection", GL_FLOAT_MAT4, 1},
             {"normal_matrix", GL_FLOAT_MAT3, 1},
             {"light", GL_FLOAT_VEC3, 1},
             {"image", GL_SAMPLER_2D, 1},
             {"lighting", GL_INT, 1},
             {"flat_shading", GL_INT, 1},
             {"textured", GL_INT, 1}}};
}

/// A shape with colours and texture coordinates; its vertices are a grid of `columns` cells.
inline AttributeMesh painted(const shapes::Shape& shape, int columns, glm::vec2 repeat, const gl::Program& program,
                             float waves = 2)
{
    std::vector<glm::vec2> tex_coords;
    std::vector<glm::vec3> colors;
    const auto width = static_cast<std::size_t>(columns) + 1;
    const float rows = static_cast<float>(shape.positions.size() / width - 1);
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        const float u = static_cast<float>(i % width) / static_cast<float>(columns);
        tex_coords.push_back(repeat * glm::vec2(u, static_cast<float>(i / width) / rows));
        const glm::vec3 wave = 0.5F + 0.5F * glm::cos(shapes::turn * (waves * u + glm::vec3(0, 0.33F, 0.67F)));
        colors.push_back(glm::mix(wave, glm::vec3(0.9F, 0.8F, 0.6F), 0.25F));
    }
    return {program,
            shape.indices,
            {{"position", shape.positions}, {"normal", shape.normals}, {"color", colors}, {"tex_coord", tex_coords}}};
}

/// A tile with a star, bound to texture unit `unit` while it lives.
class Tile {
public:
    explicit Tile(GLuint unit)
    {
        Drawing drawing(64, 64, {-1, -1}, {1, 1}, ink::blue);
        const auto star = [&](double outer, double inner, glm::vec3 color) {
            std::vector<glm::dvec2> corners;
            for (int i = 0; i < 16; ++i) {
                const double angle = 3.14159265358979 * i / 8;
                corners.push_back((i % 2 == 0 ? outer : inner) * glm::dvec2(std::cos(angle), std::sin(angle)));
            }
            drawing.area(corners, color);
        };
        star(0.98, 0.62, ink::white);
        star(0.8, 0.5, ink::orange);
        drawing.disc({0, 0}, 9, ink::white);
        for (const double x : {-1, 1})
            for (const double y : {-1, 1}) drawing.disc({x, y}, 14, ink::green);
        const Image picture = drawing.picture();
        glGenTextures(1, &texture_);
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture.cells.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    }
    Tile(const Tile&) = delete;
    Tile& operator=(const Tile&) = delete;
    ~Tile() { glDeleteTextures(1, &texture_); }

private:
    GLuint texture_ = 0;
};

/// How one picture, or one part of it, is drawn.
struct Shot {
    glm::mat4 modelview{1};
    glm::vec3 light{0, 0, 1};
    bool lighting = false;
    bool flat = false;
    bool textured = false;
    bool cut = false;     ///< along the tube, so that its inside shows
    bool ground = false;  ///< instead of a knot two triangles that reach from the viewer to far away
};

/// A floor below the viewer, turned: from less than 1 to 12 before them.
inline glm::mat4 ground(float turn)
{
    const glm::mat4 placed = glm::translate(glm::mat4(1), glm::vec3(0, -0.6F, -6.5F));
    return glm::rotate(glm::rotate(placed, turn, glm::vec3(0, 1, 0)), 0.1F, glm::vec3(1, 0, 0));
}

/// A model before the viewer, turned.
inline glm::mat4 seen(float turn, glm::vec3 stretch = glm::vec3(1))
{
    const glm::mat4 placed = glm::translate(glm::mat4(1), glm::vec3(0, 0, -4.8F));
    return glm::scale(glm::rotate(placed, turn, glm::vec3(0.35F, 1, 0.1F)), stretch);
}

/// A turn of the model that is written down; varied, one that shows other sides of it.
inline float varied_turn(Variation& vary, float turn)
{
    return vary.near(vary.one_of(turn, std::array{turn + 0.7F, turn - 0.7F, turn + 1.6F}), 0.2F);
}

/// What is drawn next: the texts, and the uniforms that change from shot to shot.
inline void ask_shots(Recorder& out, std::string_view texts, const std::vector<Shot>& shots)
{
    ask_in_words(out, [&] {
        std::string text = "// drawn with " + std::string(texts);
        for (const Shot& shot : shots)
            text += std::string(shot.ground ? "\n// a floor of two triangles"
                                : shot.cut  ? "\n// a knot, cut open along its tube"
                                            : "\n// a knot") +
                    "\nmodelview = " + literal::of_value(shot.modelview, true, {}) +
                    "\n    light = " + literal::of_value(shot.light, true, {}) +
                    ", lighting = " + (shot.lighting ? "1" : "0") + ", flat_shading = " + (shot.flat ? "1" : "0") +
                    ", textured = " + (shot.textured ? "1" : "0");
        return text;
    });
}

inline void draw(const Shot& shot, const AttributeMesh& model, const gl::Program& program)
{
    program.set("modelview", shot.modelview);
    program.set("normal_matrix", glm::inverseTranspose(glm::mat3(shot.modelview)));
    program.set("light", shot.light);
    program.set("image", 2);
    program.set("lighting", shot.lighting ? 1 : 0);
    program.set("flat_shading", shot.flat ? 1 : 0);
    program.set("textured", shot.textured ? 1 : 0);
    model.draw();
}

/// Four parts of a square picture, each another shot of the same knot; one shot alone fills the picture. Without texts
/// it stays empty.
inline Image draw(const std::vector<Shot>& shots, const ShaderTexts& texts, const gl::Interface& interface, int size)
{
    const DoubleFrame frame(size, size);
    if (texts.vertex.empty() && texts.fragment.empty()) return frame.picture();
    const gl::Program program({"your vertex shader", texts.vertex}, {"your fragment shader", texts.fragment});
    program.require_interface(interface);
    const Tile tile(2);
    constexpr int along = 72;
    constexpr int around = 12;
    shapes::Shape shape = shapes::trefoil(along, around, 0.3F);
    const AttributeMesh whole = painted(shape, along, {24, 4}, program);
    // Row by row: what faces the viewer is left out.
    shape.indices.erase(shape.indices.begin(),
                        shape.indices.begin() + static_cast<std::ptrdiff_t>(shape.indices.size() / around * 6));
    const AttributeMesh open = painted(shape, along, {24, 4}, program);
    // Its normals lean towards the corners.
    shapes::Shape flat = shapes::surface(1, 1, [](float u, float v) { return glm::vec3(8 * u - 4, 0, 6 - 12 * v); });
    for (std::size_t i = 0; i < flat.normals.size(); ++i)
        flat.normals[i] = glm::normalize(glm::vec3(0.12F, 1, 0.1F) * flat.positions[i] + glm::vec3(0, 1, 0));
    const AttributeMesh floor = painted(flat, 1, {5, 7}, program, 0.8F);
    glEnable(GL_DEPTH_TEST);
    program.set("projection", glm::perspective(glm::radians(32.0F), 1.0F, 0.5F, 20.0F));
    const int part = shots.size() > 1 ? size : 2 * size;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const int k = static_cast<int>(i);
        glViewport(part * (k % 2), 2 * size - part * (1 + k / 2), part, part);
        draw(shots[i], shots[i].ground ? floor : shots[i].cut ? open : whole, program);
    }
    return frame.picture();
}

}
