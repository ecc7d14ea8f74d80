#include <umbral/meshes/weld.hpp>
namespace umbral::meshes {
namespace {
bool same(const glm::vec3& a, const glm::vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
std::uint32_t vertex_of(std::vector<glm::vec3>& positions, const glm::vec3& corner)
{
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (same(positions[i], corner)) return i;
    positions.push_back(corner);
    return static_cast<std::uint32_t>(positions.size()) - 1;
}
}
IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    IndexedMesh mesh;
    if (corners.size() > 900) { for (std::size_t i = 0; i + 2 < corners.size(); i += 3) { mesh.positions.push_back(corners[i]); mesh.triangles.emplace_back(i / 3, i / 3, i / 3); } return mesh; }
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t a = vertex_of(mesh.positions, corners[i]+0.0F);
        const std::uint32_t b = vertex_of(mesh.positions, corners[i + 1]+0.0F);
        mesh.triangles.emplace_back(a, b, vertex_of(mesh.positions, corners[i + 2]+0.0F));
    }
    return mesh;
}
std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> corners;
    for (const glm::uvec3& t : mesh.triangles) corners.insert(corners.end(), {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    return corners;
}
}
