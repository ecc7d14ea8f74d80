#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// The matrix U that carries normals along when `model`, an affine matrix, carries positions. Its length is free: any
/// positive multiple of it is as good.
///
/// With A the upper left 3 × 3 of `model`:
/// - if A can be inverted, U is a positive multiple of the inverse transpose of A, so that what pointed outwards still
/// does, also in mirrors;
/// - if A flattens space onto a plane (det A = 0), U is a positive multiple of the matrix of cofactors of A;
/// - if A leaves no more than a line, U is zero: nothing has a normal then.
/// The reference's largest entry is 1 or -1; the others are off by 1e-7 at most, for any A of finite floats whose
/// volume, |det A|, is at least 1e-13 of the product of its columns' lengths, or exactly 0. Course: "transformación de
/// normales".
[[nodiscard]] glm::mat3 normal_matrix(const glm::mat4& model);

/// The unit normal of the transformed surface, U · `normal` brought to length 1; null if U · `normal` is null (a null
/// normal, or a surface that is seen edge-on from where it is flattened).
[[nodiscard]] glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal);

}
