#pragma once

#include <kit/attributes.hpp>
#include <kit/shapes.hpp>
#include <kit/stage.hpp>
#include <umbral/record/variation.hpp>

#include "observe.hpp"

/// The goal picture of texturing/dice-cube: two dice and a toy block on felt.
namespace umbral::texturing {

inline constexpr const char* dice_paint = R"(
uniform int pattern;   // 0 felt, 1 dice, 2 block
uniform vec3 body;
uniform vec3 pips;

float inside(float distance, float pixel) { return clamp(0.5 - distance / max(pixel, 1e-5), 0.0, 1.0); }

// Distance to the pips of a face, whose square is [-1, 1]^2.
float pip_distance(vec2 p, int value)
{
    float d = 9.0;
    float a = 0.52;
    if (value % 2 == 1) d = length(p);
    if (value >= 2) d = min(d, min(length(p - vec2(-a, a)), length(p - vec2(a, -a))));
    if (value >= 4) d = min(d, min(length(p - vec2(a, a)), length(p - vec2(-a, -a))));
    if (value == 6) d = min(d, min(length(p - vec2(-a, 0.0)), length(p - vec2(a, 0.0))));
    return d - (value == 1 ? 0.27 : 0.2);
}

vec3 die()
{
    vec2 grid = st * vec2(4.0, 3.0);
    ivec2 cell = ivec2(floor(clamp(grid, vec2(0.0), vec2(3.999, 2.999))));
    int value = 0;
    if (cell.y == 1) value = cell.x == 0 ? 6 : cell.x == 1 ? 5 : cell.x == 2 ? 1 : 2;
    else if (cell.x == 2) value = cell.y == 2 ? 3 : 4;
    if (value == 0) return vec3(0.9, 0.0, 0.5);
    vec2 p = 2.0 * (grid - vec2(cell)) - 1.0;
    float pixel = 2.0 * max(fwidth(grid.x), fwidth(grid.y));
    float rim = max(abs(p.x), abs(p.y));
    vec3 color = body * (1.0 - 0.35 * smoothstep(0.86, 1.0, rim));
    float d = pip_distance(p, value);
    vec3 hollow = pips * (0.75 + 0.25 * smoothstep(-0.2, 0.1, p.y - 0.3));
    return mix(mix(color, color * 0.72, inside(d - 0.035, pixel)), hollow, inside(d, pixel));
}

float segment(vec2 p, vec2 a, vec2 b)
{
    vec2 along = b - a;
    return length(p - a - along * clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0));
}

// A block of wood with the letter F, which shows when it is turned or mirrored.
vec3 block()
{
    vec2 p = 2.0 * st - 1.0;
    float pixel = 2.0 * max(fwidth(st.x), fwidth(st.y));
    float grain = sin(40.0 * st.y + 3.0 * sin(5.0 * st.x) + 1.5 * sin(9.0 * st.y));
    vec3 wood = mix(vec3(0.60, 0.37, 0.17), vec3(0.52, 0.29, 0.12), 0.5 + 0.5 * grain);
    float rim = max(abs(p.x), abs(p.y));
    vec3 color = mix(body, wood, inside(rim - 0.78, pixel));
    float letter = min(segment(p, vec2(-0.25, -0.5), vec2(-0.25, 0.5)),
                       min(segment(p, vec2(-0.25, 0.5), vec2(0.36, 0.5)),
                           segment(p, vec2(-0.25, 0.02), vec2(0.2, 0.02))));
    color = mix(color, pips, inside(letter - 0.125, pixel));
    return color * (1.0 - 0.3 * smoothstep(0.94, 1.0, rim));
}

vec3 paint()
{
    if (pattern == 1) return die();
    if (pattern == 2) return block();
    float weave = sin(60.0 * place.x) * sin(60.0 * place.z);
    return body * (1.0 + 0.05 * weave * exp(-0.02 * dot(place.xz, place.xz)));
}
)";

/// Where a cube lies: turned about its centre, then moved so that the centre comes to `centre`.
inline glm::mat4 lying(glm::vec3 centre, float size, float yaw, glm::vec3 axis, float angle)
{
    glm::mat4 model = glm::rotate(glm::translate(glm::mat4(1), centre), yaw, {0, 1, 0});
    model = glm::scale(glm::rotate(model, angle, axis), glm::vec3(size));
    return glm::translate(model, glm::vec3(-0.5F));
}

