#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "text/field.hpp"

/// Pieces of the parser of scenes.
namespace umbral::scene {

/// A geometry's shape, generated or written out.
[[nodiscard]] Shape parse_shape(const Field& field);

/// How many triangles it has at most (some that are generated are left out at a sphere's poles).
[[nodiscard]] std::size_t triangle_count(const Shape& shape);

/// Can it be textured? Only triangles that are written out may have no texture coordinates.
[[nodiscard]] inline bool has_uvs(const Geometry& geometry)
{
    const auto* triangles = std::get_if<Triangles>(&geometry.shape);
    return triangles == nullptr || !triangles->uvs.empty();
}

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
