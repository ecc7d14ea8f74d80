#pragma once

#include <cmath>
#include <kit/stage.hpp>
#include <list>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/normal_matrix.hpp>
#include <vector>

/// A pile of pebbles: one sphere, scaled, sheared, turned and mirrored; the student's normals say how the light falls.
namespace umbral::transforms {

/// One of them in the world, and its colour in linear light.
struct Pebble {
    shapes::Shape shape;
    glm::vec3 color;
};

inline Pebble pebble(Recorder& out, const glm::mat4& model, const glm::vec3& color)
{
    shapes::Shape shape = shapes::sphere(64, 40);
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        shape.normals[i] = ask<transformed_normal>(out, model, shape.positions[i]);
        shape.positions[i] = glm::vec3(model * glm::vec4(shape.positions[i], 1));
    }
    return {shape, color};
}

inline std::vector<Pebble> pebbles(Recorder& out)
{
    std::vector<Pebble> pile;
    // Sizes from the ground up; `lean` shears x by y, `tilt` turns about z, `spin` about y.
    const auto add = [&](glm::vec3 middle, glm::vec3 size, float lean, float tilt, float spin, glm::vec3 color) {
        glm::mat4 shear(1);
        shear[1][0] = lean;
        glm::mat4 model = glm::translate(glm::mat4(1), middle);
        model = glm::rotate(model, spin, {0, 1, 0});
        model = glm::rotate(model, tilt, {0, 0, 1});
        pile.push_back(pebble(out, glm::scale(model * shear, size), color));
    };
    add({0, 0.32F, 0}, {1.25F, 0.36F, 0.95F}, 0.3F, 0.02F, 0.3F, {0.10F, 0.13F, 0.17F});
    add({0.05F, 0.88F, 0}, {0.85F, 0.27F, 0.72F}, -0.5F, 0.05F, 1.2F, {0.42F, 0.16F, 0.09F});
    // A negative factor: a mirror.
    add({0, 1.29F, 0.02F}, {-0.62F, 0.21F, 0.50F}, 0.6F, -0.06F, 0.2F, {0.55F, 0.47F, 0.36F});
    add({0.05F, 1.59F, 0}, {0.40F, 0.15F, 0.34F}, 0.2F, 0.1F, 2.0F, {0.07F, 0.27F, 0.30F});
    add({0.02F, 1.83F, 0}, {0.24F, 0.15F, -0.2F}, -0.3F, -0.05F, 0.5F, {0.62F, 0.30F, 0.07F});
    add({1.55F, 0.17F, 0.55F}, {0.42F, 0.18F, 0.3F}, 0.4F, 0, 0.9F, {0.60F, 0.56F, 0.50F});
    add({-1.35F, 0.13F, 1.05F}, {0.2F, 0.14F, 0.5F}, 0.2F, 0, 0.7F, {0.25F, 0.06F, 0.08F});
    return pile;
}

/// 320 x 320 pixels.
inline Image draw_pebbles(Variation& vary, Recorder& out)
{
    const Stage stage(320, 320, {0.675F, 0.743F, 0.806F});
    stage.look(vary.near(glm::vec3(2.2F, 2.6F, 5.6F), 1.0F), {0.1F, 0.9F, 0.1F}, 36);
    const gl::Mesh box = uploaded(shapes::box());
    std::list<gl::Mesh> meshes;
    std::vector<Stage::Thing> things;
    for (const auto& [shape, color] : pebbles(out))
        things.push_back({meshes.emplace_back(shape.positions, shape.normals, shape.indices),
                          glm::mat4(1),
                          {.color = color, .gloss = 0.6F}});
    stage.draw_on({box, slab(40), {.color = {0.48F, 0.44F, 0.38F}, .fade = 0.008F}}, things);
    return stage.picture();
}

}
