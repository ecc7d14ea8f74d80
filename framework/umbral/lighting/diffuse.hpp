#pragma once

#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>

namespace umbral::lighting {

/// The unit vector from `point` towards the light: l = (q - p) / |q - p| for a place q, and the direction itself, made
/// unit, for a direction. Without a direction, because the light is at the point or its direction is null, (0, 0, 0).
/// Guarantee of the reference: each component within 1e-7, for all finite floats. Course: section C 1.7, l_i.
[[nodiscard]] glm::vec3 direction_to_light(const Light& light, const glm::vec3& point);

/// The light that a matt surface sends to every side:
///
///     M_E + A_G M_A + Σ Sᵢ (M_A + M_D max(0, n·lᵢ))
///
/// Colours are multiplied channel by channel, and nothing is clamped. n is the normal made unit; where the normal or lᵢ
/// is null there is no diffuse term of that light, but there is its ambient one. The material's specular part does not
/// count. Guarantee of the reference: each channel within 2e-7 of itself. Course: section C 1.7, equations 4 to 6 (as
/// in OpenGL, the global ambient light A_G is reflected by M_A).
[[nodiscard]] glm::vec3 matt_reflection(const SurfacePoint& at, const Material& material, std::span<const Light> lights,
                                        const glm::vec3& global_ambient);

}
