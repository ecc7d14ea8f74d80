#pragma once

#include <array>
#include <umbral/record/variation.hpp>

#include "stage.hpp"

/// What the cases of raytracing/shadow-map show.
namespace umbral::raytracing {

inline glm::mat4 standing(const glm::vec3& place, const glm::vec3& stretch = glm::vec3(1), float angle = 0,
                          const glm::vec3& axis = {0, 1, 0})
{
    return glm::rotate(glm::scale(glm::translate(glm::mat4(1), place), stretch), angle, axis);
}

inline shapes::Shape plain(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up)
{
    shapes::Shape shape;
    shape.quad(corner, along, up);
    return shape;
}

/// Every second field of a floor, or the others.
inline shapes::Shape checkers(const glm::vec3& corner, float field, int columns, int rows, int first)
{
    shapes::Shape shape;
    for (int row = 0; row < rows; ++row)
        for (int column = (row + first) % 2; column < columns; column += 2)
            shape.quad(corner + field * glm::vec3(column, 0, -row), {field, 0, 0}, {0, 0, -field});
    return shape;
}

inline void append_moved(shapes::Shape& all, const shapes::Shape& part, const glm::mat4& model)
{
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const glm::vec3& position : part.positions) all.positions.emplace_back(model * glm::vec4(position, 1));
    for (const glm::vec3& normal : part.normals) all.normals.push_back(glm::mat3(model) * normal);
    for (const std::uint32_t index : part.indices) all.indices.push_back(first + index);
}

/// A lattice of rings, each through the centres of its neighbours, in the plane x = 0 from (0, 0) to (depth, height).
inline shapes::Shape lattice(int columns, int rows, float spacing)
{
    shapes::Shape all;
    const shapes::Shape ring = shapes::torus(40, 8, 0.055F);
    const glm::mat4 upright =
        glm::rotate(glm::mat4(1), shapes::turn / 4, glm::vec3(0, 1, 0)) * glm::scale(glm::mat4(1), glm::vec3(spacing));
    const glm::mat4 turned(glm::mat3(upright) / spacing);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::vec3 centre(0, spacing * (static_cast<float>(row) + 0.5F),
                                   spacing * (static_cast<float>(column) + 0.5F));
            append_moved(all, ring, glm::scale(glm::translate(glm::mat4(1), centre) * turned, glm::vec3(spacing)));
        }
    for (glm::vec3& normal : all.normals) normal = normalize(normal);
    return all;
}

/// Morning in a courtyard: the sun comes through a lattice of rings, and lays it over floor, wall and what stands
/// there.
inline ShadowScene courtyard()
{
    ShadowScene scene;
    scene.light = sun_from({-1.0F, 0.47F, 0.36F}, {0.0F, 1.4F, -0.6F}, {5.8F, 5.6F});
    scene.light.color = {1.9F, 1.45F, 0.95F};
    scene.light.ambient = {0.10F, 0.13F, 0.20F};
    scene.light.texels = {1400, 1350};
    const glm::vec3 stone(0.78F, 0.70F, 0.60F);
    scene.things.push_back({checkers({-4, 0, 4}, 1, 8, 8, 0), glm::mat4(1), {0.74F, 0.66F, 0.55F}});
    scene.things.push_back({checkers({-4, 0, 4}, 1, 8, 8, 1), glm::mat4(1), {0.40F, 0.20F, 0.13F}});
    scene.things.push_back({plain({-4, 0, -4}, {8, 0, 0}, {0, 6, 0}), glm::mat4(1), stone});
    scene.things.push_back({plain({4, 0, -4}, {0, 0, 8}, {0, 6, 0}), glm::mat4(1), 0.9F * stone});
    // The wall that the sun comes through, seen from within: bars round the lattice.
    const auto bar = [&](const glm::vec3& corner, const glm::vec3& size) {
        scene.things.push_back({shapes::box(), standing(corner, size), 0.8F * stone});
    };
    bar({-4.2F, 0, -4}, {0.2F, 0.5F, 8});
    bar({-4.2F, 4.1F, -4}, {0.2F, 5, 8});
    bar({-4.2F, 0, -4}, {0.2F, 6, 0.4F});
    bar({-4.2F, 0, 3.2F}, {0.2F, 6, 0.8F});
    scene.things.push_back({lattice(8, 4, 0.9F), standing({-4.1F, 0.5F, -3.8F}), {0.34F, 0.22F, 0.13F}});
    scene.things.push_back({shapes::box(), standing({-0.55F, 0, -1.2F}, {1.1F, 0.9F, 1.1F}), stone});
    scene.things.push_back({shapes::trefoil(220, 28, 0.18F),
                            standing({0, 1.95F, -0.65F}, glm::vec3(0.98F), 0.45F),
                            {0.95F, 0.55F, 0.16F}});
    scene.things.push_back(
        {shapes::sphere(72, 36), standing({1.9F, 0.6F, 0.7F}, glm::vec3(0.6F)), {0.16F, 0.42F, 0.50F}});
    scene.things.push_back(
        {shapes::sphere(64, 32), standing({-1.45F, 0.33F, 1.15F}, glm::vec3(0.33F)), {0.62F, 0.16F, 0.12F}});
    scene.eye = {0.9F, 2.5F, 8.2F};
    scene.target = {-0.15F, 1.35F, -0.8F};
    scene.fovy_degrees = 38;
    return scene;
}

