#pragma once

#include <kit/double_frame.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/tree.hpp>

#include "../gl_pipelines.hpp"

namespace umbral::transforms {

inline constexpr glm::vec3 grove_background(0.93F, 0.95F, 0.97F);

/// A tree of six levels, as the course's, between smaller ones, some of them mirrored.
inline void paint_grove(Variation& vary, Recorder& out, Pipeline& pipeline)
{
    struct Place {
        float x;
        float width;  ///< < 0: mirrored
        float height;
        unsigned levels;
    };
    constexpr Place places[] = {{-2.2F, 0.42F, 0.42F, 4},
                                {8.5F, -0.55F, 0.55F, 5},
                                {5.0F, 0.24F, 0.24F, 3},
                                {-0.9F, -0.3F, 0.3F, 2},
                                {1, 1, 1, 6}};
    for (const Place& place : places) {
        pipeline.push();
        pipeline.compose(glm::translate(glm::mat4(1), {vary.near(place.x, 0.4F), 0, 0}));
        pipeline.compose(
            glm::scale(glm::mat4(1), {vary.scaled(place.width, 1.2F), vary.scaled(place.height, 1.2F), 1}));
        ask<draw_tree>(out, pipeline, place.levels, draw_trunk);
        pipeline.pop();
    }
    pipeline.set_color(trunk_edges);
    pipeline.draw_polyline(std::array<glm::vec2, 2>{{{-10, 0}, {20, 0}}});
}

/// 80 pixels a unit, and by parts of a pixel beside whole ones: corners of trunks, at 2^-k, must not lie on the middle
/// between two pixels, where rounding would choose one.
inline glm::mat4 grove_window() { return glm::ortho(-2.9137F, 9.0863F, -0.6071F, 6.3929F); }

/// 480 x 280 pixels, by the programmable pipeline.
inline Image draw_grove(Variation& vary, Recorder& out)
{
    const DoubleFrame frame(480, 280, grove_background);
    ProgrammablePipeline pipeline(make_matrix_stack(), grove_window(), grove_background, 2);
    pipeline.set_view(glm::mat4(1));
    pipeline.set_line_width(1.5F);
    paint_grove(vary, out, pipeline);
    return frame.picture();
}

}
