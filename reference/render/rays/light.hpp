#pragma once

#include "render/rays/samples.hpp"
#include "render/rays/world.hpp"

namespace umbral::render::rays {

/// The light that comes back along a ray, linear; `background` where it meets nothing is up to the caller.
struct Arrived {
    glm::vec3 light{0};
    const Draw* draw = nullptr;  ///< what is seen; null: nothing
    glm::vec3 position{0};       ///< of it, in eye space
};

/// Follows a ray: local illumination with shadows, mirrors and glass down to DrawList::depth, and light from other
/// surfaces over DrawList::bounces. With bounces, ambient light is not added: it stands for what they compute.
///
/// What glass transmits and mirrors is shared out by Fresnel's equations for unpolarised light. Course: section D 1G
/// (Whitted 1980), "rayos secundarios"; J. Kajiya. The Rendering Equation. 1986.
[[nodiscard]] Arrived follow(const World& world, const Ray& ray, Samples& samples, Counters& counters);

}