/// A fan of slopes in a coarse map, and no shadow on any of them: only thin sheets a little above the floor throw one.
inline ShadowScene slopes()
{
    ShadowScene scene;
    scene.light = sun_from({0.35F, 0.7F, 0.6F}, {0, 0, 0}, {4.6F, 3.4F});
    scene.light.texels = {60, 44};
    scene.things.push_back({plain({-5, 0, 4}, {10, 0, 0}, {0, 0, -8}), glm::mat4(1), glm::vec3(0.8F)});
    for (int i = 0; i < 5; ++i) {
        const auto k = static_cast<float>(i);
        const float angle = 0.35F + 0.5F * k;
        const glm::vec3 up(0, 1.5F * std::sin(angle), -1.5F * std::cos(angle));
        scene.things.push_back({plain({1.55F * k - 3.75F, 0.3F, -1.2F}, {1.2F, 0, 0}, up), glm::mat4(1),
                                glm::vec3(0.9F, 0.55F + 0.08F * k, 0.3F)});
        scene.things.push_back({shapes::box(),
                                standing({1.55F * k - 3.6F, 0.12F + 0.12F * k, 1.2F}, {0.9F, 0.04F, 0.9F}),
                                {0.3F, 0.6F, 0.8F}});
    }
    scene.eye = {0, 4.5F, 7.5F};
    scene.target = {0, 0.2F, 0};
    return scene;
}

/// A map so coarse that its texels are seen on the floor, each in its place.
inline ShadowScene coarse_map()
{
    ShadowScene scene;
    scene.light = lamp_at({1.2F, 4, 2.2F}, {0.1F, 0, 0}, 60, 1.5F);
    scene.light.texels = {36, 24};
    scene.things.push_back({plain({-5, 0, 4}, {10, 0, 0}, {0, 0, -8}), glm::mat4(1), glm::vec3(0.85F, 0.8F, 0.7F)});
    scene.things.push_back(
        {shapes::trefoil(120, 16, 0.16F), standing({0.3F, 1.1F, -0.2F}, glm::vec3(0.8F), 0.6F), {0.7F, 0.3F, 0.2F}});
    scene.eye = {-1, 5, 6};
    scene.target = {0, 0.2F, -0.2F};
    return scene;
}

/// A lamp among balls: its shadows run away from it.
inline ShadowScene lamp()
{
    ShadowScene scene;
    scene.light = lamp_at({0.2F, 2.6F, 0.1F}, {0.25F, 0, 0}, 125, 1.3F);
    scene.light.color = {1.3F, 1.1F, 0.8F};
    scene.light.texels = {780, 600};
    scene.things.push_back({plain({-8, 0, 6}, {16, 0, 0}, {0, 0, -12}), glm::mat4(1), glm::vec3(0.8F)});
    scene.things.push_back({plain({-8, 0, -3.2F}, {16, 0, 0}, {0, 5, 0}), glm::mat4(1), glm::vec3(0.6F, 0.65F, 0.75F)});
    const shapes::Shape ball = shapes::sphere(48, 24);
    for (int i = 0; i < 7; ++i) {
        const float turn = shapes::turn * (static_cast<float>(i) + 0.3F) / 7;
        const float size = 0.25F + 0.05F * static_cast<float>(i);
        scene.things.push_back(
            {ball, standing({1.9F * std::cos(turn), size, 1.7F * std::sin(turn)}, glm::vec3(size)),
             glm::vec3(0.3F + 0.09F * static_cast<float>(i), 0.5F, 0.8F - 0.1F * static_cast<float>(i))});
    }
    scene.eye = {0.5F, 5, 7};
    scene.target = {0, 0.3F, -0.4F};
    return scene;
}

