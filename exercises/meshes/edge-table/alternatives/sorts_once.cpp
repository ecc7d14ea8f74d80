// alternative: all sides with the smaller vertex first, sorted, each kept once; for closed meshes a small array for
// each triangle
#include <algorithm>
#include <umbral/meshes/edges.hpp>

namespace umbral::meshes {
namespace {

std::vector<glm::uvec2> sides(const glm::uvec3& t) { return {{t.x, t.y}, {t.y, t.z}, {t.z, t.x}}; }

}

std::vector<glm::uvec2> edge_table(const IndexedMesh& mesh)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        for (const glm::uvec2& side : sides(t)) all.emplace_back(std::minmax(side.x, side.y));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<glm::uvec2> edges;
    for (const auto& [low, high] : all) edges.emplace_back(low, high);
    return edges;
}

std::vector<glm::uvec2> edge_table_of_closed(const IndexedMesh& mesh)
{
    std::vector<glm::uvec2> edges;
    for (const glm::uvec3& t : mesh.triangles)
        for (const glm::uvec2& side : sides(t))
            if (side.x < side.y) edges.push_back(side);
    return edges;
}

}
