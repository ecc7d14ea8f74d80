#pragma once

#include <optional>

#include "plain.hpp"

/// Cases of rubric line 2: meshes drawn.
namespace umbral::texturing {

// Rubric 2: meshes with coordinates, drawn.

inline constexpr int tile = 96;

inline void draw_tile(Recorder& out, const char* name, int column, const LitMesh& mesh, Shading shading)
{
    glViewport(2 * tile * column, 0, 2 * tile, 2 * tile);
    ask<draw>(out, mesh, shading);
    out.tile(name, tile * column, 0, tile, tile);
}

/// Without a texture, and with one; a large mesh, and one that is cut into two triangles only.
inline void record_drawn(Recorder& out, Random& random, Shading shading)
{
    const DoubleFrame frame(4 * tile, tile);
    light_by_normals();
    draw_tile(out, "picture", 0, motley(random, 5, true), shading);
    {
        const RainbowTexture texture;
        draw_tile(out, "picture", 1, motley(random, 5, true), shading);
        draw_tile(out, "picture", 2, motley(random, 1, true), shading);
    }
    draw_tile(out, "picture", 3, motley(random, 4, false), shading);
    out.image("picture", frame.picture());
}

/// What a draw must leave as it was; and a pixel, since who draws nothing leaves all alone.
inline void record_state(Recorder& out, const gl::Framebuffer& target)
{
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    std::vector<float> row(color.begin(), color.end());
    for (const GLenum name : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, GL_LIGHTING,
                              GL_TEXTURE_2D, GL_CULL_FACE, GL_DEPTH_TEST, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_BLEND})
        row.push_back(glIsEnabled(name) == GL_TRUE ? 1.0F : 0.0F);
    for (const GLenum name :
         {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM}) {
        GLint bound = 0;
        glGetIntegerv(name, &bound);
        row.push_back(static_cast<float>(bound));
    }
    const glm::u8vec4 pixel = target.read_pixels().at(40, 40);
    row.insert(row.end(), {pixel.r / 255.0F, pixel.g / 255.0F, pixel.b / 255.0F});
    out.columns("state",
                "GL_CURRENT_COLOR/4, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY, "
                "GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE, GL_DEPTH_TEST, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_BLEND, "
                "GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, "
                "GL_CURRENT_PROGRAM, a pixel/3");
    out.append("state", std::span<const float>(row));
}

inline void state_after_drawing(Case& c, Recorder& out)
{
    const gl::Framebuffer target(64, 64);
    light_by_normals();
    for (int round = 0; round < 8; ++round) {
        target.clear();
        glColor4f(c.random.uniform(), c.random.uniform(), c.random.uniform(), c.random.uniform());
        const auto set = [](GLenum name, bool on) { on ? glEnable(name) : glDisable(name); };
        set(GL_DEPTH_TEST, round % 2 == 0);
        set(GL_CULL_FACE, round % 3 == 0);
        set(GL_NORMALIZE, round % 4 == 1);
        set(GL_COLOR_MATERIAL, round % 4 == 2);
        glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, value_ptr(glm::vec4(1)));
        std::optional<RainbowTexture> texture;
        if (round % 3 != 1) texture.emplace();
        const LitMesh mesh = round == 5 ? LitMesh{} : motley(c.random, 2, round % 3 != 1);
        ask<draw>(out, mesh, round % 2 == 0 ? Shading::smooth : Shading::flat);
        record_state(out, target);
    }
}

}
