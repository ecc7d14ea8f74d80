#pragma once

#include <cstddef>

/// How large a scene may be: enough for any picture of the course, and little enough that a wrong number is an error
/// and not a machine that stands still.
namespace umbral::scene {

inline constexpr std::size_t maximum_file_bytes = std::size_t{1} << 24U;
inline constexpr std::size_t maximum_lights = 16;
inline constexpr std::size_t maximum_items = 1024;  ///< textures, materials, geometries, groups, or parts of one group
inline constexpr std::size_t maximum_instances = 16384;      ///< of all groups together
inline constexpr std::size_t maximum_transforms = 64;        ///< of one instance, or one group's use
inline constexpr std::size_t maximum_nesting = 16;           ///< of groups
inline constexpr std::size_t maximum_profile = 4096;         ///< points of a revolution
inline constexpr double maximum_seconds = 3600;              ///< of a film or a period
inline constexpr int maximum_depth = 64;                     ///< of mirrors and glass; bounces likewise
inline constexpr std::size_t maximum_vertices = 1'000'000;   ///< given for one geometry; triangles likewise
inline constexpr int maximum_subdivisions = 1024;            ///< rings, sectors, rows or columns of a generated one
inline constexpr int minimum_cells = 8;                      ///< along a side of a distance field's grid
inline constexpr int maximum_cells = 256;                    ///< likewise
inline constexpr std::size_t field_triangles_per_cell = 30;  ///< of one side of that grid, at most half as many
inline constexpr std::size_t maximum_triangles = std::size_t{1}
                                                 << 23U;  ///< of all geometries together, and of all instances together
inline constexpr int maximum_texture_size = 4096;
inline constexpr std::size_t maximum_texels = std::size_t{1} << 25U;  ///< of all textures of a scene
inline constexpr std::size_t maximum_name_length = 64;
inline constexpr std::size_t maximum_path_length = 1000;
inline constexpr std::size_t maximum_mesh_bytes = std::size_t{1} << 27U;  ///< of all files of a scene's meshes
inline constexpr double maximum_coordinate = 1e6;
inline constexpr double maximum_color = 1000;

}
