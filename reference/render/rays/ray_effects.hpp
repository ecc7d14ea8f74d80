#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace umbral::render::rays {

/// Something that only rays draw, and whether a scene calls for it.
struct RayEffect {
    const char* name;  ///< "mirrors"
    bool called_for = false;
    std::string why;  ///< "material "glass" lets light through", or why not: "no material reflects"
};

/// All of them, always in the same order: shadows, soft shadows, mirrors, glass, bump maps, the lens, the shutter,
/// light between surfaces. What is not called for costs nothing: no ray is followed for it.
[[nodiscard]] std::vector<RayEffect> ray_effects(const scene::Scene& scene);

}
