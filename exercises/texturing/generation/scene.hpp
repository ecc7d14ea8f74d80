#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/picture.hpp>
#include <kit/shapes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../support.hpp"
#include "measure.hpp"

/// The goal picture of texturing/generation: pawns on a tiled table. The left half is drawn by the fixed pipeline, the
/// right half by the programmable one; nobody should see where they meet. The table has texture coordinates of its own.
/// Pawns of wood have theirs from object coordinates, so that the grain lies as they lie; the two of light from eye
/// coordinates, so that the pattern hangs in front of the viewer.
namespace umbral::texturing {

/// The profile of a pawn: radius and height, v from foot to top.
inline glm::vec2 pawn_profile(float v)
{
    constexpr std::array<glm::vec2, 14> corners = {glm::vec2(0.02F, 0), {0.52F, 0.0F},  {0.54F, 0.10F}, {0.44F, 0.18F},
                                                   {0.42F, 0.26F},      {0.27F, 0.42F}, {0.20F, 0.70F}, {0.18F, 0.92F},
                                                   {0.32F, 1.00F},      {0.30F, 1.05F}, {0.20F, 1.09F}, {0.34F, 1.32F},
                                                   {0.22F, 1.52F},      {0.02F, 1.60F}};
    const float place = std::clamp(v, 0.0F, 1.0F) * static_cast<float>(corners.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), corners.size() - 2);
    const float t = place - static_cast<float>(i);
    const auto at = [&](std::size_t k) { return corners[std::min(k, corners.size() - 1)]; };
    // Catmull and Rom's curve through the corners.
    const glm::vec2 before = at(i == 0 ? 0 : i - 1);
    const glm::vec2 from = at(i);
    const glm::vec2 to = at(i + 1);
    const glm::vec2 after = at(i + 2);
    const glm::vec2 point =
        0.5F * (2.0F * from + (to - before) * t + (2.0F * before - 5.0F * from + 4.0F * to - after) * t * t +
                (3.0F * (from - to) + after - before) * t * t * t);
    return {std::max(point.x, 0.005F), point.y};
}

inline shapes::Shape pawn()
{
    return shapes::surface(72, 130, [](float u, float v) {
        const glm::vec2 at = pawn_profile(0.002F + 0.996F * v);
        return glm::vec3(at.x * std::sin(shapes::turn * u), at.y, at.x * std::cos(shapes::turn * u));
    });
}

/// Grain along t, darker and lighter along s.
inline Grid<glm::vec4> wood(int size)
{
    return painted(size, [](glm::vec2 p) {
        const float bent = p.x + 0.035F * std::sin(3.1415927F * p.y) + 0.02F * std::sin(6.2831853F * p.y + 1);
        const float rings = 0.5F + 0.5F * std::sin(3.1415927F * (4 * bent + 0.5F * std::sin(6.2831853F * bent)));
        const float fibre = 0.5F + 0.5F * std::sin(97 * bent + 5 * std::sin(3.1415927F * p.y));
        const glm::vec3 color =
            mix(glm::vec3(0.62F, 0.33F, 0.12F), glm::vec3(0.23F, 0.085F, 0.025F), glm::smoothstep(0.45F, 0.95F, rings));
        return color * (0.88F + 0.12F * fibre);
    });
}

