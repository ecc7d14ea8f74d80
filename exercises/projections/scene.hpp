#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

/// A small scene to look at through a student's matrices: a chequered floor, the world's axes as arrows (red x, green y, blue z),
/// and some boxes with their shadows. Drawn with OpenGL; a context must be current.
namespace umbral::projections {

/// Triangles before they are sent to OpenGL.
struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;

    void quad(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up)
    {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {corner, corner + along, corner + along + up, corner + up});
        normals.insert(normals.end(), 4, normalize(cross(along, up)));
        indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
};

/// The cube with corners at 0 and 1.
inline Shape box_shape()
{
    Shape box;
    box.quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    box.quad({1, 0, 0}, {-1, 0, 0}, {0, 1, 0});
    box.quad({1, 0, 1}, {0, 0, -1}, {0, 1, 0});
    box.quad({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    box.quad({0, 1, 1}, {1, 0, 0}, {0, 0, -1});
    box.quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    return box;
}

/// An arrow along z from the origin, of length 1: the profile (height, radius) of shaft and head, turned round the axis.
inline Shape arrow_shape()
{
    constexpr glm::vec2 profile[] = {{0, 0.022F}, {0.78F, 0.022F}, {0.78F, 0.065F}, {1, 0}};
    constexpr int sides = 24;
    Shape arrow;
    const auto around = [](float height, float radius, int side) {
        const float angle = 6.2831853F * static_cast<float>(side) / sides;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle), height);
    };
    for (int part = 0; part < 3; ++part) {
        const glm::vec2 low = profile[part];
        const glm::vec2 high = profile[part + 1];
        for (int side = 0; side < sides; ++side) {
            const auto first = static_cast<std::uint32_t>(arrow.positions.size());
            for (const int i : {side, side + 1}) {
                for (const glm::vec2& ring : {low, high}) arrow.positions.push_back(around(ring.x, ring.y, i));
                const glm::vec2 slope = glm::normalize(glm::vec2(low.y - high.y, high.x - low.x));
                arrow.normals.insert(arrow.normals.end(), 2, around(slope.x, slope.y, i));
            }
            arrow.indices.insert(arrow.indices.end(), {first, first + 2, first + 3, first, first + 3, first + 1});
        }
    }
    return arrow;
}

inline constexpr const char* scene_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
out vec3 world_position;
out vec3 world_normal;

void main()
{
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    // Enough for normals along the axes of a scaled box, and for uniform scales.
    world_normal = mat3(model) * normal;
    gl_Position = projection * view * world;
}
)";

// Light from the sun and the sky in linear light, the sRGB curve at the end.
inline constexpr const char* scene_fragment_shader = R"(#version 330 core
in vec3 world_position;
in vec3 world_normal;
uniform vec3 color;
uniform vec3 color_of_odd_tiles;
uniform vec3 sun;
uniform float lit;
out vec4 fragment_color;

void main()
{
    // A little below the surface, so that the sides of the floor do not lie on the border between two tiles.
    ivec2 tile = ivec2(floor((world_position.xz - 0.001 * world_normal.xz) * 2.0));
    vec3 albedo = ((tile.x + tile.y) & 1) == 0 ? color : color_of_odd_tiles;
    vec3 normal = lit > 0.0 ? normalize(world_normal) : vec3(0.0, 1.0, 0.0);
    vec3 sky = mix(vec3(0.20, 0.16, 0.13), vec3(0.30, 0.36, 0.46), 0.5 + 0.5 * normal.y);
    vec3 light = sky + lit * vec3(0.95, 0.88, 0.75) * max(dot(normal, sun), 0.0);
    fragment_color = vec4(pow(albedo * light, vec3(1.0 / 2.2)), 1.0);
}
)";

/// The matrix that throws every point on the plane y = height along the light that comes from `sun`.
inline glm::mat4 shadow_matrix(const glm::vec3& sun, float height)
{
    glm::mat4 shadow(1);
    shadow[1] = {-sun.x / sun.y, 0, -sun.z / sun.y, 0};
    shadow[3] = {height * sun.x / sun.y, height, height * sun.z / sun.y, 1};
    return shadow;
}

