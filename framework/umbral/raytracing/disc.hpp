#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>

namespace umbral::raytracing {

/// The points of a plane that are nearer to `centre` than `radius`: those of the rim do not belong to it. `normal` is
/// perpendicular to the plane, of any length, and may point to either side. `radius` > 0.
struct Disc {
    glm::vec3 centre;
    glm::vec3 normal;
    float radius;
};

/// Distance along the ray to the point that it shares with the disc, if there is one. A disc has two sides: the ray may
/// come from either.
///
/// `ray.direction` need not be unit; the distance t is counted in its lengths, and lies in (t_min, t_max). It is
/// negative behind the origin, if t_min admits that.
/// Rays parallel to the disc hit nothing, those in its plane too. So do rays without a direction, rays with NaN in
/// them, and discs whose normal is null.
/// Guarantee of the reference, where the ray's angle with the plane and the angle under which its origin sees the plane
/// have sines of 1e-6 or more: t is within 1 ulp, and hit or miss is right whenever the ray passes the rim by more than
/// 1e-6 ulp of its origin's distance from the centre, divided by the first of these sines. Course: problem 5.1.
[[nodiscard]] std::optional<float> intersect(const Ray& ray, const Disc& disc);

}
