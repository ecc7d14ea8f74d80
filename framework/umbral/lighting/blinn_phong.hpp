#pragma once

#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>

namespace umbral::lighting {

/// The unit vector h halfway between two directions of any length: (l + v) / |l + v|, where l and v are made unit
/// first. There is none if one of them is null, or if they point in exactly opposite directions. Guarantee of the
/// reference: each component within 1e-7, for all finite floats, however nearly opposite they are. Course: section
/// C 1.7, "bisector de l y v".
[[nodiscard]] std::optional<glm::vec3> half_vector(const glm::vec3& l, const glm::vec3& v);

/// Blinn's highlight, d max(0, n·h)^e, in [0, 1]: how much of the light from `l` a surface sends towards the viewer,
/// who stands in direction `v`.
///
/// d is 1 if n·l > 0 and 0 otherwise. Normal, l and v have any length and are made unit; if one of them is null, or
/// there is no half vector, the highlight is 0. e is at least 0, and x^0 = 1 for every x, also for 0. Guarantee of the
/// reference: within 1e-7 of it, for e up to 10⁴. Course: section C 1.7, "modelo de Blinn-Phong".
[[nodiscard]] float blinn_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e);

/// The light that a surface sends to the eye, a place:
///
///     M_E + A_G M_A + Σ Sᵢ (M_A + M_D max(0, n·lᵢ) + M_S highlightᵢ)
///
/// All but the highlight is matt_reflection (diffuse.hpp). Nothing is clamped. This is what lighting/shaders computes
/// at each pixel.
[[nodiscard]] glm::vec3 blinn_phong_reflection(const SurfacePoint& at, const Material& material,
                                               std::span<const Light> lights, const glm::vec3& global_ambient,
                                               const glm::vec3& eye);

}
