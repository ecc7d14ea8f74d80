#pragma once

#include <array>
#include <umbral/meshes/orientation.hpp>
#include <umbral/record/ask.hpp>

#include "../show.hpp"
#include "cases.hpp"

/// The picture: fronts are bright, backs are red; what was separated is drawn apart.
namespace umbral::meshes {

inline constexpr glm::vec3 front_color = ink::blue;
inline constexpr glm::vec3 back_color(0.90F, 0.25F, 0.16F);

/// Half a body, so that its inside can be seen.
inline IndexedMesh cut_open(const IndexedMesh& mesh)
{
    IndexedMesh result{mesh.positions, {}};
    for (const glm::uvec3& t : mesh.triangles) {
        if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size()) continue;
        const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F;
        if (middle.x < 0.25F || middle.z < 0) result.triangles.push_back(t);
    }
    return result;
}

inline void show_sides(Show& show, int pane, const IndexedMesh& mesh)
{
    show.pane(pane, 0, {{1.9F, 2.0F, 3.6F}, {0, 0, 0}, 38});
    const std::array colors{front_color};
    show.mesh(mesh, colors, {0.8F, back_color, 1});
}

/// Every vertex is drawn towards the middle of its own piece, so that what is not joined comes apart.
inline IndexedMesh pulled_apart(IndexedMesh mesh)
{
    // Pieces by their lowest vertex; a few rounds are enough for meshes as small as these.
    std::vector<std::uint32_t> piece(mesh.positions.size());
    for (std::uint32_t i = 0; i < piece.size(); ++i) piece[i] = i;
    for (int round = 0; round < 64; ++round) {
        for (const glm::uvec3& t : mesh.triangles) {
            if (t.x >= piece.size() || t.y >= piece.size() || t.z >= piece.size()) continue;
            piece[t.x] = piece[t.y] = piece[t.z] = std::min({piece[t.x], piece[t.y], piece[t.z]});
        }
    }
    std::map<std::uint32_t, std::pair<glm::vec3, float>> middles;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        middles[piece[i]].first += mesh.positions[i];
        middles[piece[i]].second += 1;
    }
    for (std::size_t i = 0; i < piece.size(); ++i)
        mesh.positions[i] += 0.18F * middles[piece[i]].first / middles[piece[i]].second;
    return mesh;
}

/// A torus wound at random; the same wound coherently, but inside out; two balls, one within the other, turned outwards
/// and cut open; cubes that shared edges, come apart.
inline Image picture_of_sides(Recorder& out, Random& random)
{
    Show show(4, 1, 170, 190);
    const IndexedMesh body = torus(26, 14, 0.95F, 0.42F);
    const IndexedMesh mixed = with_mixed_winding(turned_over(body), random);
    show_sides(show, 0, mixed);
    const auto wound = ask<coherent_triangles>(out, mixed);
    show_sides(show, 1, {body.positions, wound.value_or(std::vector<glm::uvec3>{})});
    const IndexedMesh inside_out = joined(turned_over(ball(24, 14, 1.25F)), turned_over(ball(16, 10, 0.55F)));
    show_sides(show, 2, cut_open({inside_out.positions, ask<outward_triangles>(out, inside_out)}));
    IndexedMesh cubes = centred(cube_surface({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 0, 1}, {0, 1, 1}}, 0.62F));
    show_sides(show, 3, pulled_apart(ask<separated>(out, cubes)));
    return show.picture();
}

}
