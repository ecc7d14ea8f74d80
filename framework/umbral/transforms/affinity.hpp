#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::transforms {

/// A point, and where a transformation takes it.
struct PointPair {
    glm::vec3 point;
    glm::vec3 image;
};

/// How far a transformation misses the corner of one parallelogram: from the images of p, p + u, p + v and p + u + v,
/// in this order, T(p + u + v) - T(p + u) - T(p + v) + T(p). An affine transformation takes parallelograms to
/// parallelograms: for it this is the null vector. Within half an ulp of its longest component and 2^-50 of the
/// images'. Course: "caracterización de las transformaciones afines".
[[nodiscard]] glm::vec3 parallelogram_defect(const std::array<glm::vec3, 4>& images);

/// The matrix of the affine transformation that takes the points to their images: image = M · point, with the last row
/// 0 0 0 1. Of four points there is exactly one. Of more, the one that misses the images by least: the sum of the
/// squared distances is the smallest.
///
/// Nothing if there are fewer than four points or if all lie in a plane: points count as in a plane if they are thinner
/// than 1e-9 of their extent; any that are not so are thicker than 1e-7 of it. Each entry is off by at most 2e-7 of its
/// column's largest, however thin, small, large or far away the points are. Course: "matriz asociada a una
/// transformación afín".
[[nodiscard]] std::optional<glm::mat4> affine_from_points(std::span<const PointPair> pairs);

/// Does that transformation take each point to its image, in every coordinate within `tolerance` times the extent of
/// the images? The extent is the largest difference of two images in a coordinate. False where affine_from_points finds
/// nothing.
[[nodiscard]] bool is_affine(std::span<const PointPair> pairs, float tolerance);

}
