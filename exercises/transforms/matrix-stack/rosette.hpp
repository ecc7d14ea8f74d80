#pragma once

#include <kit/double_frame.hpp>
#include <numbers>

#include <umbral/record/ask.hpp>
#include "../gl_pipelines.hpp"

namespace umbral::transforms {

/// Three rings of complex figures, turned one inside the other, in the programmable pipeline with the unit's
/// stack for its matrices: 384 x 384 pixels.
inline Image draw_rosette(Recorder& out)
{
    std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
    const DoubleFrame frame(384, 384);
    if (!stack) return frame.picture();

    constexpr glm::vec3 colors[] = {ink::blue, ink::orange, ink::pink};
    constexpr int counts[] = {20, 14, 8};
    constexpr float sizes[] = {0.62F, 0.52F, 0.44F};
    constexpr float radii[] = {6.0F, 3.2F, 0.85F};
    ProgrammablePipeline pipeline(std::move(stack), glm::ortho(-9.3F, 9.3F, -9.3F, 9.3F), ink::night, 2);
    pipeline.set_view(glm::mat4(1));
    for (int ring = 0; ring < 3; ++ring) {
        pipeline.set_color(colors[ring]);
        pipeline.push();
        for (int i = 0; i < counts[ring]; ++i) {
            pipeline.push();
            pipeline.compose(glm::translate(glm::mat4(1), {radii[ring], -0.5F * sizes[ring], 0}));
            pipeline.compose(glm::scale(glm::mat4(1), glm::vec3(sizes[ring])));
            ask<draw_complex_figure>(out, pipeline, draw_simple_figure);
            pipeline.pop();
            pipeline.compose(
                glm::rotate(glm::mat4(1), 2 * std::numbers::pi_v<float> / static_cast<float>(counts[ring]), {0, 0, 1}));
        }
        pipeline.pop();
    }
    return frame.picture();
}

}
