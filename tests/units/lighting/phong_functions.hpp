#pragma once

#include <umbral/lighting/phong.hpp>

/// What the tests of lighting/phong ask of a solution.
struct Phong {
    glm::vec3 (*mirrored_direction)(const glm::vec3&, const glm::vec3&);
    float (*phong_highlight)(const glm::vec3&, const glm::vec3&, const glm::vec3&, float);
};
