#include "render/surface.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <umbral/meshes/normals.hpp>
#include <unordered_map>

#include "render/sheet.hpp"

namespace umbral::render {
namespace {

constexpr double turn = 2 * std::numbers::pi;

Surface make(const scene::Sphere& sphere)
{
    return sheet(sphere.sectors, sphere.rings, {.u = true, .south = true, .north = true}, [](const glm::dvec2& uv) {
        const double latitude = (uv.y - 0.5) * std::numbers::pi;
        const double radius = uv.y == 0 || uv.y == 1 ? 0 : std::cos(latitude);
        return glm::dvec3(radius * std::sin(turn * uv.x), std::sin(latitude), radius * std::cos(turn * uv.x));
    });
}

Surface make(const scene::Torus& torus)
{
    return sheet(torus.rings, torus.sectors, {.u = true, .v = true}, [&](const glm::dvec2& uv) {
        const double tube = torus.tube;
        const double radius = 1 + tube * std::cos(turn * uv.y);
        return glm::dvec3(radius * std::sin(turn * uv.x), tube * std::sin(turn * uv.y), radius * std::cos(turn * uv.x));
    });
}

Surface make(const scene::Plane& plane)
{
    return sheet(plane.columns, plane.rows, {},
                 [](const glm::dvec2& uv) { return glm::dvec3(2 * uv.x - 1, 0, 1 - 2 * uv.y); });
}

Surface make(const scene::Wave& wave)
{
    return sheet(wave.columns, wave.rows, {}, [&](const glm::dvec2& uv) {
        const glm::dvec2 phase = turn * glm::dvec2(wave.waves) * uv;
        return glm::dvec3(2 * uv.x - 1, double{wave.amplitude} * std::sin(phase.x) * std::cos(phase.y), 1 - 2 * uv.y);
    });
}

Surface make(const scene::Triangles& mesh)
{
    if (mesh.uvs.empty())
        return {{mesh.positions, mesh.triangles},
                {glm::vec2(0)},
                std::vector<glm::uvec3>(mesh.triangles.size(), glm::uvec3(0))};
    return {{mesh.positions, mesh.triangles}, mesh.uvs, mesh.uv_triangles.empty() ? mesh.triangles : mesh.uv_triangles};
}

Surface make(const scene::MeshFile& mesh)
{
    throw std::invalid_argument(mesh.file +
                                " has not been read: scene::read_scene reads the files of meshes, and "
                                "scene::parse_scene does not");
}

template <class Solid>
requires requires(const Solid& solid) { make_solid(solid); }
Surface make(const Solid& solid) { return make_solid(solid); }

glm::vec3 first_defined(const glm::vec3& normal, const glm::vec3& otherwise)
{
    const auto is_unit = [](const glm::vec3& n) { return dot(n, n) > 0.5F; };
    return is_unit(normal) ? normal : is_unit(otherwise) ? otherwise : glm::vec3(0, 0, 1);
}

}

Surface make_surface(const scene::Shape& shape)
{
    return std::visit([](const auto& one) { return make(one); }, shape);
}

VertexMesh make_vertices(const Surface& surface, bool smooth)
{
    const std::vector<glm::vec3> of_faces = meshes::face_normals(surface.mesh);
    const std::vector<glm::vec3> of_vertices = smooth ? meshes::vertex_normals(surface.mesh) : std::vector<glm::vec3>();
    VertexMesh result;
    // With smooth normals a vertex is told by its position and texture coordinates; with flat ones every corner is a
    // vertex.
    std::unordered_map<std::uint64_t, unsigned> known;
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
        glm::uvec3 triangle;
        for (int corner = 0; corner < 3; ++corner) {
            const unsigned position = surface.mesh.triangles[t][corner];
            const unsigned uv = surface.uv_triangles[t][corner];
            const auto next = static_cast<unsigned>(result.vertices.size());
            triangle[corner] =
                smooth ? known.try_emplace((std::uint64_t{position} << 32U) | uv, next).first->second : next;
            if (triangle[corner] != next) continue;
            const glm::vec3 normal = first_defined(smooth ? of_vertices[position] : of_faces[t], of_faces[t]);
            result.vertices.push_back({surface.mesh.positions[position], normal, surface.uvs[uv]});
        }
        result.triangles.push_back(triangle);
    }
    return result;
}

}
