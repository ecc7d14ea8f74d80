#pragma once

#include <umbral/lighting/color.hpp>

/// What the tests of lighting/color ask of a solution.
struct ColorFunctions {
    glm::vec3 (*add_lights)(std::span<const umbral::lighting::Lamp>);
    float (*encode_srgb)(float);
    float (*decode_srgb)(float);
    glm::u8vec3 (*to_pixel)(const glm::vec3&);
    glm::vec3 (*to_light)(const glm::u8vec3&);
    glm::u8vec3 (*mean_pixel)(std::span<const glm::u8vec3>);
};
