#pragma once

#include <umbral/pipeline/depth_precision.hpp>

/// What the test of pipeline/depth-precision asks of a solution.
struct DepthPrecision {
    double (*window_depth)(const umbral::pipeline::DepthRange&, double);
    double (*eye_depth)(const umbral::pipeline::DepthRange&, std::uint32_t, int);
    double (*depth_resolution)(const umbral::pipeline::DepthRange&, umbral::pipeline::DepthFormat, double);
    std::optional<double> (*fighting_distance)(const umbral::pipeline::DepthRange&, int, double);
};
