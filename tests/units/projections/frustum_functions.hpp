#pragma once

#include <umbral/projections/frustum.hpp>

/// What the test of projections/frustum asks of a solution.
struct Frustum {
    glm::mat4 (*matrix)(const umbral::projections::ViewVolume&);
    umbral::projections::FrustumFactors (*factors)(const umbral::projections::ViewVolume&);
    std::optional<glm::vec3> (*point)(const glm::mat4&, const glm::vec3&);
};
