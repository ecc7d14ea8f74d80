#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace umbral::bench {

/// The unit sphere as triangles between circles of latitude; every corner lies on it, and is its own normal.
struct BallMesh {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;  ///< triples, anticlockwise seen from outside
};

/// `sectors` >= 3 slices round the z axis, `rings` >= 2 bands from pole to pole. The mesh is convex: its quadrilaterals
/// are flat.
[[nodiscard]] BallMesh ball_mesh(int sectors, int rings);

/// How far a mesh lies from the unit sphere.
struct BallErrors {
    double distance = 0;    ///< largest distance of a point of the mesh from the sphere, in radii
    double angle = 0;       ///< largest angle between a facet's normal and the sphere's on it, in radians
    double silhouette = 0;  ///< largest distance between the outlines of mesh and sphere seen along `towards`, in radii
};

/// Exact but for the rounding of doubles. `towards` is a unit vector; the outline is an orthographic one.
[[nodiscard]] BallErrors errors_of(const BallMesh& mesh, const glm::dvec3& towards);

}
