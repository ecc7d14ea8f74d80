#pragma once

#include <umbral/projections/oblique.hpp>

/// What the test of projections/oblique asks of a solution.
struct ObliqueFunctions {
    float (*foreshortening)(float);
    glm::mat4 (*shear)(const umbral::projections::Lean&);
    glm::mat4 (*matrix)(const umbral::projections::ViewVolume&, const umbral::projections::Lean&);
    glm::vec3 (*direction)(const umbral::projections::Lean&);
};
