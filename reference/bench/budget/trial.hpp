#pragma once

#include <functional>

#include "render/budget/draw.hpp"

namespace umbral::bench {

/// How a scene is tried.
struct Plan {
    int width = 0;
    int height = 0;
    int converged_rays = 0;  ///< through each pixel, of the picture that all others are compared with
    double error = 0;        ///< asked, of full scale
    double seconds = 0;      ///< asked, of processor time; 0: times are not looked at
};

/// What came of it. Costs are counted in rays of all kinds, which are the same on every machine.
struct Trial {
    render::budget::Result by_error;
    double true_error = 0;  ///< of that picture, against the converged one
    render::budget::Setting best;
    double best_error = 0;
    double cost_ratio = 0;           ///< of the chosen setting over the best
    render::budget::Result by_time;  ///< empty if times are not looked at
    double true_error_by_time = 0;   ///< of its picture
};

/// Asks for an error and for a time, and looks for the cheapest setting by drawing all of them: of those whose true
/// error is at most what was asked, the one that follows the fewest rays. On one thread; processor time.
[[nodiscard]] Trial try_scene(const scene::Scene& scene, const Plan& plan);

}