/// The same cube with the image upright on each side: how a side is turned is free, so it must not show. Mirrored
/// images stay mirrored.
inline TexturedCube upright(const TexturedCube& cube)
{
    const std::vector<Triangle> triangles = triangles_of(cube);
    TexturedCube result;
    for (const Side& side : sides) {
        const auto first = static_cast<unsigned>(result.positions.size());
        for (const glm::vec2& at : corners_of(triangles, side)) result.coordinates.push_back(at);
        for (const glm::vec2 place : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
            result.positions.push_back(side.at(place));
        result.triangles.emplace_back(first, first + 1, first + 2);
        result.triangles.emplace_back(first, first + 2, first + 3);
    }
    return result;
}

/// Varied, it is seen from another side.
inline Image picture(const TexturedCube& dice, const TexturedCube& lit, const TexturedCube& replicated,
                     Variation vary = {})
{
    const Stage stage(480, 360, {0.10F, 0.14F, 0.13F}, dice_paint);
    stage.look(vary.turn({0, 1, 0}, 1.5F) * glm::vec3(0.2F, 3.5F, 5.2F), {0.05F, 0.42F, 0}, 29, 4.0F / 3);
    const gl::Program& program = stage.program();
    const Finish felt{.fade = 0.03F};
    constexpr glm::vec3 felt_color(0.02F, 0.16F, 0.09F);
    program.set("pattern", 0);
    program.set("body", felt_color);
    program.set("pips", felt_color);
    const gl::Mesh ground = uploaded(shapes::box());
    stage.draw({ground, slab(20), felt});

    struct Placed {
        const TexturedCube& cube;
        glm::mat4 model;
        int pattern;
        glm::vec3 body, pips;
        bool own_normals;
    };
    constexpr float quarter = 1.5707963F;
    const Placed things[] = {{dice,
                              lying({-1.25F, 0.5F, 0.35F}, 1, 0.5F, {1, 0, 0}, 0),
                              1,
                              {0.78F, 0.72F, 0.58F},
                              {0.03F, 0.03F, 0.05F},
                              false},
                             {lit,
                              lying({0.3F, 0.5F, 0.75F}, 1, -0.75F, {1, 0, 0}, quarter),
                              1,
                              {0.50F, 0.02F, 0.025F},
                              {0.9F, 0.86F, 0.78F},
                              true},
                             {replicated,
                              lying({1.15F, 0.65F, -0.75F}, 1.3F, 0.55F, {0, 0, 1}, 0),
                              2,
                              {0.03F, 0.16F, 0.34F},
                              {0.55F, 0.05F, 0.03F},
                              false},
                             {dice,
                              lying({-0.35F, 0.5F, -1.05F}, 1, 1.1F, {0, 0, 1}, quarter),
                              1,
                              {0.03F, 0.10F, 0.30F},
                              {0.9F, 0.86F, 0.78F},
                              false}};
    for (const bool shadow : {true, false})
        for (const Placed& thing : things) {
            std::vector<glm::vec3> positions;
            std::vector<glm::vec3> normals;
            std::vector<glm::vec2> coordinates;
            std::vector<std::uint32_t> indices;
            for (const Triangle& triangle : triangles_of(thing.cube)) {
                const glm::vec3 flat = normalize(
                    cross(triangle[1].position - triangle[0].position, triangle[2].position - triangle[0].position));
                for (const Corner& corner : triangle) {
                    indices.push_back(static_cast<std::uint32_t>(indices.size()));
                    positions.push_back(corner.position);
                    normals.push_back(thing.own_normals ? corner.normal : flat);
                    coordinates.push_back(corner.coordinates);
                }
            }
            if (indices.empty()) continue;
            const AttributeMesh mesh(
                program, indices, {{"position", positions}, {"normal", normals}, {"texture_coordinates", coordinates}});
            stage.set(shadow ? felt : Finish{.gloss = 0.35F}, shadow ? 0 : 1);
            program.set("pattern", shadow ? 0 : thing.pattern);
            program.set("body", shadow ? felt_color : thing.body);
            program.set("pips", thing.pips);
            program.set("model", shadow ? shadow_matrix(Stage::sun(), 0.003F) * thing.model : thing.model);
            mesh.draw();
        }
    return stage.picture();
}

}
