#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <kit/stage.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

/// Draws one mesh twice, side by side: flat with the normals of its faces, smooth with those of its vertices. A context
/// must be current.
namespace umbral::meshes {

inline constexpr const char* two_colors = R"(
vec3 paint()
{
    float turn = 0.5 + 0.5 * sin(1.3 * place.x - 0.9 * place.y);
    return mix(vec3(0.02, 0.30, 0.42), vec3(0.85, 0.20, 0.07), smoothstep(0.15, 0.85, turn));
}
)";

/// Every vertex once, with its normal; missing normals are zero, and stay dark.
inline shapes::Shape smooth(const IndexedMesh& mesh, std::vector<glm::vec3> vertex_normals)
{
    vertex_normals.resize(mesh.positions.size(), glm::vec3(0));
    shapes::Shape result{mesh.positions, std::move(vertex_normals), {}};
    for (const glm::uvec3& t : mesh.triangles) result.indices.insert(result.indices.end(), {t.x, t.y, t.z});
    return result;
}

/// Every vertex once for each of its triangles, with that triangle's normal.
inline shapes::Shape flat(const IndexedMesh& mesh, std::vector<glm::vec3> face_normals)
{
    face_normals.resize(mesh.triangles.size(), glm::vec3(0));
    shapes::Shape result;
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        for (int corner = 0; corner < 3; ++corner) {
            result.indices.push_back(static_cast<std::uint32_t>(result.positions.size()));
            result.positions.push_back(mesh.positions[mesh.triangles[face][corner]]);
            result.normals.push_back(face_normals[face]);
        }
    }
    return result;
}

/// 512 x 256 pixels: `left` and `right` from the same point of view.
inline Image draw_side_by_side(const shapes::Shape& left, const shapes::Shape& right)
{
    const Stage stage(512, 256, ink::night, two_colors);
    stage.look({0.6F, -2.6F, 9.4F}, {0, 0, 0}, 42);
    int column = 0;
    for (const shapes::Shape* shape : {&left, &right}) {
        stage.column(column++, 2);
        stage.draw({uploaded(*shape), glm::mat4(1), {.gloss = 0.35F}});
    }
    return stage.picture();
}

}
