#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>

/// Two surfaces round the y axis, both of radius 1 at their base y = 0, and of height 1. Neither has its flat parts:
/// the lids of the cylinder and the base of the cone are not there, and rays pass.
/// - The **unit cylinder**: x² + z² = 1 and 0 <= y <= 1. Its two rims belong to it.
/// - The **unit cone**: x² + z² = (1 - y)² and 0 <= y <= 1. Its rim and its apex (0, 1, 0) belong to it.
namespace umbral::raytracing {

/// The field whose zeros are the cylinder's points, were it endless: F(p) = x² + z² - 1. Negative inside.
///
/// `p` is finite. Guarantee of the reference: within 1 ulp of the larger of x² + z² and 1. Course: problem 5.3.
[[nodiscard]] float unit_cylinder_field(const glm::vec3& p);

/// The field whose zeros are the cone's points, were it endless upwards and downwards: F(p) = x² + z² - (1 - y)².
/// Negative inside both halves.
///
/// `p` is finite. Guarantee of the reference: within 1 ulp of the larger of x² + z² and (1 - y)². Course: problem 5.3.
[[nodiscard]] float unit_cone_field(const glm::vec3& p);

/// Distance along the ray to the first of its points that lie on the unit cylinder, if there is one. The surface has
/// two sides: the ray may come from either.
///
/// `ray.direction` need not be unit; the distance t is counted in its lengths, and lies in (t_min, t_max). It is
/// negative behind the origin, if t_min admits that.
/// Rays parallel to the axis hit nothing, those in the surface too. So do rays without a direction, and rays with NaN.
/// Guarantee of the reference, from up to 1e5 away and with directions of 1e-6 to 1e6: t is within 1 ulp, and hit or
/// miss is right, wherever the line does not graze the endless cylinder (sine of its angle with the surface 1e-3 or
/// more) and passes the rims by 1e-9 or more, times its origin's distance if that is more than 1.
/// Course: problem 5.3.
[[nodiscard]] std::optional<float> intersect_unit_cylinder(const Ray& ray);

/// Distance along the ray to the first of its points that lie on the unit cone, if there is one. All is as with the
/// cylinder, but for the rays that are parallel to a line of the cone: they meet it once. Those that lie in the surface
/// hit nothing.
///
/// Guarantee of the reference: as with the cylinder. Course: problem 5.3.
[[nodiscard]] std::optional<float> intersect_unit_cone(const Ray& ray);

}
