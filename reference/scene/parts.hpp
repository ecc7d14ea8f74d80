#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "text/field.hpp"

/// Pieces of the parser of scenes.
namespace umbral::scene {

/// A geometry's shape, generated or written out.
[[nodiscard]] Shape parse_shape(const Field& field);

/// How many triangles it has at most (some that are generated are left out at a sphere's poles). A file that has not
/// been read has none yet.
[[nodiscard]] std::size_t triangle_count(const Shape& shape);

/// Can it be textured? Only triangles that are written out may have no texture coordinates.
[[nodiscard]] inline bool has_uvs(const Geometry& geometry)
{
    const auto* triangles = std::get_if<Triangles>(&geometry.shape);
    return triangles == nullptr || !triangles->uvs.empty();
}

/// Puts the triangles of its file in place of every MeshFile of `scene`. `geometries`: the scene's field of that name,
/// whose places errors name; `folder`: where files are that have no absolute path. Throws std::runtime_error, as Field
/// does, if a file is missing, too large, no mesh, or a mesh beyond the limits.
void read_mesh_files(const Field& geometries, const std::filesystem::path& folder, Scene& scene);

[[nodiscard]] Camera parse_camera(const Field& field);
[[nodiscard]] Light parse_light(const Field& field);
[[nodiscard]] Texture parse_texture(const Field& field);

/// `textures`: the names that a material may refer to, in the order of Scene::textures.
[[nodiscard]] Material parse_material(const Field& field, const std::vector<std::string>& textures);

/// Reads "groups" and "instances" of the scene `root` into scene.instances: uses of groups are replaced by what is in
/// them, again and again. Materials and geometries must have been read.
void parse_instances(const Field& root, Scene& scene);

/// The names of what has names, in its order.
template <class Thing>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Thing>& things)
{
    std::vector<std::string> names;
    for (const Thing& thing : things) names.push_back(thing.name);
    return names;
}

/// Complains at `list` of a name that stands twice.
void refuse_a_name_twice(const Field& list, std::vector<std::string> names);

}