/// A narrow map over a wide floor: all round it there is light; and behind the lamp too.
inline ShadowScene beyond_the_map()
{
    ShadowScene scene;
    scene.light = lamp_at({-1.2F, 1.7F, 2.4F}, {0.2F, 0.4F, -0.2F}, 32, 4.0F / 3);
    scene.light.texels = {320, 240};
    scene.things.push_back({plain({-7, 0, 7}, {14, 0, 0}, {0, 0, -14}), glm::mat4(1), glm::vec3(0.85F)});
    scene.things.push_back(
        {shapes::torus(64, 16, 0.25F), standing({0, 0.7F, 0}, glm::vec3(0.65F), 0.5F), {0.85F, 0.5F, 0.2F}});
    scene.things.push_back(
        {shapes::sphere(48, 24), standing({-2.2F, 0.4F, 4.2F}, glm::vec3(0.4F)), {0.3F, 0.5F, 0.8F}});
    scene.eye = {0.5F, 6.5F, 8};
    scene.target = {-0.4F, 0, 0.6F};
    return scene;
}

/// A pane that faces a sun, with the normals of a pillow: what lies between its corners has shorter ones.
inline ShadowThing pillow(const glm::vec3& sun, const glm::vec3& place)
{
    const glm::vec3 u = normalize(cross(glm::vec3(0, 1, 0), sun));
    const glm::vec3 v = cross(sun, u);
    shapes::Shape pane = plain(-0.6F * u - 0.6F * v, 1.2F * u, 1.2F * v);
    for (std::size_t i = 0; i < pane.normals.size(); ++i)
        pane.normals[i] = normalize(pane.normals[i] + 1.2F * pane.positions[i]);
    return {pane, standing(place), glm::vec3(0.9F)};
}

/// Balls that are stretched and turned, in the shadows of each other, and a pillow.
inline ShadowScene stretched()
{
    ShadowScene scene;
    scene.light = sun_from({0.9F, 0.5F, 0.6F}, {0, 0, 0}, {4, 2.4F});
    scene.light.texels = {640, 384};
    const shapes::Shape ball = shapes::sphere(64, 32);
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<float>(i);
        const glm::mat4 at = glm::rotate(glm::translate(glm::mat4(1), {1.3F * k - 1.95F, 0, 0.2F * k}), 0.7F * k + 0.3F,
                                         normalize(glm::vec3(0.3F, 0.4F, 1)));
        scene.things.push_back({ball, glm::scale(at, {0.35F + 0.1F * k, 0.95F, 0.65F - 0.1F * k}), glm::vec3(0.9F)});
    }
    scene.things.push_back(pillow(glm::vec3(scene.light.place), {0.2F, -1.3F, 1.6F}));
    scene.eye = {0, 0.6F, 6.5F};
    return scene;
}

/// The scene with all that stands in it turned under the eye, light and map too, and light of another tint; as written
/// unless inputs are to vary.
inline ShadowScene varied(Variation& vary, ShadowScene scene)
{
    if (!vary) return scene;
    const float angle = vary.one_of(0.0F, std::array{-0.5F, -0.35F, 0.35F, 0.5F});
    const glm::mat4 turn = glm::rotate(glm::mat4(1), angle, {0, 1, 0});
    for (ShadowThing& thing : scene.things) thing.model = turn * thing.model;
    scene.light.place = turn * scene.light.place;
    scene.light.view = scene.light.view * inverse(turn);
    scene.light.color *= vary.near(glm::vec3(0.75F), 0.25F);
    return scene;
}

/// What the light sees of a few things, of which one is half beyond the border, and one behind another.
inline ShadowScene seen_by(const MapLight& light)
{
    ShadowScene scene;
    scene.light = light;
    scene.light.texels = {64, 48};
    scene.things.push_back({plain({-3, -1, 2}, {6, 0, 0}, {0, 0, -5}), glm::mat4(1), glm::vec3(1)});
    scene.things.push_back({shapes::sphere(24, 12), standing({-0.5F, 0, 0}, {0.7F, 0.5F, 0.9F}, 0.4F), glm::vec3(1)});
    scene.things.push_back({shapes::torus(32, 12, 0.3F), standing({0.7F, 0.3F, -0.8F}, glm::vec3(0.7F)), glm::vec3(1)});
    scene.things.push_back({shapes::box(), standing({1.2F, -1, 0.3F}, glm::vec3(0.8F), 0.7F), glm::vec3(1)});
    return scene;
}

}
