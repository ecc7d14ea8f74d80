#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>

namespace umbral::raytracing {

/// A ball's surface: `centre` in world units, `radius` > 0.
struct Sphere {
    glm::vec3 centre;
    float radius;
};

/// Distance along the ray to the first point of the sphere, if there is one.
///
/// `ray.direction` need not be unit; the distance t is counted in its lengths, and lies in (t_min, t_max). It is
/// negative behind the origin, if t_min admits that.
/// Rays without a direction, or with NaN in them, hit nothing.
/// Guarantee of the reference, from up to 1e6 radii away: hit or miss is right whenever the ray passes the silhouette
/// by more than two ulp of its origin's distance from the centre (widest miss measured: 1.2); t is within 24 ulp
/// (measured: 16) unless the ray grazes (cosine to the normal under 0.1) or starts within one radius of the surface
/// (measured at 1 % of it: 310). Course: problem 5.2.
[[nodiscard]] std::optional<float> intersect(const Ray& ray, const Sphere& sphere);

}
