#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

#include "../meshes/halved.hpp"
#include "../projections/scene.hpp"

/// Boxes, and other shapes with flat faces, under any affine matrix: the shader finds the normal of a face from the face itself.
/// Drawn with OpenGL; a context must be current.
namespace umbral::transforms {

/// One shape under one matrix, in linear colour.
struct Block {
    glm::mat4 model;
    glm::vec3 color;
};

inline constexpr const char* blocks_vertex_shader = R"(#version 330 core
in vec3 position;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
out vec3 world_position;

void main()
{
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    gl_Position = projection * view * world;
}
)";

// Sun, sky and the light that the floor throws back; far things fade into the sky; the sRGB curve at the end.
inline constexpr const char* blocks_fragment_shader = R"(#version 330 core
in vec3 world_position;
uniform vec3 color;
uniform vec3 eye;
uniform vec3 sun;
uniform vec3 sky;
uniform float lit;
out vec4 fragment_color;

void main()
{
    vec3 n = lit > 0.0 ? normalize(cross(dFdx(world_position), dFdy(world_position))) : vec3(0.0, 1.0, 0.0);
    vec3 around = mix(vec3(0.24, 0.19, 0.15), vec3(0.32, 0.38, 0.48), 0.5 + 0.5 * n.y);
    vec3 light = around + lit * vec3(0.95, 0.86, 0.72) * max(dot(n, sun), 0.0);
    vec3 shade = mix(color * light, sky, 1.0 - exp(-0.0035 * dot(world_position - eye, world_position - eye) * (1.0 - lit * 0.9)));
    fragment_color = vec4(pow(shade, vec3(1.0 / 2.2)), 1.0);
}
)";

/// Draws boxes that have their corners at 0 and 1 before their matrix, with their shadows, on a floor at y = 0; `size` x `size` pixels.
inline Image draw_blocks(const std::vector<Block>& blocks, const glm::vec3& eye, const glm::vec3& target, int size = 320)
{
    const gl::Framebuffer frame(2 * size, 2 * size);
    const glm::vec3 sky(0.33F, 0.50F, 0.70F);
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.8F, 1.3F, 0.6F));
    frame.clear(glm::vec4(glm::pow(sky, glm::vec3(1 / 2.2F)), 1));
    glEnable(GL_DEPTH_TEST);
    const projections::Shape shape = projections::box_shape();
    const gl::Mesh box(shape.positions, shape.normals, shape.indices);
    const gl::Program program({"blocks.vert", blocks_vertex_shader}, {"blocks.frag", blocks_fragment_shader});
    program.set("view", glm::lookAt(eye, target, glm::vec3(0, 1, 0)));
    program.set("projection", glm::perspective(glm::radians(40.0F), 1.0F, 0.1F, 200.0F));
    program.set("eye", eye);
    program.set("sun", sun);
    program.set("sky", sky);
    const auto draw = [&](const glm::mat4& model, const glm::vec3& color, float lit) {
        program.set("model", model);
        program.set("color", color);
        program.set("lit", lit);
        box.draw(program);
    };
    draw(glm::scale(glm::translate(glm::mat4(1), {-60, -0.1F, -60}), {120, 0.1F, 120}), {0.58F, 0.58F, 0.55F}, 0);
    // Lit floor is drawn unlit and brighter; shadows are the boxes once more, flat, a hair above it.
    for (const Block& block : blocks) draw(projections::shadow_matrix(sun, 0.004F) * block.model, {0.34F, 0.34F, 0.34F}, 0);
    for (const Block& block : blocks) draw(block.model, block.color, 1);
    return halved(frame.read_pixels());
}

}
