#pragma once

#include <umbral/projections/viewport.hpp>

/// What the test of projections/viewport asks of a solution.
struct ViewportFunctions {
    glm::mat4 (*matrix)(const umbral::projections::Viewport&);
    glm::vec3 (*back)(const umbral::projections::Viewport&, const glm::vec3&);
    std::optional<glm::ivec2> (*pixel)(const umbral::projections::Viewport&, const glm::vec2&);
    glm::vec2 (*centre)(const umbral::projections::Viewport&, const glm::ivec2&);
};
