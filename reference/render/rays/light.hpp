#pragma once

#include "render/rays/counts.hpp"
#include "render/rays/samples.hpp"
#include "render/rays/world.hpp"

namespace umbral::render::rays {

/// The light that comes back along a ray, linear; where it meets nothing, none.
struct Arrived {
    glm::vec3 light{0};
    const Draw* draw = nullptr;  ///< what is seen; null: nothing
    glm::vec3 position{0};       ///< of it, in eye space
};

/// What is followed beyond the first surface.
struct Reach {
    int depth = 0;         ///< mirrors and panes of glass that light may meet
    int bounces = 0;       ///< between other surfaces
    bool shadows = false;  ///< or every light reaches every surface that faces it
    bool bumps = false;    ///< normals are bent by bump maps
};

/// Follows a ray: local illumination with shadows, mirrors and glass, and light from other surfaces. With bounces,
/// ambient light is not added: it stands for what they compute.
///
/// What glass transmits and mirrors is shared out by Fresnel's equations for unpolarised light. Course: section D 1G
/// (Whitted 1980), "rayos secundarios"; J. Kajiya. The Rendering Equation. 1986.
[[nodiscard]] Arrived follow(const World& world, const Reach& reach, const Ray& ray, Samples& samples,
                             RayCounts& counts);

}
