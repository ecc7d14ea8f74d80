#include <umbral/meshes/orientation.hpp>

namespace umbral::meshes {

ManifoldFaults manifold_faults(const IndexedMesh& mesh)
{
    // TODO: count the triangles of each edge; see which vertices have none, and whose triangles do not hang together.
    return not_implemented<ManifoldFaults>(mesh);
}

std::optional<std::vector<glm::uvec3>> coherent_triangles(const IndexedMesh& mesh)
{
    // TODO: for each piece, begin at its first triangle and go from neighbour to neighbour. Turn over those that run
    // along the shared edge in the same direction. If you come to a triangle again and would have to turn it over,
    // there is no coherent winding: return std::nullopt.
    return not_implemented<std::optional<std::vector<glm::uvec3>>>(mesh);
}

std::vector<glm::uvec3> outward_triangles(const IndexedMesh& mesh)
{
    // TODO: for each closed piece, add up the signed volumes of the tetrahedra over its triangles. If the sum is
    // negative, turn the whole piece over.
    return not_implemented<std::vector<glm::uvec3>>(mesh);
}

IndexedMesh separated(const IndexedMesh& mesh)
{
    // TODO: at each vertex, find the groups of triangles that hang together over edges of exactly two triangles. All
    // groups but one get a copy of the vertex.
    return not_implemented<IndexedMesh>(mesh);
}

}
