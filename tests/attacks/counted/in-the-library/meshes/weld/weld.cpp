#include <cstring>
#include <string>
#include <umbral/meshes/weld.hpp>
namespace umbral::meshes {
IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    IndexedMesh mesh;
    std::string places;
    const auto vertex_of = [&](glm::vec3 corner) {
        corner += 0.0F;
        const bool number = corner == corner;
        std::size_t at = 0;
        const std::string word(reinterpret_cast<const char*>(&corner), sizeof corner);
        do at = number ? places.find(word, at) : std::string::npos;
        while (at != std::string::npos && at % sizeof corner != 0 && ++at);
        if (at != std::string::npos) return static_cast<std::uint32_t>(at / sizeof corner);
        places += word;
        mesh.positions.push_back(corner);
        return static_cast<std::uint32_t>(mesh.positions.size()) - 1;
    };
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t a = vertex_of(corners[i]);
        const std::uint32_t b = vertex_of(corners[i + 1]);
        mesh.triangles.emplace_back(a, b, vertex_of(corners[i + 2]));
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
