#pragma once

#include <cmath>
#include <kit/stage.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/basic_matrices.hpp>
#include <vector>

/// A spiral staircase: every step, post and bead of it is one box under the student's matrices.
namespace umbral::transforms {

inline constexpr glm::vec3 box_middle{0.5F, 0.5F, 0.5F};

/// A box under one matrix, in linear colour.
struct Block {
    glm::mat4 model;
    glm::vec3 color;
};

inline Block block(Recorder& out, std::initializer_list<glm::mat4> steps, const glm::vec3& color)
{
    return {ask<compose_matrices>(out, std::span(steps.begin(), steps.size())), color};
}

inline std::vector<Block> tower(Recorder& out)
{
    constexpr int steps = 40;
    constexpr float rise = 0.105F;
    constexpr float turn = 0.36F;
    std::vector<Block> blocks;
    const glm::mat4 centred = ask<translation_matrix>(out, -box_middle);
    blocks.push_back(
        block(out,
              {centred, ask<scaling_matrix>(out, {0.34F, rise * steps, 0.34F}),
               ask<translation_matrix>(out, {0, 0.5F * rise * steps, 0}), ask<rotation_about_y>(out, 0.3F)},
              {0.75F, 0.70F, 0.60F}));
    for (int i = 0; i < steps; ++i) {
        const float share = static_cast<float>(i) / steps;
        const glm::vec3 color = glm::mix(glm::vec3(0.03F, 0.23F, 0.42F), glm::vec3(0.85F, 0.30F, 0.04F), share);
        const glm::mat4 place = ask<compose_matrices>(
            out, std::vector<glm::mat4>{ask<translation_matrix>(out, {0, rise * static_cast<float>(i), 0}),
                                        ask<rotation_about_y>(out, turn * static_cast<float>(i))});
        // A tread: its outer end lags behind, which is a shear of z by x.
        blocks.push_back(
            block(out,
                  {centred, ask<scaling_matrix>(out, {1.25F, 0.07F, 0.34F}),
                   ask<translation_matrix>(out, {0.72F, 0.04F, 0}), ask<shear_matrix>(out, 2, 0, -0.18F), place},
                  color));
        // A post that leans outwards: a shear of x by y.
        blocks.push_back(
            block(out,
                  {centred, ask<scaling_matrix>(out, {0.035F, 0.55F, 0.035F}),
                   ask<translation_matrix>(out, {1.2F, 0.3F, -0.2F}), ask<shear_matrix>(out, 0, 1, 0.22F), place},
                  {0.30F, 0.32F, 0.36F}));
        // Beads of the handrail: a point carried along, and four more on the free vector to the next one.
        const glm::vec3 top = ask<transform_point>(out, place, {1.33F, 0.6F, -0.2F});
        const glm::vec3 next =
            ask<transform_vector>(out, ask<rotation_about_y>(out, turn), top) + glm::vec3(0, rise, 0);
        for (int bead = 0; bead < 5; ++bead) {
            const glm::vec3 middle = top + 0.2F * static_cast<float>(bead) * (next - top);
            blocks.push_back(
                block(out, {centred, ask<scaling_matrix>(out, glm::vec3(0.055F)), ask<translation_matrix>(out, middle)},
                      {0.88F, 0.62F, 0.12F}));
        }
    }
    // A cube that stands on a corner: about z, then about x.
    blocks.push_back(block(out,
                           {centred, ask<scaling_matrix>(out, glm::vec3(0.55F)), ask<rotation_about_z>(out, 0.7853982F),
                            ask<rotation_about_x>(out, 0.6154797F), ask<rotation_about_y>(out, 0.4F),
                            ask<translation_matrix>(out, {0, rise * steps + 0.62F, 0})},
                           {0.80F, 0.08F, 0.10F}));
    return blocks;
}

/// 320 x 320 pixels.
inline Image draw_tower(Variation& vary, Recorder& out)
{
    const Stage stage(320, 320, {0.61F, 0.735F, 0.85F});
    stage.look(vary.near(glm::vec3(3.4F, 4.7F, 8.3F), 1.2F), {0, 2.5F, 0}, 40);
    const gl::Mesh box = uploaded(shapes::box());
    std::vector<Stage::Thing> things;
    for (const auto& [model, color] : tower(out)) things.push_back({box, model, {.color = color}});
    stage.draw_on({box, slab(60), {.color = {0.36F, 0.36F, 0.34F}, .fade = 0.0035F}}, things);
    return stage.picture();
}

}
