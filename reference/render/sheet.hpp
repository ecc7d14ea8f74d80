#pragma once

#include <vector>

#include "render/surface.hpp"

/// Pieces from which generated surfaces are put together.
namespace umbral::render {

/// Adds `columns` x `rows` cells of two triangles, counter-clockwise where u goes to the right and v up. `index` holds
/// the position at each of the (columns + 1) x (rows + 1) corners, row by row; their texture coordinates are those from
/// `first_uv` on. Triangles with two corners at one position, as at a pole, are left out.
void add_cells(Surface& surface, const std::vector<unsigned>& index, unsigned first_uv, int columns, int rows);

/// Where a sheet over the unit square of (u, v) is joined to itself.
struct Seams {
    bool u = false;      ///< u = 1 is u = 0
    bool v = false;      ///< v = 1 is v = 0
    bool south = false;  ///< the row v = 0 is a point
    bool north = false;  ///< the row v = 1 is a point
};

/// `columns` x `rows` cells (add_cells); `place` gives a position in double.
template <class Place>
Surface sheet(int columns, int rows, Seams seams, const Place& place)
{
    Surface surface;
    std::vector<unsigned> index;  // of the position at each corner of the sheet
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const glm::dvec2 uv(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
            surface.uvs.emplace_back(uv);
            const bool is_pole = (seams.south && j == 0) || (seams.north && j == rows);
            const bool joined_u = (seams.u && i == columns) || (is_pole && i > 0);
            if (seams.v && j == rows) {
                index.push_back(index[static_cast<std::size_t>(i)]);
            } else if (joined_u) {
                index.push_back(index[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns + 1)]);
            } else {
                index.push_back(static_cast<unsigned>(surface.mesh.positions.size()));
                surface.mesh.positions.emplace_back(place(uv));
            }
        }
    }
    add_cells(surface, index, 0, columns, rows);
    return surface;
}

/// Adds all of `other`; no position becomes common to both, so that where they meet there is an edge.
void append(Surface& surface, const Surface& other);

/// The shapes of solids: closed ones, and what is turned round an axis (solids.cpp).
[[nodiscard]] Surface make_solid(const scene::Box& box);
[[nodiscard]] Surface make_solid(const scene::Cylinder& cylinder);
[[nodiscard]] Surface make_solid(const scene::Cone& cone);
[[nodiscard]] Surface make_solid(const scene::Disc& disc);
[[nodiscard]] Surface make_solid(const scene::Revolution& revolution);

/// Its four parts: body, lid, handle, spout (teapot.cpp).
[[nodiscard]] Surface make_solid(const scene::Teapot& teapot);

/// See fields/isosurface.hpp.
[[nodiscard]] Surface make_solid(const scene::DistanceField& surface);

}
