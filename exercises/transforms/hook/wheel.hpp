#pragma once

#include <cmath>
#include <kit/double_frame.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/transforms/hook.hpp>

#include "../gl_pipelines.hpp"

namespace umbral::transforms {

/// Round the wheel of colours once, from blue over violet and orange back.
inline glm::vec3 hook_hue(float turn)
{
    const glm::vec3 phase = 2 * std::numbers::pi_v<float> * (turn + glm::vec3(0.30F, 0.62F, 0.0F));
    return 0.62F + 0.36F * glm::cos(phase);
}

/// All that can be made of the hook: the pinwheel, circles of 5, 8 and 13, and a spiral whose hooks are placed with and
/// without angles in turn.
inline void paint_wheel(Recorder& out, Pipeline& pipeline)
{
    const auto scaled = [&](float size, auto draw) {
        pipeline.push();
        pipeline.compose(glm::scale(glm::mat4(1), {size, size, 1}));
        draw();
        pipeline.pop();
    };
    pipeline.set_line_width(3);
    scaled(0.24F, [&] {
        pipeline.compose(glm::translate(glm::mat4(1), {1, -1, 0}));
        pipeline.set_color(ink::white);
        ask<draw_four_hooks>(out, pipeline, draw_hook);
    });
    constexpr unsigned counts[] = {5, 8, 13};
    constexpr float sizes[] = {1.15F, 2.15F, 3.2F};
    for (int ring = 0; ring < 3; ++ring)
        scaled(sizes[ring], [&] {
            pipeline.set_color(hook_hue(0.15F + 0.28F * static_cast<float>(ring)));
            ask<draw_hook_circle>(out, pipeline, draw_hook, counts[ring]);
        });
    constexpr int steps = 34;
    const auto place = [](int i) {
        const float turn = 4 * std::numbers::pi_v<float> * static_cast<float>(i) / steps;
        const float radius = 4.25F * std::exp(0.033F * turn);
        return glm::vec3(radius * std::cos(turn), radius * std::sin(turn), 1);
    };
    for (int i = 0; i < steps; ++i) {
        pipeline.set_color(hook_hue(static_cast<float>(i) / steps));
        if (i % 2 == 0) {
            ask<draw_hook_between>(out, pipeline, draw_hook, place(i), place(i + 1));
        } else {
            pipeline.push();
            pipeline.compose(ask<hook_matrix>(out, place(i), place(i + 1)));
            ask<draw_hook>(out, pipeline);
            pipeline.pop();
        }
    }
}

inline constexpr float wheel_reach = 7.6F;

/// 384 x 384 pixels, by the programmable pipeline.
inline Image draw_wheel(Recorder& out)
{
    const DoubleFrame frame(384, 384);
    ProgrammablePipeline pipeline(make_matrix_stack(), glm::ortho(-wheel_reach, wheel_reach, -wheel_reach, wheel_reach),
                                  ink::night, 2);
    pipeline.set_view(glm::mat4(1));
    paint_wheel(out, pipeline);
    return frame.picture();
}

}
