#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <umbral/core/random.hpp>
#include <umbral/meshes/builders.hpp>
#include <umbral/meshes/winged_edge.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

using List = std::vector<std::uint32_t>;

/// The faces of a vertex out of the table of triangles alone: all are looked at.
List faces_by_search(const meshes::IndexedMesh& mesh, std::uint32_t vertex)
{
    List faces;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (const glm::uvec3& one = mesh.triangles[i]; one.x == vertex || one.y == vertex || one.z == vertex)
            faces.push_back(i);
    return faces;
}

/// A list of faces for each vertex, one behind the other.
struct Lists {
    List first;
    List faces;
};

Lists lists_of(const meshes::IndexedMesh& mesh)
{
    std::vector<List> of(mesh.positions.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) of[mesh.triangles[i][k]].push_back(i);
    Lists lists{{0}, {}};
    for (const List& one : of) {
        lists.faces.insert(lists.faces.end(), one.begin(), one.end());
        lists.first.push_back(static_cast<std::uint32_t>(lists.faces.size()));
    }
    return lists;
}

meshes::WingedMesh winged_of(const meshes::IndexedMesh& mesh)
{
    meshes::PolygonMesh polygons{mesh.positions, {}};
    for (const glm::uvec3& one : mesh.triangles) polygons.faces.push_back({one.x, one.y, one.z});
    auto made = meshes::winged_edges(polygons);
    if (auto* winged = std::get_if<meshes::WingedMesh>(&made)) return std::move(*winged);
    throw std::logic_error("neighbours: the ball has no winged edges");
}

}

Knob measure_neighbours(Means& means)
{
    constexpr std::uint64_t seed = 25;
    Study study =
        study_of("neighbours", "Which faces has a vertex?",
                 fmt::format("Asked of the table of triangles alone, of a list for each vertex, and of winged "
                             "edges (Umbral's reference), on balls. All answer the same; what a quick answer "
                             "costs is memory. Random vertices, seed {}.",
                             seed),
                 "ns per question", {{"memory", "memory of the tables", "bytes per face"}}, 1e9, "faces");
    for (const std::uint32_t slices : {16U, 32U, 64U, 128U, 256U}) {
        const auto mesh = std::make_shared<const meshes::IndexedMesh>(meshes::make_sphere(slices, slices / 2));
        const auto lists = std::make_shared<const Lists>(lists_of(*mesh));
        const auto winged = std::make_shared<const meshes::WingedMesh>(winged_of(*mesh));
        Random random(seed);
        List asked;
        for (int i = 0; i < 64; ++i)
            asked.push_back(random.below(static_cast<std::uint32_t>(mesh->positions.size() - 2)) + 1);  // no pole
        const auto faces = static_cast<double>(mesh->triangles.size());
        const auto bytes = [faces](std::size_t words) { return 12 + 4 * static_cast<double>(words) / faces; };
        const std::string situation = fmt::format("{}", mesh->triangles.size());
        study.knob.situations.push_back({situation, situation + " faces", faces});
        const auto add = [&](const std::string& name, double memory, auto answer) {
            study.trials.push_back({name,
                                    name,
                                    faces,
                                    {{"memory", memory}},
                                    64,
                                    [asked, answer] {
                                        for (const std::uint32_t vertex : asked) keep(answer(vertex));
                                    },
                                    situation});
        };
        add("triangles", bytes(0), [mesh](std::uint32_t vertex) { return faces_by_search(*mesh, vertex); });
        add("lists", bytes(lists->first.size() + lists->faces.size()), [lists](std::uint32_t vertex) {
            return List(lists->faces.begin() + lists->first[vertex], lists->faces.begin() + lists->first[vertex + 1]);
        });
        add("winged edges",
            bytes(8 * winged->edges.size() + winged->edge_of_vertex.size() + winged->edge_of_face.size()) - 12,
            [winged](std::uint32_t vertex) { return meshes::faces_round_vertex(*winged, vertex); });
    }
    study.laws = {
        {"triangles", "", "faces", 1, "All triangles are looked at.", "In small tables the answer's own cost shows."},
        {"lists", "", "faces", 0, "Only the answer is touched.", "Larger tables leave the caches."},
        {"winged edges", "", "faces", 0, "Only the edges round the vertex are touched.",
         "Larger tables leave the caches."}};
    return finish(std::move(study), means);
}

}
