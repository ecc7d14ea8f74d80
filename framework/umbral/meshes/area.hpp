#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>

namespace umbral::meshes {

/// The area of the triangle a, b, c: half of |(b - a) × (c - a)|, in square units, never negative.
///
/// 0 if the corners lie on one line, or are not all finite. The reference's guarantee: within one ulp of the exact area
/// of these very corners, also for slivers whose edges enclose an angle of 1e-6, as long as the corners' coordinates
/// lie within a factor of 2^20 of each other and the area is a normal float. Course: problem 2.6.
[[nodiscard]] float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The sum of the areas of all triangles of a mesh; 0 for none.
///
/// Triangles with corners that are not finite count as 0. The reference's guarantee: within one ulp for up to 10⁷
/// triangles, whatever their sizes, under the conditions of triangle_area. Course: problem 2.6.
[[nodiscard]] float surface_area(const IndexedMesh& mesh);

}
