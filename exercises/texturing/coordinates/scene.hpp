#pragma once

#include <kit/attributes.hpp>
#include <kit/shapes.hpp>
#include <kit/stage.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/coordinates.hpp>

/// The goal picture of texturing/coordinates: a vase, a globe and a box with a lid, each with coordinates of its kind,
/// on a floor whose tiles are projected on it.
namespace umbral::texturing {

inline constexpr const char* coordinates_paint = R"(
uniform int pattern;      // 0 floor, 1 globe, 2 vase, 3 box, 4 lid
uniform vec2 floor_at[3]; // coordinates of the floor's origin, and how they grow with x and with z

const vec3 lapis = vec3(0.015, 0.06, 0.27);
const vec3 gold = vec3(0.80, 0.42, 0.07);
const vec3 clay = vec3(0.46, 0.07, 0.025);
const vec3 cream = vec3(0.82, 0.76, 0.62);
const vec3 jade = vec3(0.02, 0.22, 0.17);

// 1 where `distance` is below 0, with an edge as wide as a pixel.
float inside(float distance, float pixel) { return clamp(0.5 - distance / max(pixel, 1e-5), 0.0, 1.0); }

// Distance to a star with eight points of radius 1, which is two squares.
float star(vec2 p)
{
    vec2 turned = vec2(p.x + p.y, p.y - p.x) * 0.70710678;
    return min(max(abs(p.x), abs(p.y)), max(abs(turned.x), abs(turned.y))) - 0.7071;
}

float wave(float x) { return abs(fract(x) - 0.5) * 2.0; }

vec3 floor_paint()
{
    vec2 at = floor_at[0] + place.x * floor_at[1] + place.z * floor_at[2];
    float pixel = 2.0 * max(fwidth(at.x), fwidth(at.y));
    vec2 p = 2.0 * fract(at) - 1.0;
    vec3 color = mix(vec3(0.72, 0.66, 0.54), vec3(0.12, 0.21, 0.24), inside(star(1.05 * p), pixel));
    color = mix(color, vec3(0.62, 0.33, 0.13), inside(star(2.3 * p) / 2.3, pixel));
    return mix(color, vec3(0.34, 0.30, 0.25), inside(0.965 - max(abs(p.x), abs(p.y)), pixel));
}

vec3 paint()
{
    vec2 pixel = fwidth(st);
    if (pattern == 0) return floor_paint();
    if (pattern == 1) {
        vec2 cell = st * vec2(16.0, 8.0);
        vec2 size = fwidth(cell);
        vec2 p = 2.0 * fract(cell) - 1.0;
        float edge = 2.0 * max(size.x, size.y);
        vec3 color = mix(lapis, cream, inside(star(1.5 * p) / 1.5, edge));
        color = mix(color, clay, inside(length(p) - 0.3, edge));
        float line = min((1.0 - abs(p.x)) / max(size.x, 1e-5), (1.0 - abs(p.y)) / max(size.y, 1e-5)) * 0.5;
        return mix(gold, color, smoothstep(1.4, 2.6, line));
    }
    if (pattern == 2) {
        float turn = st.x * 8.0 + st.y * 2.5;
        float back = st.x * 8.0 - st.y * 2.5;
        vec3 color = mix(cream, jade, inside(wave(turn) - 0.42, 2.0 * fwidth(turn)));
        color = mix(color, gold, inside(wave(back) - 0.16, 2.0 * fwidth(back)));
        return mix(color, jade, inside(0.44 - abs(st.y - 0.5), pixel.y));
    }
    if (pattern == 3) {
        float height = st.y * 6.0 + 0.75 * wave(st.x * 14.0);
        float edge = 2.0 * fwidth(height * 0.5);
        vec3 color = mix(clay, cream, inside(wave(height * 0.5) - 0.36, edge));
        color = mix(color, gold, inside(wave(height * 0.5 + 0.5) - 0.14, edge));
        return mix(color, gold, inside(0.435 - abs(st.y - 0.5), pixel.y));
    }
    vec2 p = st;
    float edge = max(pixel.x, pixel.y);
    vec3 color = mix(clay, gold, inside(star(p * 2.1) / 2.1, edge));
    color = mix(color, clay, inside(star(p * 2.6) / 2.6, edge));
    color = mix(color, cream, inside(length(p) - 0.1, edge));
    return mix(color, gold, inside(0.4 - abs(length(p) - 0.1), edge));
}
)";

/// Triangles with coordinates.
struct Textured {
    shapes::Shape shape;
    std::vector<glm::vec2> coordinates;
};

/// A ball of triangles of similar size, none of which knows of longitudes.
inline Textured globe(Recorder& out)
{
    const shapes::Shape ball = shapes::icosphere(3);
    Textured result;
    for (std::size_t i = 0; i + 2 < ball.indices.size(); i += 3) {
        std::array<glm::vec3, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = ball.positions[ball.indices[i + k]];
            result.shape.indices.push_back(static_cast<std::uint32_t>(i + k));
        }
        for (const glm::vec2& at : ask<spherical_triangle>(out, corners)) result.coordinates.push_back(at);
        result.shape.positions.insert(result.shape.positions.end(), corners.begin(), corners.end());
    }
    result.shape.normals = result.shape.positions;
    return result;
}