/// A picture as a texture of OpenGL, sRGB as it is, repeated, with mipmaps; bound to unit 0 by bind().
class BoardTexture {
public:
    explicit BoardTexture(const Grid<glm::vec4>& linear)
    {
        Image picture(linear.width, linear.height);
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                picture.at(column, picture.height - 1 - row) = pixel_of(glm::dvec3(linear.at(column, row)));
        glGenTextures(1, &name_);
        bind();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture.cells.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    BoardTexture(const BoardTexture&) = delete;
    BoardTexture& operator=(const BoardTexture&) = delete;
    ~BoardTexture() { glDeleteTextures(1, &name_); }

    void bind() const { glBindTexture(GL_TEXTURE_2D, name_); }

private:
    GLuint name_ = 0;
};

/// One thing on the board.
struct Piece {
    const shapes::Shape& shape;
    glm::mat4 model;
    Generator generator;
    const BoardTexture& texture;
    glm::vec3 tint{1};
    bool is_table = false;
};

/// The balls that stand for the pawns where shadows are concerned: place and radius.
using Shadows = std::vector<glm::vec4>;

inline const glm::vec3 board_eye(0, 3.6F, 6.4F);

/// Light at each vertex, encoded as pixels are: the product with an encoded texture is nearly that of the lights.
inline std::vector<glm::vec3> lit_vertices(const Piece& piece, const Shadows& shadows)
{
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.8F, 1.1F, 0.55F));
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(piece.model)));
    std::vector<glm::vec3> colors;
    for (std::size_t i = 0; i < piece.shape.positions.size(); ++i) {
        const glm::vec3 place(piece.model * glm::vec4(piece.shape.positions[i], 1));
        const glm::vec3 n = glm::normalize(normals * piece.shape.normals[i]);
        float key = std::max(0.0F, dot(n, sun));
        float open = 0.5F + 0.5F * n.y;
        if (piece.is_table)
            for (const glm::vec4& ball : shadows) {
                const glm::vec3 to_ball = glm::vec3(ball) - place;
                const float beside = length(to_ball - dot(to_ball, sun) * sun);
                key *= glm::smoothstep(0.75F * ball.w, 1.25F * ball.w, beside);
                open *= 1 - 0.35F * std::exp(-length(glm::vec2(to_ball.x, to_ball.z)) / (0.9F * ball.w));
            }
        const float lamp = std::exp(-0.05F * (place.x * place.x + place.z * place.z));
        const glm::vec3 light =
            lamp * (open * glm::vec3(0.34F, 0.38F, 0.46F) + key * glm::vec3(1.0F, 0.90F, 0.76F)) + 0.02F;
        colors.push_back(glm::vec3(srgb_encoded(glm::dvec3(light * piece.tint))));
    }
    return colors;
}

inline void draw_fixed(Recorder& out, const Piece& piece, const glm::mat4& view, const std::vector<glm::vec3>& colors,
                       const std::vector<glm::vec2>& tex_coords)
{
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(value_ptr(view * piece.model));
    ask<set_generator>(out, piece.generator);
    piece.texture.bind();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t index : piece.shape.indices) {
        glColor3fv(value_ptr(colors[index]));
        glTexCoord2fv(value_ptr(tex_coords[index]));
        glVertex3fv(value_ptr(piece.shape.positions[index]));
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    ask<set_generator>(out, Generator{});
}

inline void draw_by_shader(const gl::Program& program, const Piece& piece, const glm::mat4& view,
                           const std::vector<glm::vec3>& colors, const std::vector<glm::vec2>& tex_coords)
{
    std::vector<glm::vec4> positions;
    for (const glm::vec3& position : piece.shape.positions) positions.emplace_back(position, 1);
    const AttributeMesh mesh(program, piece.shape.indices,
                             {{"position", positions}, {"tex_coord", tex_coords}, {"color", colors}});
    piece.texture.bind();
    program.set("modelview", view * piece.model);
    set_uniforms(program, piece.generator);
    mesh.draw();
}

/// A grid in the plane y = 0, fine enough for shadows; its texture coordinates are its own.
inline shapes::Shape table()
{
    return shapes::woven(160, 120, [](float u, float v) {
        return shapes::Vertex{{14 * (u - 0.5F), 0, 12 * (0.5F - v) - 1}, {0, 1, 0}};
    });
}

inline std::vector<glm::vec2> own_coordinates(const Piece& piece)
{
    std::vector<glm::vec2> result;
    for (const glm::vec3& place : piece.shape.positions)
        result.push_back(piece.is_table ? 0.9F * glm::vec2(place.x, -place.z) : glm::vec2(0));
    return result;
}

