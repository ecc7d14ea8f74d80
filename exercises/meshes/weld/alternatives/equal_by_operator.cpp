// alternative: a hash table of positions that compares them by ==, so that zeros and NaN need no special care
#include <umbral/meshes/weld.hpp>
#include <unordered_map>

namespace umbral::meshes {
namespace {

// std::hash gives both zeros the same number.
struct Hash {
    std::size_t operator()(const glm::vec3& p) const
    {
        std::size_t seed = 0;
        for (int i = 0; i < 3; ++i) seed = 31 * seed + std::hash<float>()(p[i]);
        return seed;
    }
};

}

IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    IndexedMesh mesh;
    std::unordered_map<glm::vec3, std::uint32_t, Hash> known;
    std::vector<std::uint32_t> indices;
    for (const glm::vec3& corner : corners) {
        const auto [found, is_new] = known.try_emplace(corner, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) mesh.positions.push_back(corner);
        indices.push_back(found->second);
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    return mesh;
}

std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> corners;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) corners.push_back(mesh.positions[t[i]]);
    return corners;
}

}
