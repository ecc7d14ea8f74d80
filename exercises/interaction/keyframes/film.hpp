#pragma once

#include <kit/stage.hpp>
#include <umbral/record/ask.hpp>
#include <vector>

#include "motions.hpp"

/// The goal picture of the keyframes unit: many moments in one exposure.
namespace umbral::interaction {

/// A bar of a two-bone skeleton that stands at the shoulder, its skin bent where the elbow is. Its weights go from 0 to
/// 1 about the elbow.
inline shapes::Shape skinned_bar(Recorder& out, const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const float whole = skeleton.upper_length + skeleton.lower_length;
    return shapes::surface(28, 36, [&](float u, float v) {
        const float along = whole * glm::clamp(v, 0.0F, 1.0F);
        const float end = 2 * glm::clamp(v, 0.0F, 1.0F) - 1;
        const float radius = (0.12F - 0.03F * end) * std::sqrt(std::max(1 - std::pow(end, 24.0F), 1e-4F));
        const float angle = shapes::turn * u;
        const glm::vec3 rest = skeleton.shoulder + glm::vec3(along, radius * std::cos(angle), radius * std::sin(angle));
        const float weight = glm::smoothstep(-0.4F, 0.4F, along - skeleton.upper_length);
        return ask<skinned_point>(out, skeleton, pose, rest, weight);
    });
}

inline glm::mat4 placed(const glm::vec3& position, const UnitQuaternion& orientation, const glm::vec3& size)
{
    glm::mat4 model(matrix_of(orientation));
    model[3] = glm::vec4(position, 1);
    return glm::scale(model, size);
}

/// A box that tumbles from key frame to key frame, a ball that bounces while it rolls forwards, bent bars.
inline Image film(Variation& vary, Recorder& out)
{
    const Stage stage(480, 320, {0.075F, 0.085F, 0.13F});
    stage.look(vary.near(glm::vec3(0.2F, 3.1F, 9.4F), 1.2F), {0, 1.32F, 0}, 34, 1.5F);
    const gl::Mesh box = uploaded(shapes::box());
    const gl::Mesh ball = uploaded(shapes::sphere(48, 24));
    const Finish floor{
        .color = {0.17F, 0.20F, 0.27F}, .gloss = 0, .odd = glm::vec3(0.13F, 0.155F, 0.22F), .fade = 0.012F};
    std::vector<Stage::Thing> things;

    const std::vector<KeyFrame> frames{{0, {-4.0F, 1.0F, -1.6F}, about({0, 1, 0}, 0.3)},
                                       {1, {-1.4F, 2.9F, -1.8F}, about({0.4, 0.3, -1}, 1.5)},
                                       {2, {1.5F, 2.9F, -1.8F}, about({1, 0.2, -0.6}, 3.0)},
                                       {3, {4.1F, 0.9F, -1.6F}, about({0.2, 1, -0.3}, 4.6)}};
    for (int i = 0; i <= 12; ++i) {
        const float seconds = 0.25F * static_cast<float>(i);
        const KeyPose pose = ask<key_pose>(out, frames, seconds);
        const bool is_key = i % 4 == 0;
        const glm::vec3 size = glm::vec3(0.9F, 0.55F, 0.32F) * (is_key ? 1.0F : 0.8F);
        const glm::mat4 model =
            placed(pose.position, pose.orientation, size) * glm::translate(glm::mat4(1), glm::vec3(-0.5F));
        const glm::vec3 color = is_key ? glm::vec3(0.88F, 0.50F, 0.05F) : glm::vec3(0.16F, 0.36F, 0.52F);
        things.push_back({box, model, {.color = color, .gloss = 0.3F}});
    }

    const BallLaunch launch{{-3.1, 1.4, 1.9}, {1.57, 1.3, 0}, 0.86};
    const auto bouncing = ask_new<make_bouncing_ball>(out, "ball", launch);
    for (int i = 0; bouncing && i < 36; ++i) {
        const glm::vec3 place(ask<&BouncingBall::position>(out, *bouncing));
        const float hue = 0.93F - 0.3F * static_cast<float>(i) / 36;
        const glm::vec3 color(srgb_decoded(glm::dvec3(rainbow(hue, 0.75F, 0.95F))));
        things.push_back(
            {ball, placed(place + glm::vec3(0, 0.17F, 0), {}, glm::vec3(0.17F)), {.color = color, .gloss = 0.5F}});
        ask<&BouncingBall::advance>(out, *bouncing, 110'000);
    }

    const auto bent_bar = [&](int i) {
        const TwoBoneSkeleton skeleton{{-2.6F + 1.3F * static_cast<float>(i), 0, 0.1F}, 0.85F, 0.85F};
        const float u = 0.25F * static_cast<float>(i);
        const SkeletonPose pose{ask<slerp_shorter>(out, about({0, 0, 1}, 1.9), about({0, 0, 1}, 1.2), u),
                                ask<slerp_shorter>(out, about({0, 0, 1}, 0.9), about({0, 0.3, -1}, 1.3), u)};
        return uploaded(skinned_bar(out, skeleton, pose));
    };
    const gl::Mesh bars[] = {bent_bar(0), bent_bar(1), bent_bar(2), bent_bar(3), bent_bar(4)};
    for (const gl::Mesh& bar : bars)
        things.push_back({bar, glm::mat4(1), {.color = {0.05F, 0.33F, 0.30F}, .gloss = 0.45F}});
    stage.draw_on({box, slab(30), floor}, things);
    return stage.picture();
}

}
