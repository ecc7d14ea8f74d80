#pragma once

#include "model.hpp"
#include "operators.hpp"

namespace umbral::bench::scenes {

/// 1 % of how far a camera is from what it looks at, to its right; of the painters' cameras and of the engine's.
template <class AnyCamera>
[[nodiscard]] glm::vec3 aside(const AnyCamera& camera)
{
    return glm::normalize(glm::cross(camera.target - camera.eye, camera.up)) * glm::length(camera.eye - camera.target) *
           0.01F;
}

/// What both of them can have wrong alike.
template <class AnyCamera>
void spoil_view(AnyCamera& camera, Flaw flaw)
{
    if (flaw == Flaw::fov_3_percent_wrong) camera.fovy_degrees *= 1.03F;
    if (flaw == Flaw::camera_1_percent_off) {
        const glm::vec3 by = aside(camera);
        camera.eye += by;
        camera.target += by;
    }
}

/// Flaws that lie in the data of a picture or in OpenGL's state, not in a formula; the others leave the model as it is.
void spoil(Model& model, Flaw flaw);

}
