#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/meshes/revolution.hpp>
#include <vector>

#include "../halved.hpp"
#include "profiles.hpp"

namespace umbral::meshes {

inline constexpr const char* stage_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec2 texture_coordinates;
uniform mat4 view;
uniform mat4 projection;
out vec3 eye_position;
out vec3 eye_normal;
out vec2 st;

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    eye_position = eye.xyz;
    eye_normal = mat3(view) * normal;
    st = texture_coordinates;
    gl_Position = projection * eye;
}
)";

// The textures are formulas of (s, t): squares, bands with a zigzag, and the meridians and parallels of a globe.
inline constexpr const char* stage_fragment_shader = R"(#version 330 core
in vec3 eye_position;
in vec3 eye_normal;
in vec2 st;
uniform int pattern;
out vec4 fragment_color;

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

void main()
{
    float size = length(eye_normal);
    vec3 n = size > 0.0 ? eye_normal / size : vec3(0.0);
    if (!gl_FrontFacing) n = -n;
    vec3 v = normalize(-eye_position);
    vec3 key = normalize(vec3(-0.55, 0.7, 0.65));
    vec3 back = normalize(vec3(0.8, 0.3, -0.5));
    vec3 albedo = pattern == 0 ? squares() : pattern == 1 ? bands() : globe();
    vec3 light = mix(vec3(0.13, 0.11, 0.10), vec3(0.26, 0.30, 0.38), 0.5 + 0.5 * n.y) + vec3(0.95, 0.90, 0.82) * max(dot(n, key), 0.0);
    vec3 color = albedo * light + 0.30 * pow(max(dot(n, normalize(key + v)), 0.0), 50.0);
    color += vec3(0.25, 0.35, 0.45) * pow(1.0 - max(dot(n, v), 0.0), 3.0) * max(dot(n, back), 0.0);
    fragment_color = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}
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

    unsigned vertex_array = 0;
    std::array<unsigned, 4> buffers{};
    glGenVertexArrays(1, &vertex_array);
    glGenBuffers(4, buffers.data());
    glBindVertexArray(vertex_array);
    const auto feed = [&](const char* name, unsigned buffer, int components, const void* data) {
        const int place = program.attribute_location(name);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * static_cast<std::size_t>(components) * sizeof(float)), data, GL_STATIC_DRAW);
        if (place < 0) return;
        glEnableVertexAttribArray(static_cast<unsigned>(place));
        glVertexAttribPointer(static_cast<unsigned>(place), components, GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    feed("position", buffers[0], 3, surface.mesh.positions.data());
    feed("normal", buffers[1], 3, surface.normals.data());
    feed("texture_coordinates", buffers[2], 2, surface.texture_coordinates.data());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[3]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(), GL_STATIC_DRAW);
    program.use();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glDeleteBuffers(4, buffers.data());
    glDeleteVertexArrays(1, &vertex_array);
}

/// 600 x 260 pixels: a pawn, a vase and a globe.
inline Image picture()
{
    constexpr int width = 400;
    constexpr int height = 520;
    const gl::Framebuffer frame(3 * width, height);
    frame.clear({0.075F, 0.085F, 0.115F, 1});
    glEnable(GL_DEPTH_TEST);
    const gl::Program program({"stage.vert", stage_vertex_shader}, {"stage.frag", stage_fragment_shader});
    const Profile profiles[] = {pawn(), vase(), semicircle(25)};
    const float middles[] = {0.95F, 0.82F, 0};
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 target(0, middles[i], 0);
        program.set("view", glm::lookAt(target + glm::vec3(1.2F, 1.7F, 5.6F), target, glm::vec3(0, 1, 0)));
        program.set("projection", glm::perspective(glm::radians(25.0F), static_cast<float>(width) / static_cast<float>(height), 1.0F, 30.0F));
        program.set("pattern", i);
        glViewport(width * i, 0, width, height);
        draw(program, revolve(profiles[i], 49));
    }
    return halved(frame.read_pixels());
}

}