inline Textured vase(Recorder& out)
{
    constexpr int columns = 64;
    constexpr int rows = 48;
    Textured result;
    result.shape = shapes::surface(columns, rows, [](float u, float v) {
        const float radius = 0.34F + 0.3F * std::sin(5.1F * v + 0.1F) * (1 - 0.45F * v);
        return glm::vec3(radius * std::sin(shapes::turn * u), 1.75F * v, radius * std::cos(shapes::turn * u));
    });
    result.coordinates = ask<parametric_coordinates>(out, columns, rows);
    result.coordinates.resize(result.shape.positions.size());
    return result;
}

/// The wall of a round box, from just before the seam round to just behind it, which faces away.
inline Textured wall(Recorder& out, float height)
{
    Textured result;
    result.shape = shapes::surface(96, 1, [&](float u, float v) {
        const float angle = shapes::turn * (0.001F + 0.998F * u) - 0.5F * shapes::turn;
        return glm::vec3(std::cos(angle), height * (1 - v), std::sin(angle));
    });
    for (const glm::vec3& p : result.shape.positions)
        result.coordinates.push_back(ask<cylindrical_coordinates>(out, p, 0, height));
    return result;
}

inline Textured lid(Recorder& out, float height)
{
    Textured result;
    result.shape = shapes::surface(64, 2, [&](float u, float v) {
        const float angle = shapes::turn * u;
        const float radius = 1.05F * (1 - v);
        return glm::vec3(radius * std::sin(angle), height, radius * std::cos(angle));
    });
    result.shape.normals.assign(result.shape.positions.size(), {0, 1, 0});
    for (const glm::vec3& p : result.shape.positions)
        result.coordinates.push_back(
            ask<planar_coordinates>(out, p, TexturePlane{{0, height, 0}, {0.8F, 0, -0.6F}, {-0.6F, 0, -0.8F}}));
    return result;
}

/// Varied, it is seen from another side.
inline Image picture(Recorder& out, Variation vary = {})
{
    const Stage stage(512, 384, {0.80F, 0.84F, 0.88F}, coordinates_paint);
    stage.look(vary.turn({0, 1, 0}, 0.6F) * glm::vec3(0.35F, 2.35F, 6.2F), {0.02F, 0.72F, 0}, 29, 4.0F / 3);
    const gl::Program& program = stage.program();

    const TexturePlane tiles{{0.3F, 0, 0.2F}, {0.8F, 0, 0.6F}, {0.6F, 0, -0.8F}};
    std::array<glm::vec2, 3> at{};
    constexpr glm::vec3 places[] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < 3; ++i) at[i] = 1.6F * ask<planar_coordinates>(out, places[i], tiles);
    program.set("floor_at[0]", at[0]);
    program.set("floor_at[1]", at[1] - at[0]);
    program.set("floor_at[2]", at[2] - at[0]);

    const Finish ground{.color = glm::vec3(1), .gloss = 0, .fade = 0.012F};
    const gl::Mesh slab_mesh = uploaded(shapes::box());
    program.set("pattern", 0);
    stage.draw({slab_mesh, slab(14), ground});

    const auto model = [](glm::vec3 foot, glm::vec3 size, float turned) {
        return glm::scale(glm::rotate(glm::translate(glm::mat4(1), foot), turned, {0, 1, 0}), size);
    };
    struct Placed {
        Textured thing;
        glm::mat4 model;
        int pattern;
    };
    constexpr float box_height = 2.1F;
    const glm::mat4 box_model = model({1.55F, 0, -0.35F}, glm::vec3(0.6F), 4.4F);
    const Placed things[] = {{globe(out), model({0.06F, 0.78F, 0.45F}, glm::vec3(0.78F), -1.9F), 1},
                             {vase(out), model({-1.55F, 0, -0.3F}, glm::vec3(1), 0.4F), 2},
                             {wall(out, box_height), box_model, 3},
                             {lid(out, box_height), box_model, 4}};
    for (const bool shadow : {true, false})
        for (const Placed& placed : things) {
            const shapes::Shape& shape = placed.thing.shape;
            const AttributeMesh mesh(program, shape.indices,
                                     {{"position", shape.positions},
                                      {"normal", shape.normals},
                                      {"texture_coordinates", placed.thing.coordinates}});
            stage.set(shadow ? ground : Finish{.color = glm::vec3(1), .gloss = 0.3F}, shadow ? 0 : 1);
            program.set("pattern", shadow ? 0 : placed.pattern);
            program.set("model", shadow ? shadow_matrix(Stage::sun(), 0.003F) * placed.model : placed.model);
            mesh.draw();
        }
    return stage.picture();
}

}
