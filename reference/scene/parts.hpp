#pragma once

#include <cstddef>

#include "scene/scene.hpp"
#include "text/field.hpp"

/// Pieces of the parser of scenes.
namespace umbral::scene {

using Shape = decltype(Geometry::shape);

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

}
