#pragma once

#include <umbral/projections/stereo.hpp>

/// What the test of projections/stereo asks of a solution.
struct StereoFunctions {
    umbral::projections::StereoPair (*off_axis)(const umbral::projections::StereoScreen&);
    umbral::projections::StereoPair (*toe_in)(const umbral::projections::StereoScreen&);
    float (*parallax)(const umbral::projections::StereoScreen&, float);
    std::optional<float> (*distance)(const umbral::projections::StereoScreen&, float);
    std::optional<glm::vec2> (*disparity)(const umbral::projections::StereoPair&, const glm::vec3&);
    umbral::Image (*anaglyph)(const umbral::Image&, const umbral::Image&, umbral::projections::AnaglyphColors);
};
