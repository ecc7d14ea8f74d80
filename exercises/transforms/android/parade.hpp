#pragma once

#include <kit/double_frame.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/android.hpp>

#include "../gl_pipelines.hpp"

namespace umbral::transforms {

inline constexpr glm::vec3 parade_background(0.80F, 0.86F, 0.91F);

inline glm::mat4 parade_view()
{
    return glm::lookAt(glm::vec3(1.0F, 3.8F, 18.0F), glm::vec3(0, 0.5F, 0), glm::vec3(0, 1, 0));
}
inline glm::mat4 parade_projection() { return glm::perspective(glm::radians(26.0F), 1.75F, 1.0F, 60.0F); }

/// Five poses, each of them set on the same android, on round stands.
inline void paint_parade(Variation& vary, Recorder& out, Pipeline& pipeline, Android& android)
{
    struct Pose {
        glm::vec3 place;
        float turn;
        glm::vec3 color;
        double left, right, head;
    };
    const Pose poses[] = {{{-5.5F, 0, -1.7F}, 0.45F, {0.15F, 0.62F, 0.55F}, 0.6, -0.6, 0.5},
                          {{5.5F, 0, -1.7F}, -0.55F, {0.83F, 0.44F, 0.62F}, -1.57, -1.57, -0.2},
                          {{-2.9F, 0, -0.1F}, 0.25F, {0.25F, 0.58F, 0.85F}, -2.75, 0.3, -0.6},
                          {{2.9F, 0, -0.1F}, -0.3F, {0.92F, 0.60F, 0.15F}, 0.35, -2.2, 0.7},
                          {{0, 0, 1.2F}, 0, {0.55F, 0.74F, 0.18F}, 0, 0, 0}};
    pipeline.set_view(parade_view());
    for (const Pose& pose : poses) {
        ask<&Android::set_left_arm>(out, android, vary.near(pose.left, 0.5));
        ask<&Android::set_right_arm>(out, android, vary.near(pose.right, 0.5));
        ask<&Android::set_head>(out, android, vary.near(pose.head, 0.5));
        pipeline.push();
        pipeline.compose(glm::translate(glm::mat4(1), pose.place + vary.near(glm::vec3(0), 0.3F)));
        pipeline.push();
        pipeline.set_color({0.62F, 0.66F, 0.72F});
        pipeline.compose(glm::translate(glm::mat4(1), {0, -1.65F, 0}));
        pipeline.compose(glm::scale(glm::mat4(1), {1.7F, 0.24F, 1.7F}));
        pipeline.draw(Primitive::cylinder);
        pipeline.pop();
        pipeline.set_color(pose.color);
        pipeline.compose(glm::rotate(glm::mat4(1), pose.turn, {0, 1, 0}));
        ask<&Android::draw>(out, android, pipeline);
        pipeline.pop();
    }
}

/// 560 x 320 pixels, by the programmable pipeline.
inline Image draw_parade(Variation& vary, Recorder& out)
{
    const DoubleFrame frame(560, 320, parade_background);
    glEnable(GL_DEPTH_TEST);
    const std::unique_ptr<Android> android = ask_new<make_android>(out, "android");
    ProgrammablePipeline pipeline(make_matrix_stack(), parade_projection(), parade_background, 2);
    if (android) paint_parade(vary, out, pipeline, *android);
    return frame.picture();
}

}
