#pragma once

#include <vector>

#include "render/surface.hpp"

/// Pieces from which generated surfaces are put together.
namespace umbral::render {

/// Adds `columns` x `rows` cells of two triangles, counter-clockwise where u goes to the right and v up. `index` holds
/// the position at each of the (columns + 1) x (rows + 1) corners, row by row; their texture coordinates are those from
/// `first_uv` on. Triangles with two corners at one position, as at a pole, are left out.
void add_cells(Surface& surface, const std::vector<unsigned>& index, unsigned first_uv, int columns, int rows);

/// Adds all of `other`; no position becomes common to both, so that where they meet there is an edge.
void append(Surface& surface, const Surface& other);

/// The shapes of solids: closed ones, and what is turned round an axis (solids.cpp).
[[nodiscard]] Surface make_solid(const scene::Box& box);
[[nodiscard]] Surface make_solid(const scene::Cylinder& cylinder);
[[nodiscard]] Surface make_solid(const scene::Cone& cone);
[[nodiscard]] Surface make_solid(const scene::Disc& disc);
[[nodiscard]] Surface make_solid(const scene::Revolution& revolution);

}
