#pragma once

#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>

/// Where a sphere in the light of one source is brightest. Sources with a place, and the eye, are outside the sphere:
/// farther from its centre than 1.001 radii.
namespace umbral::lighting {

/// A sphere that is lit from outside and looked at from outside.
struct Sphere {
    glm::vec3 centre{0};
    float radius = 1;  ///< > 0
};

/// The point where the sphere's diffuse term max(0, n·l) is greatest, seen or not. Guarantee of the reference, as for
/// all points below: within 1e-7 of the radius, and rounded once to float. Course: problem 3.9a.
[[nodiscard]] glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light);

/// Whether the eye sees a point of the sphere: n·v > 0, with n from the centre to the point and v from the point to the
/// eye. Points of the horizon, where n·v = 0, are not seen. Guarantee of the reference: exact, unless |n·v| is below
/// 1e-14 of the product of the lengths that it is made of. Course: problem 3.9.
[[nodiscard]] bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye);

/// The point that is brightest among those that the eye sees, again by max(0, n·l).
///
/// It is brightest_diffuse if the eye sees that. Otherwise the seen points grow brighter and brighter towards a point
/// of the horizon, and the answer is that point. There is none if no light at all arrives where the eye sees: if the
/// lit part and the seen part of the sphere have no inner point in common. Course: problem 3.9a, carried on.
[[nodiscard]] std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye);

/// The point whose highlight is 1, the most that there is: where a mirror sends the light to the eye, r = v, and so
/// h = n. It lies in the plane of centre, light and eye, n·l = n·v > 0 there, and there is at most one. There is none
/// if the straight way from the eye to the light passes through the sphere; highlights near its edge are
/// then below 1. Course: problem 3.9b; the general case is Alhazen's problem.
[[nodiscard]] std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light,
                                                          const glm::vec3& eye);

}
