#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

// Vectors by their coordinates in a Cartesian frame. All finite floats are allowed, from the smallest to the largest,
// as long as the result is a float. Names differ from GLM's so that nobody calls one for the other.

/// a·b = a.x b.x + a.y b.y + a.z b.z. Off by at most an ulp and 2^-50 |a||b|.
/// Course: "cálculo del producto escalar", problem 1.8.
[[nodiscard]] float dot_product(const glm::vec3& a, const glm::vec3& b);

/// a × b, perpendicular to both by the right-hand rule; each component within an ulp, also for nearly parallel vectors.
/// Course: "cálculo del producto vectorial", problems 1.9 and 1.10.
[[nodiscard]] glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b);

/// |v|, within an ulp; never 0 for a vector that is not null.
[[nodiscard]] float length_of(const glm::vec3& v);

/// The unit vector in the direction of v; the null vector for the null vector.
[[nodiscard]] glm::vec3 normalised(const glm::vec3& v);

/// The angle between two vectors in radians, in [0, π]; within an ulp, however small it is. 0 if either vector is null.
/// Course: "ángulo entre vectores", there by the arc cosine.
[[nodiscard]] float angle_between(const glm::vec3& a, const glm::vec3& b);

/// The part of `a` along `b`, ((a·b) / (b·b)) b; null if `b` is null. Its error is small beside its own length, also
/// where it is a ten millionth of `a`.
[[nodiscard]] glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b);

/// The part of `a` across `b`: what is left of `a` without its parallel part; `a` itself if `b` is null. Its error is
/// small beside its own length, however little is left.
[[nodiscard]] glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b);

}
