// alternative: sorts the corners by place, gives all of a place the first one's number, and then counts in the order of
// the input
#include <tuple>
#include <umbral/meshes/weld.hpp>

namespace umbral::meshes {

IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> first_at(corners.size());  // the first corner in the same place
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        first_at[i] = i;
        if (corners[i] == corners[i]) order.push_back(i);
    }
    const auto key = [&](std::uint32_t i) { return std::tuple(corners[i].x, corners[i].y, corners[i].z); };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 1; i < order.size(); ++i)
        if (corners[order[i]] == corners[order[i - 1]]) first_at[order[i]] = first_at[order[i - 1]];

    IndexedMesh mesh;
    std::vector<std::uint32_t> vertex(corners.size());
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        if (first_at[i] == i) {
            vertex[i] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(corners[i]);
        } else {
            vertex[i] = vertex[first_at[i]];
        }
        if (i % 3 == 2) mesh.triangles.emplace_back(vertex[i - 2], vertex[i - 1], vertex[i]);
    }
    return mesh;
}

std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> corners(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = mesh.positions[mesh.triangles[i / 3][static_cast<int>(i % 3)]];
    return corners;
}

}
