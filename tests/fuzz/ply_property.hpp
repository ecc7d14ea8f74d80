#pragma once

#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <umbral/meshes/ply.hpp>

namespace umbral::tests {

inline meshes::PolygonMesh read(std::string_view file)
{
    return meshes::read_ply(std::as_bytes(std::span(file.data(), file.size())));
}

inline bool is_same(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}

inline bool is_same(const meshes::PolygonMesh& a, const meshes::PolygonMesh& b)
{
    if (a.faces != b.faces || a.positions.size() != b.positions.size()) return false;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (!is_same(a.positions[i][axis], b.positions[i][axis])) return false;
    return true;
}

/// Whatever the bytes are: they are refused by a PlyError, or they are a mesh with good indices that every format gives
/// back bit for bit. Returns whether they were read. Throws std::logic_error where this does not hold.
inline bool holds_for(std::string_view file)
{
    meshes::PolygonMesh mesh;
    try {
        mesh = read(file);
    } catch (const meshes::PlyError&) {
        return false;
    }
    for (const auto& face : mesh.faces)
        for (const std::uint32_t corner : face)
            if (corner >= mesh.positions.size()) throw std::logic_error("a corner that is no vertex was read");
    for (const auto format :
         {meshes::PlyFormat::ascii, meshes::PlyFormat::little_endian, meshes::PlyFormat::big_endian})
        if (!is_same(read(meshes::write_ply(mesh, format)), mesh))
            throw std::logic_error("written and read back, the mesh is another");
    return true;
}

}
