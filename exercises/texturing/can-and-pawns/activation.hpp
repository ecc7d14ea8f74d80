#pragma once

#include <umbral/gl/framebuffer.hpp>

#include "plain.hpp"
#include "texels.hpp"

/// Cases of rubric lines 4 and 5: textures and materials.
namespace umbral::texturing {

// Rubric 4: textures.

/// What a part that nobody knows leaves: no texture bound, textures off or on, coordinates generated its own way or
/// not.
inline void leave_other_textures(Recorder& out, Random& random)
{
    const auto switched = [&](GLenum mode) { random.below(2) == 0 ? glEnable(mode) : glDisable(mode); };
    ask_in_words(out, [] { return "// somebody else binds no texture, and switches textures and generation"; });
    glBindTexture(GL_TEXTURE_2D, 0);
    switched(GL_TEXTURE_2D);
    for (const auto& [coordinate, mode] : {std::pair{GL_S, GL_TEXTURE_GEN_S}, {GL_T, GL_TEXTURE_GEN_T}}) {
        const glm::vec4 plane(random.in_cube(), random.uniform());
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, random.below(2) == 0 ? GL_EYE_LINEAR : GL_OBJECT_LINEAR);
        glTexGenfv(coordinate, GL_OBJECT_PLANE, value_ptr(plane));
        switched(mode);
    }
}

inline void show_texture(Recorder& out, const char* name, glm::ivec2 corner, LabTexture& texture, int height)
{
    glViewport(corner.x, height - corner.y - texture.picture.height, texture.picture.width, texture.picture.height);
    ask<activate_texture>(out, texture);
    draw_rectangle();
    out.tile(name, corner.x, corner.y, texture.picture.width, texture.picture.height);
}

/// Each texel is one pixel. The textures are activated in turn, each again after somebody else's state, and one of them
/// in the end.
inline void record_textures(Recorder& out, Random& random, bool generates)
{
    constexpr int height = 128;
    constexpr std::array<glm::ivec2, 4> sizes = {{{37, 23}, {64, 64}, {30, 41}, {1, 1}}};
    const gl::Framebuffer target(144, height);
    target.clear();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    std::vector<LabTexture> textures;
    for (const glm::ivec2 size : sizes) textures.push_back({.picture = random_picture(random, size.x, size.y)});
    for (std::size_t i = 0; i < textures.size(); ++i) {
        // Turned by a quarter, and shifted by whole texels: over the edge, where the texture begins again.
        textures[i].generates = generates && i != 2;
        const glm::vec2 size(sizes[i]);
        const float shift = std::floor(0.4F * size.x) / size.x;
        textures[i].s_plane = {0.5F, 0, 7, 1.5F - shift};
        textures[i].t_plane = {0, i == 1 ? -0.5F : 0.5F, 0, -0.5F};
    }
    int left = 0;
    for (LabTexture& texture : textures) {
        show_texture(out, "texels", {left, 0}, texture, height);
        leave_other_textures(out, random);
        show_texture(out, "texels", {left, 64}, texture, height);
        left += texture.picture.width + 1;
    }
    show_texture(out, "texels", {0, 40}, textures[0], height);
    out.image("texels", target.read_pixels());
}

inline void record_names(Recorder& out, Case& c)
{
    std::array<LabTexture, 3> textures;
    for (LabTexture& texture : textures)
        texture.picture = random_picture(c.random, c.vary.near(20, 8), c.vary.near(12, 5));
    constexpr std::array<std::size_t, 7> order = {0, 1, 0, 2, 2, 1, 0};
    const float before = living_texels();
    out.columns("made", "texels in OpenGL, uploads later than the first of this texture");
    std::array<bool, 3> made{};
    for (const std::size_t i : order) {
        gl::begin_trace();
        ask<activate_texture>(out, textures[i]);
        const std::uint64_t uploads = texture_uploads(gl::end_trace());
        const float later = made[i] ? static_cast<float>(uploads) : 0;
        made[i] = true;
        out.append("made", glm::vec2(living_texels() - before, later));
    }
}

// Rubric 5: materials.

