#pragma once

#include <kit/double_frame.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../gl_pipelines.hpp"
#include "parts.hpp"

/// One facade and one android, each drawn several times, with its parameters changed in between.
namespace umbral::transforms {

inline constexpr glm::vec3 motion_background(0.09F, 0.11F, 0.19F);

/// A filled polygon with edges; convex.
inline std::shared_ptr<const Drawable> panel(std::vector<glm::vec2> corners, const glm::vec3& fill)
{
    return painted([corners = std::move(corners), fill](Pipeline& pipeline) {
        std::vector<glm::vec2> fan;
        for (std::size_t k = 2; k < corners.size(); ++k)
            fan.insert(fan.end(), {corners[0], corners[k - 1], corners[k]});
        std::vector<glm::vec2> closed = corners;
        closed.push_back(corners[0]);
        pipeline.set_color(fill);
        pipeline.fill_triangles(fan);
        pipeline.set_color(pipeline.background());
        pipeline.draw_polyline(closed);
    });
}

inline FacadeParts painted_facade()
{
    const std::vector<glm::vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return {panel({{0, 0}, {1, 0}, {1, 1}, {0.5F, 1.5F}, {0, 1}}, {0.75F, 0.42F, 0.30F}),
            panel(square, {0.24F, 0.42F, 0.58F}), panel(square, {0.97F, 0.83F, 0.47F})};
}

inline void paint_facades(Variation& vary, Recorder& out, Pipeline& pipeline)
{
    const FacadeGraph facade = ask<make_facade>(out, painted_facade(), 1.5F, 0.0F);
    if (!facade.root || facade.rotation == nullptr || facade.stretch == nullptr) return;
    for (int i = 0; i < 7; ++i) {
        const auto step = static_cast<float>(i);
        ask<set_facade_height>(out, facade, vary.near(1.15F, 0.2F) + 0.35F * static_cast<float>(i * 3 % 7) / 3);
        ask<set_facade_angle>(out, facade, vary.near(0.09F * (3 - step), 0.15F));
        pipeline.set_view(glm::translate(glm::mat4(1), {0.25F + 1.35F * step, 2.75F, 0}));
        ask<&GraphNode::draw>(out, *facade.root, pipeline);
    }
}

inline void paint_androids(Variation& vary, Recorder& out, Pipeline& pipeline)
{
    const AndroidGraph android = ask<make_android_graph>(out, android_parts());
    if (!android.root || android.left_arm == nullptr || android.right_arm == nullptr || android.head == nullptr ||
        android.limb == nullptr)
        return;
    const auto turned = [](float angle, const glm::vec3& axis) { return glm::rotate(glm::mat4(1), angle, axis); };
    constexpr int androids = 6;
    for (int i = 0; i < androids; ++i) {
        const auto step = static_cast<float>(i);
        const float phase = 2 * std::numbers::pi_v<float> * step / androids + vary.near(0.0F, 0.8F);
        *android.left_arm = turned(-1.4F + 1.4F * std::cos(phase), {1, 0, 0});
        *android.right_arm = turned(-1.4F - 1.4F * std::cos(phase), {1, 0, 0});
        *android.head = turned(0.7F * std::sin(phase), {0, 1, 0});
        *android.limb = glm::scale(glm::mat4(1), {1, 0.7F + 0.12F * step, 1});
        const glm::mat4 place = glm::translate(glm::mat4(1), {0.95F + 1.6F * step, 0.95F, 0});
        const glm::mat4 seen = turned(0.2F, {1, 0, 0}) * turned(0.45F - 0.18F * step, {0, 1, 0});
        pipeline.set_view(glm::scale(place, glm::vec3(0.42F)) * seen);
        pipeline.set_color(glm::mix(glm::vec3(0.20F, 0.72F, 0.52F), glm::vec3(0.86F, 0.50F, 0.72F), step / 5));
        ask<&GraphNode::draw>(out, *android.root, pipeline);
    }
}

/// 560 x 290 pixels, by the programmable pipeline.
inline Image draw_motion(Variation& vary, Recorder& out)
{
    const DoubleFrame frame(560, 290, motion_background);
    ProgrammablePipeline pipeline(make_matrix_stack(), glm::ortho(0.0F, 9.9F, -0.1F, 5.027F, -5.0F, 5.0F),
                                  motion_background, 2);
    paint_facades(vary, out, pipeline);
    glEnable(GL_DEPTH_TEST);
    paint_androids(vary, out, pipeline);
    return frame.picture();
}

}