inline glm::mat4 standing(const glm::vec3& place, float turn)
{
    return glm::rotate(glm::translate(glm::mat4(1), place), turn, glm::vec3(0, 1, 0));
}

/// On its side, the rim of its foot and its head on the table.
inline glm::mat4 lying(const glm::vec3& place, float turn)
{
    return glm::rotate(standing(place + glm::vec3(0, 0.53F, 0), turn), 1.44F, glm::vec3(0, 0, 1));
}

/// Varied, the table is turned.
inline Image board(Recorder& out, int width, int height, Variation vary = {})
{
    const DoubleFrame frame(width, height, {0.03F, 0.035F, 0.05F});
    const gl::Program program({"your vertex shader", ask<generator_vertex_shader>(out)}, {"board.frag", R"(#version 330
in vec2 st;
in vec3 shade;
uniform sampler2D picture;
out vec4 color;
void main() { color = vec4(shade, 1.0) * texture(picture, st); }
)"});
    const BoardTexture grain(wood(256));
    const BoardTexture tile(star_tile(128));
    const BoardTexture braid(braid_tile(128));
    const shapes::Shape man = pawn();
    const shapes::Shape ground = table();
    const Generator carved{Generation::object, {0.9F, 0, 0.25F, 0.1F}, {0, 0.55F, 0, 0}};
    const Generator hanging{Generation::eye, {1.5F, 0, 0, 0.25F}, {0, 1.5F, 0, 0.4F}};
    const glm::vec3 dark(0.42F, 0.33F, 0.30F);
    const std::vector<Piece> pieces = {
        {ground, glm::mat4(1), {}, tile, glm::vec3(0.85F), true},
        {man, standing({-1.35F, 0, 0.7F}, 0.4F), carved, grain, glm::vec3(1.1F)},
        {man, standing({1.35F, 0, 0.7F}, 2.2F), carved, grain, glm::vec3(1.1F)},
        {man, lying({-2.25F, 0, 1.75F}, 3.4F), carved, grain, dark},
        {man, lying({2.2F, 0, 1.9F}, 0.25F), carved, grain, dark},
        {man, standing({-2.7F, 0, -0.9F}, 0), hanging, braid},
        {man, standing({2.7F, 0, -0.9F}, 1), hanging, braid},
        {man, glm::scale(standing({0, 0, -1.3F}, 0.9F), glm::vec3(1.55F)), carved, grain, glm::vec3(0.95F)}};
    Shadows shadows;
    for (const Piece& piece : pieces) {
        if (piece.is_table) continue;
        for (const float along : {0.2F, 0.55F, 0.9F, 1.3F}) {
            const float size = length(glm::vec3(piece.model[1]));
            const float radius = along < 0.3F ? 0.45F : along < 1 ? 0.26F : 0.34F;
            shadows.emplace_back(glm::vec3(piece.model * glm::vec4(0, along, 0, 1)), size * radius);
        }
    }
    const glm::mat4 view = glm::lookAt(board_eye, {0, 0.45F, 0}, {0, 1, 0}) * glm::mat4(vary.turn({0, 1, 0}, 0.6F));
    const glm::mat4 projection =
        glm::perspective(glm::radians(38.0F), static_cast<float>(width) / static_cast<float>(height), 0.5F, 40.0F);
    program.set("projection", projection);
    program.set("picture", 0);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(value_ptr(projection));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    for (const Piece& piece : pieces) {
        const std::vector<glm::vec3> colors = lit_vertices(piece, shadows);
        const std::vector<glm::vec2> tex_coords = own_coordinates(piece);
        glScissor(0, 0, width, 2 * height);
        draw_fixed(out, piece, view, colors, tex_coords);
        glScissor(width, 0, width, 2 * height);
        draw_by_shader(program, piece, view, colors, tex_coords);
    }
    glDisable(GL_SCISSOR_TEST);
    return frame.picture();
}

}
