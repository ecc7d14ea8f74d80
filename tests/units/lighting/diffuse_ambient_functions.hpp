#pragma once

#include <umbral/lighting/diffuse.hpp>

/// What the tests of lighting/diffuse-ambient ask of a solution.
struct DiffuseAmbient {
    glm::vec3 (*direction_to_light)(const umbral::lighting::Light&, const glm::vec3&);
    glm::vec3 (*matt_reflection)(const umbral::lighting::SurfacePoint&, const umbral::lighting::Material&,
                                 std::span<const umbral::lighting::Light>, const glm::vec3&);
};
