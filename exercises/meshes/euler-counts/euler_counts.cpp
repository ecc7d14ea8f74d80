#include <umbral/meshes/euler.hpp>

namespace umbral::meshes {

TopologyCounts count_topology(const IndexedMesh& mesh)
{
    // TODO: go over the triangles once. Note which vertices they use, and count how many faces each edge has:
    // an edge is an unordered pair of vertices. Then look at the edges once.
    return not_implemented<TopologyCounts>(mesh);
}

std::optional<int> genus(const IndexedMesh& mesh)
{
    // TODO: std::nullopt unless the faces are a coherently wound 2-manifold; else g from V - E + F = 2 c - 2 g - b.
    return not_implemented<std::optional<int>>(mesh);
}

std::optional<ElementCounts> sphere_from_vertices(std::int64_t vertices)
{
    // TODO: E = 3 (V - 2), F = 2 (V - 2).
    return not_implemented<std::optional<ElementCounts>>(vertices);
}

std::optional<ElementCounts> sphere_from_edges(std::int64_t edges)
{
    // TODO
    return not_implemented<std::optional<ElementCounts>>(edges);
}

std::optional<ElementCounts> sphere_from_faces(std::int64_t faces)
{
    // TODO
    return not_implemented<std::optional<ElementCounts>>(faces);
}

}
