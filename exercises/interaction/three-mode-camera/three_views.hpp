#pragma once

#include "../temple.hpp"
#include "steps.hpp"

/// The picture of the unit.
namespace umbral::interaction {

/// The temple from outside; from between its columns; and the same observer's head turned.
inline void draw_modes(Variation& vary, Recorder& out)
{
    const Stage stage(480, 320, {0.05F, 0.05F, 0.07F});
    const Temple temple;
    const ThreeModeSettings settings = before_the_temple(vary);
    const std::unique_ptr<ThreeModeCamera> camera = ask_new<make_three_mode_camera>(out, "camera", settings);
    if (!camera) return;
    const auto draw = [&](const std::vector<ThreeModeStep>& steps, const Panel& panel, float fovy) {
        for (const ThreeModeStep& step : steps) apply(out, *camera, step);
        draw_temple(stage, temple, panel, ask<&ThreeModeCamera::view>(out, *camera), fovy);
    };
    draw({move_xy(-0.1, 0.06), move_z(0.25)}, {{4, 4}, {304, 312}}, 46);
    draw({move_xy(0, -0.26), next_mode(), move_xy(0, 0.15), move_z(-4.7)}, {{312, 162}, {164, 154}}, 62);
    draw({next_mode(), move_z(-2), move_xy(-1.1, -0.42)}, {{312, 4}, {164, 154}}, 68);
    out.image("colours", stage.picture());
}

}
