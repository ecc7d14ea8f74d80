#pragma once

#include <umbral/lighting/brightest_point.hpp>

/// What the tests of lighting/brightest-point ask of a solution.
struct BrightestPoint {
    glm::vec3 (*brightest_diffuse)(const umbral::lighting::Sphere&, const umbral::lighting::Light&);
    bool (*is_seen)(const umbral::lighting::Sphere&, const glm::vec3&, const glm::vec3&);
    std::optional<glm::vec3> (*brightest_seen)(const umbral::lighting::Sphere&, const umbral::lighting::Light&,
                                               const glm::vec3&);
    std::optional<glm::vec3> (*brightest_specular)(const umbral::lighting::Sphere&, const umbral::lighting::Light&,
                                                   const glm::vec3&);
};
