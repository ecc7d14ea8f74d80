#pragma once

#include <glm/glm.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace umbral::render {

/// A surface whose texture coordinates have indices of their own, as in OBJ files: along a seam, where u jumps from 1
/// to 0, triangles share positions (so that normals are smooth there) and not texture coordinates.
struct Surface {
    meshes::IndexedMesh mesh;
    std::vector<glm::vec2> uvs;            ///< at least one
    std::vector<glm::uvec3> uv_triangles;  ///< one for each of mesh.triangles
};

/// The surface that a scene asks for. Generated positions are computed in double and rounded once. Throws
/// std::invalid_argument for a file that has not been read (scene::MeshFile).
[[nodiscard]] Surface make_surface(const scene::Shape& shape);

/// What both renderers draw: a vertex is one position, one normal and one pair of texture coordinates.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;  ///< unit, outward
    glm::vec2 uv;
};
struct VertexMesh {
    std::vector<Vertex> vertices;
    std::vector<glm::uvec3> triangles;
};

/// Joins positions, texture coordinates and normals: those of the vertices (`smooth`), or each triangle's own.
/// Where a normal is undefined (a degenerate triangle, normals that cancel) it is the triangle's, or else (0, 0, 1):
/// never zero.
[[nodiscard]] VertexMesh make_vertices(const Surface& surface, bool smooth);

}