class Scene {
public:
    Scene() : box_(mesh_of(box_shape())), arrow_(mesh_of(arrow_shape())), program_({"scene.vert", scene_vertex_shader}, {"scene.frag", scene_fragment_shader})
    {
    }

    void draw(const glm::mat4& view, const glm::mat4& projection) const
    {
        program_.set("view", view);
        program_.set("projection", projection);
        program_.set("sun", sun());
        paint({0.80F, 0.78F, 0.72F}, {0.12F, 0.18F, 0.26F}, 1);
        program_.set("model", glm::scale(glm::translate(glm::mat4(1), {-2, -0.1F, -2}), {4, 0.1F, 4}));
        box_.draw(program_);

        // Shadows are unlit floor: the scene once more, flat, a hair above it.
        paint({0.80F, 0.78F, 0.72F}, {0.12F, 0.18F, 0.26F}, 0);
        things(shadow_matrix(sun(), 0.002F), false);
        things(glm::mat4(1), true);
    }

private:
    static gl::Mesh mesh_of(const Shape& shape) { return gl::Mesh(shape.positions, shape.normals, shape.indices); }
    static glm::vec3 sun() { return glm::normalize(glm::vec3(-0.7F, 1, 0.3F)); }

    void paint(const glm::vec3& even, const glm::vec3& odd, float lit) const
    {
        program_.set("color", even);
        program_.set("color_of_odd_tiles", odd);
        program_.set("lit", lit);
    }

    void thing(const gl::Mesh& mesh, const glm::mat4& model, const glm::vec3& color, bool painted) const
    {
        if (painted) paint(color, color, 1);
        program_.set("model", model);
        mesh.draw(program_);
    }

    void things(const glm::mat4& world, bool painted) const
    {
        const auto box = [&](glm::vec3 corner, glm::vec3 size, float turn, glm::vec3 color) {
            const glm::mat4 model = glm::scale(glm::rotate(glm::translate(world, corner), turn, {0, 1, 0}), size);
            thing(box_, model, color, painted);
        };
        box({-1.5F, 0, -1.4F}, {0.7F, 1.3F, 0.7F}, 0.3F, {0.68F, 0.14F, 0.06F});
        box({0.7F, 0, -1.3F}, {0.9F, 0.6F, 0.6F}, -0.35F, {0.88F, 0.50F, 0.05F});
        box({-1.5F, 0, 0.9F}, {0.5F, 0.5F, 0.5F}, 0.6F, {0.06F, 0.36F, 0.42F});
        box({1.0F, 0, 0.75F}, {0.35F, 0.35F, 0.35F}, 0.9F, {0.36F, 0.12F, 0.46F});
        const glm::mat4 origin = glm::translate(world, {0, 0.08F, 0});
        const auto arrow = [&](float turn, glm::vec3 axis, glm::vec3 color) {
            thing(arrow_, glm::scale(glm::rotate(origin, turn, axis), glm::vec3(1.25F)), color, painted);
        };
        constexpr float quarter = 1.5707963F;
        arrow(quarter, {0, 1, 0}, {0.80F, 0.02F, 0.02F});
        arrow(-quarter, {1, 0, 0}, {0.04F, 0.50F, 0.05F});
        arrow(0, {0, 1, 0}, {0.02F, 0.08F, 0.80F});
    }

    gl::Mesh box_;
    gl::Mesh arrow_;
    gl::Program program_;
};

/// The scene through a view matrix, in perspective (vertical field of view of 42 degrees), 256 x 256.
inline Image draw_scene(const glm::mat4& view)
{
    const gl::Framebuffer frame(256, 256);
    frame.clear({0.62F, 0.74F, 0.86F, 1});
    glEnable(GL_DEPTH_TEST);
    Scene().draw(view, glm::perspective(glm::radians(42.0F), 1.0F, 0.1F, 50.0F));
    return frame.read_pixels();
}

}
