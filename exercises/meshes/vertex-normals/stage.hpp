#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

#include "../halved.hpp"

/// Draws one mesh twice, side by side: flat with the normals of its faces, smooth with those of its vertices. A context must be current.
namespace umbral::meshes {

inline constexpr const char* stage_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
uniform mat4 view;
uniform mat4 projection;
out vec3 eye_position;
out vec3 eye_normal;
out vec3 object_position;

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    object_position = position;
    eye_position = eye.xyz;
    eye_normal = mat3(view) * normal;
    gl_Position = projection * eye;
}
)";

// A warm key light, a cool sky, a light from behind that draws the outline; the sRGB curve at the end. A normal of zero stays dark.
inline constexpr const char* stage_fragment_shader = R"(#version 330 core
in vec3 eye_position;
in vec3 eye_normal;
in vec3 object_position;
out vec4 fragment_color;

void main()
{
    float size = length(eye_normal);
    vec3 n = size > 0.0 ? eye_normal / size : vec3(0.0);
    vec3 v = normalize(-eye_position);
    vec3 key = normalize(vec3(-0.45, 0.65, 0.6));
    vec3 back = normalize(vec3(0.7, 0.25, -0.65));

    float turn = 0.5 + 0.5 * sin(1.3 * object_position.x - 0.9 * object_position.y);
    vec3 albedo = mix(vec3(0.02, 0.30, 0.42), vec3(0.85, 0.20, 0.07), smoothstep(0.15, 0.85, turn));
    vec3 light = mix(vec3(0.10, 0.07, 0.06), vec3(0.22, 0.28, 0.38), 0.5 + 0.5 * n.y) * size;
    light += vec3(1.00, 0.93, 0.82) * max(dot(n, key), 0.0);
    vec3 color = albedo * light;
    color += 0.35 * pow(max(dot(n, normalize(key + v)), 0.0), 60.0);
    color += vec3(0.30, 0.45, 0.60) * max(dot(n, back), 0.0) * pow(1.0 - max(dot(n, v), 0.0), 2.0);
    fragment_color = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}
)";

/// Positions, normals and triples of indices, one draw.
struct Drawable {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] gl::Mesh upload() const { return gl::Mesh(positions, normals, indices); }
};

/// Every vertex once, with its normal; missing normals are zero.
inline Drawable smooth(const IndexedMesh& mesh, std::vector<glm::vec3> vertex_normals)
{
    vertex_normals.resize(mesh.positions.size(), glm::vec3(0));
    Drawable result{mesh.positions, std::move(vertex_normals), {}};
    for (const glm::uvec3& t : mesh.triangles) result.indices.insert(result.indices.end(), {t.x, t.y, t.z});
    return result;
}

/// Every vertex once for each of its triangles, with that triangle's normal.
inline Drawable flat(const IndexedMesh& mesh, std::vector<glm::vec3> face_normals)
{
    face_normals.resize(mesh.triangles.size(), glm::vec3(0));
    Drawable result;
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
inline Image draw_side_by_side(const Drawable& left, const Drawable& right)
{
    constexpr int size = 512;
    const gl::Framebuffer frame(2 * size, size);
    frame.clear({0.075F, 0.085F, 0.115F, 1});
    glEnable(GL_DEPTH_TEST);
    const gl::Program program({"stage.vert", stage_vertex_shader}, {"stage.frag", stage_fragment_shader});
    program.set("view", glm::lookAt(glm::vec3(0.6F, -2.6F, 9.4F), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0)));
    program.set("projection", glm::perspective(glm::radians(42.0F), 1.0F, 1.0F, 30.0F));
    int column = 0;
    for (const Drawable* drawable : {&left, &right}) {
        glViewport(size * column++, 0, size, size);
        drawable->upload().draw(program);
    }
    return halved(frame.read_pixels());
}

}
