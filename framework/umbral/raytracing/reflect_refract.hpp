#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>

/// Where light goes at a surface: v leads **away** from it, back to where the ray came from, and n is its normal. Both
/// have any length but 0 (from 1e-6 to 1e6), and what is returned has length one.
namespace umbral::raytracing {

/// The direction in which a mirror is seen along v: in the plane of n and v, with n half-way between. The same for n as
/// for -n. Guarantee of the reference: every coordinate within 1e-7. Course: section D 1G, "rayos secundarios".
[[nodiscard]] glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n);

/// The direction in which light of which v shows where it came from goes on behind the surface, by Snell's law; none if
/// all of it is reflected (**total internal reflection**).
///
/// n leads to the side whose index of refraction is `outside`; on the other side it is `inside`. Both are more than 0.
/// The ray arrives from outside if v·n >= 0, and from inside otherwise: then it goes on outside.
/// Guarantee of the reference: every coordinate within 1e-7, and total reflection is told right wherever sin² of the
/// refracted angle, which Snell's law gives, differs from 1 by 1e-14 or more. Course: section D 1F, "ley de Snell".
[[nodiscard]] std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside,
                                                           float inside);

/// The angle with the normal, in radians, from which on light in a medium of index `from` does not come out into one of
/// index `into`; none if it always does, which is so unless `into` is less than `from`. Both are more than 0.
/// Guarantee of the reference: within 1 ulp. Course: section D 1F,
/// "reflexión interna total".
[[nodiscard]] std::optional<float> critical_angle(float from, float into);

}
