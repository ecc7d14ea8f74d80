#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// An indexed mesh from isolated triangles: corners in one place become one vertex.
///
/// `corners` holds three positions a triangle, one triangle after the other; its size is a multiple of three. Two
/// corners are in one place if their coordinates are equal as numbers: not nearly, but exactly. So -0.0 and +0.0 are
/// the same place, and a corner with a coordinate that is NaN is in no other's place: it is a vertex of its own.
/// Infinities are places like others.
///
/// The result is unique: vertices stand in the order in which their places first come up, and are that corner (of two
/// zeros, either sign); triangles and their corners stand in the order of the input. Triangles whose corners coincide
/// stay. Takes time in proportion to the corners, but for bad luck with hashing or the log n of sorting, wherever the
/// corners lie. Course: "triángulos aislados (TA)", "malla indexada".
[[nodiscard]] IndexedMesh weld(const std::vector<glm::vec3>& corners);

/// The other way: three positions for each triangle of an indexed mesh, in order.
/// Course: "triángulos aislados (TA)".
[[nodiscard]] std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh);

}
