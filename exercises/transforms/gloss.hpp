#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

#include "../meshes/halved.hpp"

/// Polished surfaces whose positions and normals are in world coordinates already: a wrong normal shows at once. A context must be current.
namespace umbral::transforms {

/// A surface in the world, its colour in linear light.
struct GlossySurface {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
    glm::vec3 color;
};

/// A grid of (columns + 1) x (rows + 1) vertices as triangles; `vertex(surface, u, v)` adds the vertex at u and v in [0, 1].
template <class Vertex>
GlossySurface woven(int columns, int rows, const glm::vec3& color, Vertex vertex)
{
    GlossySurface surface{{}, {}, {}, color};
    for (int i = 0; i <= columns; ++i) {
        for (int j = 0; j <= rows; ++j) {
            vertex(surface, static_cast<float>(i) / static_cast<float>(columns), static_cast<float>(j) / static_cast<float>(rows));
            if (i == columns || j == rows) continue;
            const auto here = static_cast<std::uint32_t>(i * (rows + 1) + j);
            const std::uint32_t next = here + static_cast<std::uint32_t>(rows) + 1;
            surface.indices.insert(surface.indices.end(), {here, next, next + 1, here, next + 1, here + 1});
        }
    }
    return surface;
}

inline constexpr const char* gloss_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
uniform mat4 camera;
uniform float ground;
uniform float height;
uniform vec3 sun;
out vec3 world_position;
out vec3 world_normal;

void main()
{
    // On the ground everything is thrown along the light: the shadow.
    world_position = ground > 0.0 ? vec3(position.xz - sun.xz / sun.y * position.y, height).xzy : position;
    world_normal = normal;
    gl_Position = camera * vec4(world_position, 1.0);
}
)";

// Sun, sky and earth, a sharp highlight and a soft rim; the sRGB curve at the end. A normal of zero stays dark.
inline constexpr const char* gloss_fragment_shader = R"(#version 330 core
in vec3 world_position;
in vec3 world_normal;
uniform vec3 color;
uniform vec3 eye;
uniform vec3 sun;
uniform vec3 sky;
uniform float ground;
out vec4 fragment_color;

void main()
{
    vec3 n = world_normal;
    vec3 v = normalize(eye - world_position);
    float far = 1.0 - exp(-0.008 * dot(world_position.xz, world_position.xz));
    vec3 light = mix(vec3(0.15, 0.11, 0.08), vec3(0.30, 0.38, 0.50), 0.5 + 0.5 * n.y) + vec3(1.0, 0.90, 0.75) * max(dot(n, sun), 0.0);
    float facing = max(dot(n, v), 0.0);
    vec3 shade = color * light;
    shade += 0.55 * vec3(1.0, 0.95, 0.85) * pow(max(dot(n, normalize(sun + v)), 0.0), 90.0);
    shade += 0.45 * sky * pow(1.0 - facing, 4.0) * length(n);
    if (ground > 0.0) shade = color;
    fragment_color = vec4(pow(mix(shade, sky, ground > 0.0 ? far : 0.0), vec3(1.0 / 2.2)), 1.0);
}
)";

/// 320 x 320 pixels: the surfaces over a ground at y = 0 that fades into the sky, with their shadows.
inline Image draw_gloss(const std::vector<GlossySurface>& surfaces, const glm::vec3& eye, const glm::vec3& target)
{
    const gl::Framebuffer frame(640, 640);
    const glm::vec3 sky(0.42F, 0.52F, 0.62F);
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.75F, 1.1F, 0.65F));
    frame.clear(glm::vec4(glm::pow(sky, glm::vec3(1 / 2.2F)), 1));
    glEnable(GL_DEPTH_TEST);
    const gl::Program program({"gloss.vert", gloss_vertex_shader}, {"gloss.frag", gloss_fragment_shader});
    program.set("camera", glm::perspective(glm::radians(36.0F), 1.0F, 0.1F, 100.0F) * glm::lookAt(eye, target, glm::vec3(0, 1, 0)));
    program.set("eye", eye);
    program.set("sun", sun);
    program.set("sky", sky);
    const auto draw = [&](const gl::Mesh& mesh, const glm::vec3& color, float ground, float height) {
        program.set("color", color);
        program.set("ground", ground);
        program.set("height", height);
        mesh.draw(program);
    };
    // The ground is a fine net, so that it fades evenly; shadows lie a hair above it.
    const GlossySurface floor = woven(40, 40, {0.50F, 0.46F, 0.40F}, [](GlossySurface& s, float u, float v) {
        s.positions.push_back({60 * u - 30, 0, 60 * v - 30});
        s.normals.push_back({0, 1, 0});
    });
    draw(gl::Mesh(floor.positions, floor.normals, floor.indices), floor.color, 1, 0);
    for (const GlossySurface& surface : surfaces) {
        const gl::Mesh mesh(surface.positions, surface.normals, surface.indices);
        draw(mesh, {0.17F, 0.16F, 0.15F}, 1, 0.003F);
        draw(mesh, surface.color, 0, 0);
    }
    return halved(frame.read_pixels());
}

}
