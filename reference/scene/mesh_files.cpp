// The files of a scene's meshes: what parse_shape left as MeshFile becomes Triangles.

#include <algorithm>
#include <fstream>
#include <span>
#include <stdexcept>
#include <umbral/meshes/ply.hpp>

#include "scene/limits.hpp"
#include "scene/obj.hpp"
#include "scene/parts.hpp"
#include "scene/sphere_uvs.hpp"

namespace umbral::scene {
namespace {

constexpr double maximum_uv = 1000;

/// The whole of a regular file of at most `most` bytes. `field` names it.
std::string read_whole(const std::filesystem::path& path, std::size_t most, const MeshFile& mesh, const Field& field)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        field.refuse("a file, but there is none at " + path.string() +
                     (mesh.package.empty() ? "; a path that is not absolute begins at the scene's folder"
                                           : "; it comes with the Debian package " + mesh.package +
                                                 ": apt-get install " + mesh.package));
    std::ifstream stream(path, std::ios::binary);
    if (!std::filesystem::is_regular_file(path, error) || !stream)
        field.refuse("a regular file that can be read at " + path.string());
    // By pieces: memory follows what is there, not what might be.
    std::string text;
    for (std::string piece(1U << 20U, '\0'); stream && text.size() <= most;) {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > most)
        field.refuse("at most " + std::to_string(maximum_mesh_bytes) + " bytes in the files of all meshes");
    return text;
}

void require_at_most(std::size_t count, const char* what)
{
    if (count > maximum_vertices)
        throw std::runtime_error("expected at most " + std::to_string(maximum_vertices) + " " + what + ", got " +
                                 std::to_string(count));
}

Triangles read_ply(const std::string& bytes)
{
    const meshes::PolygonMesh mesh = meshes::read_ply(std::as_bytes(std::span(bytes)));
    require_at_most(mesh.positions.size(), "vertices");
    std::size_t triangles = 0;
    for (const std::vector<std::uint32_t>& face : mesh.faces) triangles += face.size() < 3 ? 0 : face.size() - 2;
    require_at_most(triangles, "triangles");
    meshes::IndexedMesh fans = meshes::fan_triangles(mesh);
    return {std::move(fans.positions), std::move(fans.triangles), {}, {}};
}

template <class Vector>
void require_within(const std::vector<Vector>& list, double most, const std::string& what)
{
    const auto is_outside = [&](const Vector& one) {  // of a NaN as well
        return !glm::all(glm::lessThanEqual(glm::abs(one), Vector(static_cast<float>(most))));
    };
    const auto found = std::find_if(list.begin(), list.end(), is_outside);
    if (found == list.end()) return;
    std::string got;
    for (int i = 0; i < Vector::length(); ++i) got += (i == 0 ? "" : ", ") + std::to_string((*found)[i]);
    throw std::runtime_error(what + " " + std::to_string(found - list.begin() + 1) +
                             ": expected finite coordinates of size " + std::to_string(static_cast<long long>(most)) +
                             " or less, got (" + got + ")");
}

/// Moves and scales what triangles use to where MeshFile::fit says.
void fit(Triangles& mesh)
{
    glm::dvec3 low(mesh.positions[mesh.triangles[0].x]);
    glm::dvec3 high(low);
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            low = glm::min(low, glm::dvec3(mesh.positions[triangle[i]]));
            high = glm::max(high, glm::dvec3(mesh.positions[triangle[i]]));
        }
    const glm::dvec3 sides = high - low;
    const double longest = std::max({sides.x, sides.y, sides.z});
    if (longest == 0) throw std::runtime_error("expected a mesh with a size, as it is to fit, got a single point");
    for (glm::vec3& place : mesh.positions) place = glm::vec3((glm::dvec3(place) - 0.5 * (low + high)) * (2 / longest));
}

/// Throws std::runtime_error that says where in the file.
Triangles mesh_in(const std::string& text, const MeshFile& file)
{
    Triangles mesh = file.file.ends_with(".obj") ? read_obj(text) : read_ply(text);
    if (mesh.triangles.empty()) throw std::runtime_error("expected a mesh with faces, got none");
    require_within(mesh.positions, maximum_coordinate, "vertex");
    require_within(mesh.uvs, maximum_uv, "texture coordinates");
    if (file.fit) fit(mesh);
    if (mesh.uvs.empty()) {
        SphereUvs map = sphere_uvs(mesh.positions, mesh.triangles);
        mesh.uvs = std::move(map.uvs);
        mesh.uv_triangles = std::move(map.triangles);
    }
    return mesh;
}

}

void read_mesh_files(const Field& geometries, const std::filesystem::path& folder, Scene& scene)
{
    std::size_t left = maximum_mesh_bytes;
    for (Geometry& geometry : scene.geometries) {
        const auto* const file = std::get_if<MeshFile>(&geometry.shape);
        if (file == nullptr) continue;
        const Field field = geometries.member(geometry.name).member("file");
        const std::string text = read_whole(folder / file->file, left, *file, field);
        left -= text.size();
        try {
            geometry.shape = mesh_in(text, *file);
        } catch (const std::runtime_error& error) {
            field.refuse("a mesh that can be drawn (" + std::string(error.what()) + ")");
        }
    }
}

}
