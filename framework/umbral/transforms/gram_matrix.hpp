#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

// Products of vectors that are given by their coordinates in any basis. A basis is a matrix whose columns e0, e1, e2
// are its vectors, in a Cartesian frame of the world: of any lengths and angles, right-handed or left-handed, but not
// in one plane. (a0, a1, a2) means the vector a0 e0 + a1 e1 + a2 e2.

/// All dot products of the basis: entry [i][j] is e_i · e_j. Within half an ulp and 2^-52 |e_i||e_j|.
[[nodiscard]] glm::mat3 gram_matrix(const glm::mat3& basis);

/// The dot product of two vectors given by coordinates, from the dot products of the basis alone: the sum of a_i b_j
/// (e_i · e_j) over all nine pairs. Off by half an ulp and 2^-50 of the sum of the terms' sizes. In a Cartesian frame
/// it is the sum of the three products of coordinates. Course: problem 1.8.
[[nodiscard]] float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b);

/// The area of the parallelogram of two vectors given by coordinates, |a × b|, from the dot products of the basis
/// alone; 0 if they are parallel. Off by at most 2e-7 of itself, however small their angle is, for bases whose Gram
/// matrix has no eigenvalue a thousand times another.
[[nodiscard]] float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b);

/// The coordinates, in the same basis, of the cross product of two vectors given by coordinates. The cross product
/// itself goes by the right-hand rule of the world, also where the basis is left-handed. In a Cartesian frame it is the
/// usual formula. Each component is off by at most 2e-7 of the longest one, for such bases as above. Course: problem
/// 1.9.
[[nodiscard]] glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b);

/// (a × b) · c: the volume of the parallelepiped of three vectors of whole numbers in a Cartesian frame, negative if
/// they are left-handed. Exact for components from -2^20 to 2^20: so (a × b) · a and (a × b) · b are 0. Course: problem
/// 1.10.
[[nodiscard]] std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c);

}
