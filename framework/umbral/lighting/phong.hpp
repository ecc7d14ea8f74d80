#pragma once

#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>

namespace umbral::lighting {

/// The direction in which a mirror with this normal sends the light that comes from `l`: r = 2 (n·l) n - l, where n is
/// the normal made unit. It has the length of `l`. (0, 0, 0) if the normal is null. Guarantee of the reference: within
/// 2e-7 |l| of it. Course: section C 1.7, equation 7.
[[nodiscard]] glm::vec3 mirrored_direction(const glm::vec3& l, const glm::vec3& normal);

/// Phong's highlight, d max(0, r·v)^e, in [0, 1]: how much of the light from `l` a surface sends towards the viewer,
/// who stands in direction `v`.
///
/// d is 1 if n·l > 0 and 0 otherwise; r mirrors l. Normal, l and v have any length and are made unit; if one of them is
/// null the highlight is 0. e is at least 0, and x^0 = 1 for every x, also for 0. Guarantee of the reference: within
/// 1e-7 of it, for e up to 10⁴. Course: section C 1.7, equation 7.
[[nodiscard]] float phong_highlight(const glm::vec3& normal, const glm::vec3& l, const glm::vec3& v, float e);

/// The light that a surface sends to the eye, a place:
///
///     M_E + A_G M_A + Σ Sᵢ (M_A + M_D max(0, n·lᵢ) + M_S highlightᵢ)
///
/// All but the highlight is matt_reflection (diffuse.hpp). Nothing is clamped. Course: section C 1.7, "modelo
/// completo".
[[nodiscard]] glm::vec3 phong_reflection(const SurfacePoint& at, const Material& material,
                                         std::span<const Light> lights, const glm::vec3& global_ambient,
                                         const glm::vec3& eye);

}
