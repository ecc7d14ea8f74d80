#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <span>
#include <string>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

#include "double_frame.hpp"
#include "shading.hpp"
#include "shapes.hpp"

/// Where shapes stand in the light for a picture, drawn by OpenGL. A context must be current.
namespace umbral {

inline constexpr const char* stage_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec2 texture_coordinates;
uniform mat4 model;
uniform mat4 camera;
out vec3 place;
out vec3 world_normal;
out float normal_length;
out vec2 st;

void main()
{
    vec4 world = model * vec4(position, 1.0);
    place = world.xyz;
    st = texture_coordinates;
    // Normals go by the cofactors, which exist for every matrix; in mirrors these point inwards.
    mat3 m = mat3(model);
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    vec3 turned = cofactors * normal;
    if (dot(m[0], cofactors[0]) < 0.0) turned = -turned;
    normal_length = length(normal);
    world_normal = dot(turned, turned) > 0.0 ? normalize(turned) : vec3(0.0);
    gl_Position = camera * world;
}
)";

inline constexpr const char* stage_fragment_shader = R"(
in vec3 place;
in vec3 world_normal;
in float normal_length;
in vec2 st;
uniform vec3 color;
uniform vec3 odd_color;
uniform float gloss;
uniform float key;
uniform float fade;
uniform int two_sided;
uniform vec3 eye;
uniform vec3 sun;
uniform vec3 sky;
out vec4 fragment_color;

vec3 paint();

// Tiles of half a unit, a little below the surface, so that the sides of a floor do not lie on the border between two
// of them.
vec3 tiles()
{
    ivec2 tile = ivec2(floor((place.xz - 0.001 * world_normal.xz) * 2.0));
    return ((tile.x + tile.y) & 1) == 0 ? color : odd_color;
}

void main()
{
    vec3 n = dot(world_normal, world_normal) > 0.0 ? normalize(world_normal) : vec3(0.0);
    if (two_sided != 0 && !gl_FrontFacing) n = -n;
    // A normal that is too short or too long shows as too little or too much light. Shadows lie on the ground.
    float strength = key > 0.0 ? normal_length : 1.0;
    if (key == 0.0) n = vec3(0.0, 1.0, 0.0);
    vec3 shade = strength * lit(paint(), gloss, n, normalize(eye - place), sun, key);
    if (fade > 0.0) shade = mix(sky, shade, exp(-fade * dot(place.xz, place.xz)));
    fragment_color = vec4(srgb_encoded(shade), 1.0);
}
)";

/// What a thing on a stage looks like; colours in linear light.
struct Finish {
    glm::vec3 color{0.8F};
    float gloss = 0;                              ///< 0 for matt, about 0.5 for polished
    std::optional<glm::vec3> odd = std::nullopt;  ///< the other colour of a floor in tiles
    float fade = 0;  ///< how fast it fades into the background with the square of the distance from the y axis
};

/// The matrix that throws every point on the plane y = height along the light that comes from `sun`.
inline glm::mat4 shadow_matrix(const glm::vec3& sun, float height)
{
    glm::mat4 shadow(1);
    shadow[1] = {-sun.x / sun.y, 0, -sun.z / sun.y, 0};
    shadow[3] = {height * sun.x / sun.y, height, height * sun.z / sun.y, 1};
    return shadow;
}

/// A shape in the memory of the graphics card.
inline gl::Mesh uploaded(const shapes::Shape& shape) { return gl::Mesh(shape.positions, shape.normals, shape.indices); }

/// Places a box so that it is a ground whose upper side is y = 0.
inline glm::mat4 slab(float reach)
{
    return glm::scale(glm::translate(glm::mat4(1), {-reach, -0.1F, -reach}), {2 * reach, 0.1F, 2 * reach});
}

/// A picture of things in the light of a sun that stands at the upper left. It is drawn at twice its size.
class Stage {
public:
    /// Something to show: a mesh (which must live as long), where it stands, and its looks.
    struct Thing {
        const gl::Mesh& mesh;
        glm::mat4 model;
        Finish finish;
    };

    /// `background` is sRGB. `paint` is GLSL that defines `vec3 paint()`, the linear colour at `place` (in the world)
    /// or `st` (texture coordinates).
    Stage(int width, int height, const glm::vec3& background,
          const std::string& paint = "vec3 paint() { return tiles(); }\n")
        : frame_(width, height, background),
          program_({"stage.vert", stage_vertex_shader},
                   lit_fragment_shader("stage.frag", stage_fragment_shader + paint))
    {
        glEnable(GL_DEPTH_TEST);
        program_.set("sky", glm::vec3(srgb_decoded(glm::dvec3(background))));
        program_.set("sun", sun());
        program_.set("model", glm::mat4(1));
    }

    /// Draws from now on go into one of several columns of the picture.
    void column(int column, int columns) const
    {
        const int width = frame_.large().width() / columns;
        glViewport(width * column, 0, width, frame_.large().height());
    }

    /// Seen by a camera whose field of view is that high and `aspect` times as wide.
    void look(const glm::mat4& view, float fovy_degrees, float aspect = 1) const
    {
        program_.set("camera", glm::perspective(glm::radians(fovy_degrees), aspect, 0.1F, 100.0F) * view);
        program_.set("eye", glm::vec3(glm::inverse(view)[3]));
    }
    void look(const glm::vec3& eye, const glm::vec3& target, float fovy_degrees, float aspect = 1) const
    {
        look(glm::lookAt(eye, target, glm::vec3(0, 1, 0)), fovy_degrees, aspect);
    }

    /// Sets how what is drawn next looks; `key` is how much of the sun's light arrives.
    void set(const Finish& finish, float key = 1) const
    {
        program_.set("color", finish.color);
        program_.set("odd_color", finish.odd.value_or(finish.color));
        program_.set("gloss", finish.gloss);
        program_.set("fade", finish.fade);
        program_.set("key", key);
    }

    void draw(const Thing& thing, float key = 1) const
    {
        set(thing.finish, key);
        program_.set("model", thing.model);
        thing.mesh.draw(program_);
    }

    /// The things on a ground whose upper side is y = 0, with their shadows: the things once more in the ground's
    /// colours, flat, a hair above it.
    void draw_on(const Thing& ground, std::span<const Thing> things) const
    {
        draw(ground);
        for (const Thing& thing : things)
            draw({thing.mesh, shadow_matrix(sun(), 0.003F) * thing.model, ground.finish}, 0);
        for (const Thing& thing : things) draw(thing);
    }

    /// For what the functions above do not set: "two_sided", say, or uniforms of `paint`.
    [[nodiscard]] const gl::Program& program() const { return program_; }

    [[nodiscard]] Image picture() const { return frame_.picture(); }

    /// Towards the light.
    static glm::vec3 sun() { return glm::normalize(glm::vec3(-0.72F, 1.15F, 0.65F)); }

private:
    DoubleFrame frame_;
    gl::Program program_;
};

}
