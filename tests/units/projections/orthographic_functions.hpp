#pragma once

#include <umbral/projections/orthographic.hpp>

/// What the test of projections/orthographic asks of a solution.
struct Orthographic {
    glm::mat4 (*matrix)(const umbral::projections::ViewVolume&);
    glm::mat4 (*inverse)(const umbral::projections::ViewVolume&);
};
