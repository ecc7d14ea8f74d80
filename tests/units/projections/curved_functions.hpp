#pragma once

#include <umbral/projections/curved.hpp>

/// What the test of projections/curved asks of a solution.
struct CurvedFunctions {
    std::optional<umbral::projections::CurvedPoint> (*sphere)(const glm::vec3&);
    std::optional<umbral::projections::CurvedPoint> (*cylinder)(const glm::vec3&);
    float (*angle)(const glm::vec3&, const glm::vec3&);
    std::vector<glm::vec3> (*tessellated)(std::span<const glm::vec3>, float);
    std::array<float, 3> (*without_seam)(const std::array<float, 3>&);
};
