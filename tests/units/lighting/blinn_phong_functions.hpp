#pragma once

#include <umbral/lighting/blinn_phong.hpp>

/// What the tests of lighting/blinn-phong ask of a solution.
struct BlinnPhong {
    std::optional<glm::vec3> (*half_vector)(const glm::vec3&, const glm::vec3&);
    float (*blinn_highlight)(const glm::vec3&, const glm::vec3&, const glm::vec3&, float);
};
