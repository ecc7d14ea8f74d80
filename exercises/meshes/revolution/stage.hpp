#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <kit/attributes.hpp>
#include <kit/stage.hpp>
#include <umbral/meshes/revolution.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

#include "profiles.hpp"

namespace umbral::meshes {

// The textures are formulas of (s, t): squares, bands with a zigzag, and the meridians and parallels of a globe.
inline constexpr const char* patterns = R"(
uniform int pattern;

float line(float value, float width)
{
    float pixel = fwidth(value);
    float distance = abs(fract(value + 0.5) - 0.5);
    return 1.0 - smoothstep(width, width + 1.5 * pixel, distance);
}

vec3 squares()
{
    vec2 cell = floor(st * vec2(16.0, 24.0));
    return mod(cell.x + cell.y, 2.0) < 0.5 ? vec3(0.86, 0.80, 0.66) : vec3(0.30, 0.13, 0.06);
}

vec3 bands()
{
    vec3 clay = vec3(0.72, 0.28, 0.10);
    vec3 black = vec3(0.03, 0.025, 0.03);
    float wave = abs(fract(st.s * 14.0) - 0.5) * 0.07;
    float t = st.t;
    vec3 color = t > 0.16 && t < 0.20 || t > 0.44 && t < 0.475 ? clay : black;
    if (t > 0.22 && t < 0.42) color = fract((t + wave) * 18.0) < 0.5 ? clay : black;
    if (t > 0.488 && t < 0.495) color = clay;
    return color;
}

vec3 globe()
{
    vec3 color = mix(vec3(0.05, 0.30, 0.55), vec3(0.10, 0.55, 0.50), 0.5 + 0.5 * sin(6.2831853 * (2.0 * st.s + st.t)));
    float grid = max(line(st.s * 12.0, 0.02), line(st.t * 8.0, 0.02));
    color = mix(color, vec3(0.9), grid);
    return mix(color, vec3(0.9, 0.35, 0.1), line(st.s, 0.006));
}

vec3 paint() { return pattern == 0 ? squares() : pattern == 1 ? bands() : globe(); }
)";

/// Draws the triangles whose vertices exist. Lists that are too short are filled up with zeros.
inline void draw(const gl::Program& program, TexturedMesh surface)
{
    const std::size_t count = surface.mesh.positions.size();
    surface.normals.resize(count, glm::vec3(0));
    surface.texture_coordinates.resize(count, glm::vec2(0));
    std::vector<std::uint32_t> indices;
    for (const glm::uvec3& t : surface.mesh.triangles)
        if (t.x < count && t.y < count && t.z < count) indices.insert(indices.end(), {t.x, t.y, t.z});
    AttributeMesh(program, indices,
                  {{"position", surface.mesh.positions},
                   {"normal", surface.normals},
                   {"texture_coordinates", surface.texture_coordinates}})
        .draw();
}

/// 600 x 260 pixels: a pawn, a vase and a globe. Varied, they are wider or more slender.
inline Image picture(Recorder& out, Variation& vary)
{
    constexpr int width = 200;
    constexpr int height = 260;
    const Stage stage(3 * width, height, ink::night, patterns);
    Profile profiles[] = {profiles::pawn(), vase(), semicircle(25)};
    for (Profile& profile : profiles) {
        const float wide = vary.one_of(1.0F, std::array{0.65F, 0.75F, 1.2F});
        for (glm::vec2& point : profile) point.x *= wide;
    }
    const float middles[] = {0.95F, 0.82F, 0};
    stage.set({.gloss = 0.35F});
    stage.program().set("two_sided", 1);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 target(0, middles[i], 0);
        stage.column(i, 3);
        stage.look(target + glm::vec3(1.2F, 1.7F, 5.6F), target, 25,
                   static_cast<float>(width) / static_cast<float>(height));
        stage.program().set("pattern", i);
        draw(stage.program(), ask<revolve>(out, profiles[i], 49));
    }
    return stage.picture();
}

}
