#pragma once

#include <umbral/meshes/mesh.hpp>

#include "render/fields/fields.hpp"

namespace umbral::render::fields {

/// The surface where a field is 0, as triangles whose front is where it is positive: marching tetrahedra on a grid of
/// `cells`³ cells over the cube from -1 to 1, six in each cell, whose corners are then evened out along the surface.
///
/// The mesh is closed, and every edge has two triangles, for any field that is positive on the cube's sides. Where the
/// field changes as a distance does, |field| is at most a thousandth of a cell at each vertex, before it is rounded to
/// float. Parts of the surface that are smaller than a cell may be missing. Blocks of cells from which the surface is
/// too far are left out by the promise of Distance.
/// Based on: A. Doi, A. Koide. An Efficient Method of Triangulating Equi-Valued Surfaces by Using Tetrahedral Cells.
/// 1991; H. W. Kuhn's division of the cube into six tetrahedra.
[[nodiscard]] meshes::IndexedMesh isosurface(const Distance& field, int cells);

}
