#pragma once

#include <umbral/projections/view_frame.hpp>

/// What the test of projections/view-frame asks of a solution.
struct ViewFrames {
    std::optional<umbral::projections::ViewFrame> (*frame)(const umbral::projections::ViewParameters&);
    umbral::projections::ViewParameters (*view)(const glm::vec3&, float, float, float, float);
};