inline void record_material(Recorder& out, const char* name, const Material& material, const LabTexture* label,
                            const LabTexture* wood)
{
    std::vector<float> row;
    for (const glm::vec4& color : {material.ambient, material.diffuse, material.specular})
        row.insert(row.end(), {color.r, color.g, color.b, color.a});
    row.push_back(material.exponent);
    row.push_back(material.texture == nullptr ? 0.0F
                  : material.texture == label ? 1.0F
                  : material.texture == wood  ? 2.0F
                                              : 3.0F);
    out.columns(name, "M_A/4, M_D/4, M_S/4, e, texture (0: none; 1: label; 2: wood)");
    out.append(name, std::span<const float>(row));
}

inline void materials(Case&, Recorder& out)
{
    LabTexture label;
    LabTexture wood;
    const Materials all = ask<make_materials>(out, label, wood);
    for (const Material* material : {&all.label, &all.metal, &all.wood, &all.white, &all.black})
        record_material(out, "numbers", *material, &label, &wood);
}

/// A material that nobody knows, with or without light and textures.
inline void leave_other_material(Recorder& out, Random& random)
{
    ask_in_words(out, [] { return "// somebody else sets a material, and switches light and textures"; });
    for (const GLenum mode : {GL_LIGHTING, GL_TEXTURE_2D}) random.below(2) == 0 ? glEnable(mode) : glDisable(mode);
    for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
        const glm::vec4 color(glm::abs(random.in_cube()), 1);
        glMaterialfv(GL_FRONT_AND_BACK, part, value_ptr(color));
    }
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, std::floor(128 * random.uniform()));
}

inline void record_activated(Recorder& out, const Material& material)
{
    ask<activate_material>(out, material);
    std::vector<float> row;
    for (const GLenum name : {GL_LIGHTING, GL_TEXTURE_2D}) row.push_back(glIsEnabled(name) == GL_TRUE ? 1.0F : 0.0F);
    for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
        std::array<GLfloat, 4> color{};
        glGetMaterialfv(GL_FRONT, part, color.data());
        row.insert(row.end(), color.begin(), color.end());
    }
    glGetMaterialfv(GL_FRONT, GL_SHININESS, &row.emplace_back());
    out.append("state", std::span<const float>(row));
}

// Each material twice, with somebody else's between.
inline void activated_materials(Case& c, Recorder& out)
{
    std::array<LabTexture, 2> textures;
    for (LabTexture& texture : textures) texture.picture = random_picture(c.random, 8, 8);
    textures[1].generates = true;
    const auto random_color = [&] {
        const float red = c.random.uniform();
        const float green = c.random.uniform();
        return glm::vec4(red, green, c.random.uniform(), 1);
    };
    out.columns("state",
                "GL_LIGHTING, GL_TEXTURE_2D, GL_AMBIENT/4, GL_DIFFUSE/4, GL_SPECULAR/4, GL_EMISSION/4, GL_SHININESS");
    for (int round = 0; round < 12; ++round) {
        // Exponents have fractions, and may be below 1 or 0; now and then a colour lacks one of its three.
        const float exponent = round % 4 == 1   ? 0.5F
                               : round % 4 == 3 ? std::floor(128 * c.random.uniform())
                                                : std::floor(512 * c.random.uniform()) / 4;
        Material material{random_color(), random_color(), random_color(), round == 5 ? 0 : exponent, nullptr};
        if (round % 2 == 0)
            for (glm::vec4* const color : {&material.ambient, &material.diffuse, &material.specular})
                (*color)[static_cast<int>(c.random.below(3))] = 0;
        const std::uint32_t which = c.random.below(4);
        if (which < 2) material.texture = &textures[which];
        if (round % 3 == 0) glDisable(GL_LIGHTING);
        if (which >= 2 && round % 2 == 0) glEnable(GL_TEXTURE_2D);
        record_activated(out, material);
        leave_other_material(out, c.random);
        record_activated(out, material);
        if (round % 3 != 0) continue;
        // Others after it that differ in a colour only, or in the exponent.
        for (glm::vec4* const color : {&material.ambient, &material.diffuse, &material.specular}) {
            *color = random_color();
            record_activated(out, material);
        }
        material.exponent = 128 - material.exponent;
        record_activated(out, material);
    }
}

}
