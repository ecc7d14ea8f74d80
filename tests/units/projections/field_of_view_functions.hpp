#pragma once

#include <umbral/projections/perspective.hpp>

/// What the test of projections/field-of-view asks of a solution.
struct FieldOfView {
    glm::mat4 (*matrix)(const umbral::projections::Lens&);
    glm::mat4 (*reversed)(const umbral::projections::Lens&);
    float (*fovy)(float, float);
};
