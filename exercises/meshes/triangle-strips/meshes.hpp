#pragma once

#include <array>
#include <initializer_list>
#include <kit/varied.hpp>

#include "../zoo.hpp"

/// The meshes of which strips are made.
namespace umbral::meshes {

inline std::vector<Sample> varied_tame_meshes(Variation& vary)
{
    std::vector<Sample> meshes = tame_meshes(vary);
    for (Sample& sample : meshes) sample.mesh = shuffled(sample.mesh, vary);
    return in_random_order(vary, meshes);
}

inline std::vector<Sample> larger_meshes(Random& random)
{
    std::vector<Sample> meshes = {{"sheet", flat_sheet(9, 5)},
                                  {"torus", torus(15, 10)},
                                  {"ball", ball(12, 14)},
                                  {"knot", trefoil(30, 7, 0.4)},
                                  {"plate", plate_with_holes(4)},
                                  {"hills", hills(15, 12, random)},
                                  {"fan", disc(30)}};
    for (auto& [name, mesh] : meshes) mesh = shuffled(mesh, random);
    return meshes;
}

/// As many copies of a mesh, which share nothing.
inline IndexedMesh copies(const IndexedMesh& mesh, std::uint32_t count)
{
    IndexedMesh all;
    for (std::uint32_t i = 0; i < count; ++i)
        all = joined(std::move(all), mesh, {static_cast<float>(3 * (i % 7)), 0, static_cast<float>(3 * (i / 7))});
    return all;
}

/// Small ones of more vertices than triangles: two vertices packed into one number, as a * triangles + b, are the same
/// for many other edges.
inline std::vector<Sample> loose_meshes(Random& random)
{
    std::vector<Sample> meshes;
    for (std::uint32_t i = 0; i < 8; ++i) {
        meshes.push_back({"loose triangles", copies(book(1), 3 + i)});
        meshes.push_back({"bow ties", copies(bow_tie(), 2 + i / 2)});
        meshes.push_back({"pairs of triangles", copies(book(2), 2 + i)});
        meshes.push_back({"a sheet among lonely vertices", with_lonely_vertices(flat_sheet(2 + i / 4, 2), 12)});
    }
    meshes.push_back({"a triangle", book(1)});
    meshes.push_back({"two triangles", book(2)});
    for (auto& [name, mesh] : meshes) mesh = shuffled(mesh, random);
    // The same two triangles, wound alike, from the front and the back, and such that they share a vertex only.
    const std::vector<glm::vec3> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    for (const auto& [a, b] : {std::pair(glm::uvec3(0, 1, 2), glm::uvec3(1, 2, 0)),
                               {{0, 1, 2}, {2, 1, 0}},
                               {{3, 1, 2}, {1, 2, 4}},
                               {{0, 1, 2}, {2, 3, 4}}})
        meshes.push_back({"two triangles", {places, {a, b}}});
    return meshes;
}

inline std::vector<Sample> odd_meshes(Random& random)
{
    std::vector<Sample> meshes = wild_meshes();
    meshes.push_back({"any winding", with_mixed_winding(torus(7, 5), random)});
    for (auto& [name, mesh] : meshes) {
        if (mesh.triangles.empty()) continue;
        // Two that nobody draws, and one that is there once more.
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 1}, {2, 0, 2}, mesh.triangles[random.below(count)]});
        mesh = shuffled(mesh, random);
    }
    meshes.push_back({"two rings, with numbers 65,536 apart", with_far_copy(torus(4, 3))});
    meshes.push_back({"a ring, with numbers 65,536 apart", spread(torus(9, 7), 65'536, random)});
    meshes.push_back({"a tube, with numbers 100,000 apart", spread(tube(9, 7), 100'000, random)});
    return meshes;
}

}
