#pragma once

#include <umbral/lighting/light_direction.hpp>

/// What the tests of lighting/light-direction ask of a solution.
struct LightDirection {
    using InFrame = glm::vec3(const umbral::lighting::LightAngles&, umbral::lighting::LightFrame, const glm::mat4&);
    glm::vec3 (*light_direction)(const umbral::lighting::LightAngles&);
    umbral::lighting::LightAngles (*light_angles)(const glm::vec3&);
    InFrame* direction_in_camera;
    InFrame* direction_in_world;
    std::unique_ptr<umbral::lighting::LightControl> (*make_light_control)(const umbral::lighting::LightAngles&, float);
};
