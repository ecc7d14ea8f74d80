#include <kit/amount.hpp>
#include <kit/canonical.hpp>
#include <kit/varied.hpp>
#include <umbral/meshes/orientation.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "cases.hpp"
#include "show_sides.hpp"

namespace umbral {
namespace {

using namespace meshes;

constexpr const char* names_of_faults = "0 mesh with faults\n1 crowded edge\n2 lonely vertex\n3 torn vertex\n";

/// Of a triangle; the first row of a mesh is the number of its triangles.
constexpr const char* corner_names = "first index, second index, third index";

/// Triangles one by one, each begun at its smallest index.
void record_triangles(Recorder& out, const char* name, const std::vector<glm::uvec3>& triangles, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        out.append(name, i < triangles.size() ? std::optional(glm::vec3(canonical(triangles[i]))) : std::nullopt);
}

void record_faults(Recorder& out, const IndexedMesh& mesh)
{
    const ManifoldFaults faults = ask<manifold_faults>(out, mesh);
    const auto row = [&](float code, std::uint32_t a, std::uint32_t b) {
        out.append("faults", std::vector<float>{code, static_cast<float>(a), static_cast<float>(b)});
    };
    // Lists that are longer than the mesh are cut: nothing of them can be right.
    const std::size_t most = 3 * mesh.triangles.size() + mesh.positions.size();
    const auto first = [&](const auto& list) { return std::span(list).first(std::min(list.size(), most)); };
    // A mesh begins, unless nothing was found: where it has no faults, a list of nothing is no event.
    if (!faults.crowded_edges.empty() || !faults.lonely_vertices.empty() || !faults.torn_vertices.empty())
        row(0, static_cast<std::uint32_t>(mesh.positions.size()), static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const glm::uvec2& edge : first(faults.crowded_edges)) row(1, edge.x, edge.y);
    for (const std::uint32_t vertex : first(faults.lonely_vertices)) row(2, vertex, vertex);
    for (const std::uint32_t vertex : first(faults.torn_vertices)) row(3, vertex, vertex);
}

/// Wound coherently, or nothing: then all rows are absent.
void record_coherent(Recorder& out, const IndexedMesh& mesh)
{
    out.columns("triangles", corner_names);
    const auto triangles = ask<coherent_triangles>(out, mesh);
    out.append("possible", triangles.has_value());
    out.append("triangles", triangles ? std::optional(glm::vec3(static_cast<float>(triangles->size()))) : std::nullopt);
    record_triangles(out, "triangles", triangles.value_or(std::vector<glm::uvec3>{}), mesh.triangles.size());
}

/// The corners of the triangles, numbered in the order in which they are first met, and where they lie. Which group got
/// the copy is free.
void record_separated(Recorder& out, const IndexedMesh& mesh)
{
    const IndexedMesh result = ask<separated>(out, mesh);
    std::map<std::uint32_t, float> numbers;
    out.columns("sizes", "vertices, triangles");
    out.append("sizes",
               glm::vec2(static_cast<float>(result.positions.size()), static_cast<float>(result.triangles.size())));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::vec3 row(std::nanf(""));
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = i < result.triangles.size() ? result.triangles[i][k] : 4294967295U;
            const bool exists = vertex < result.positions.size();
            if (exists) row[k] = numbers.try_emplace(vertex, static_cast<float>(numbers.size())).first->second;
            out.append("corners", exists ? result.positions[vertex] : glm::vec3(std::nanf("")));
        }
        out.append("triangles", row);
    }
}

/// Two meshes after each other in random order: one that can be wound coherently, and one that cannot. Of no triangles
/// there is a winding: the empty one. Two pairs of three have further pieces, so that one piece says nothing of the
/// mesh.
void record_windings(Variation& vary, Random& random, Recorder& out)
{
    std::vector<IndexedMesh> good{hourglass(5),    staircase(2),    staircase(4),   book(3),
                                  three_sheets(1), three_sheets(3), three_sheets(4)};
    for (const Sample& sample : tame_meshes(vary)) good.push_back(sample.mesh);
    good.insert(good.end(), {IndexedMesh{}, with_lonely_vertices({}, 1), with_lonely_vertices({}, 4)});
    good = in_random_order(random, std::move(good));
    const std::vector<IndexedMesh> bad =
        in_random_order(random, std::vector{moebius(9), moebius(8, 3), klein_bottle(6, 5), projective_plane(),
                                            joined(octahedron(), moebius(5), {3, 0, 0})});
    const auto record_pair = [&](const IndexedMesh& one, const IndexedMesh& other) {
        const bool swapped = random.below(2) == 1;
        for (const bool is_first : {!swapped, swapped})
            record_coherent(out, with_mixed_winding(resized(is_first ? one : other, random), random));
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
        const auto of_pieces = [&](const IndexedMesh& mesh) {
            return shuffled(i % 3 == 0 || mesh.triangles.empty() ? mesh : with_other_pieces(mesh, random), random);
        };
        const IndexedMesh possible = of_pieces(good[i]);
        record_pair(possible, of_pieces(bad[i % bad.size()]));
    }
    record_pair(with_far_copy(octahedron()), moebius(7));
    record_pair(with_large_indices(torus(9 + random.below(3), 7), random),
                with_large_indices(klein_bottle(9, 7 + random.below(3)), random));
}

void record_outward(Recorder& out, const IndexedMesh& mesh)
{
    out.columns("triangles", corner_names);
    const std::vector<glm::uvec3> triangles = ask<outward_triangles>(out, mesh);
    out.append("triangles", glm::vec3(static_cast<float>(triangles.size())));
    record_triangles(out, "triangles", triangles, mesh.triangles.size());
}

void record_far(Random& random, Recorder& out)
{
    for (const auto& [distance, step] : {std::pair(1e4, -10), {1e5, -7}, {1e6, -4}, {1e7, 0}})
        for (const IndexedMesh& body : {ball(8, 5), torus(7, 5), plate_with_holes(1), tetrahedron()})
            for (int i = 0; i < 4; ++i) record_outward(out, shuffled(far_body(body, distance, step, random), random));
    // Volumes that are no float: too small for one, or too large.
    for (const int exponent : {-60, 60})
        for (const IndexedMesh& body : {ball(8, 5), torus(7, 5), plate_with_holes(1), tetrahedron()})
            for (int i = 0; i < 2; ++i) {
                const IndexedMesh scaled = scaled_body(body, exponent);
                record_outward(out, shuffled(random.below(2) == 0 ? turned_over(scaled) : scaled, random));
            }
    for (int i = 0; i < 24; ++i) record_outward(out, bodies_far_apart(random));
    for (int i = 0; i < 8; ++i)
        for (const IndexedMesh& body : {ball(8, 5), torus(7, 5), plate_with_holes(1), tetrahedron()})
            record_outward(out, shuffled(thin_far_body(body, random), random));
}

Amount amount_of(std::vector<glm::uvec3> triangles)
{
    for (glm::uvec3& triangle : triangles) triangle = canonical(triangle);
    return Amount().in_any_order(triangles);
}

Amount amount_of(const ManifoldFaults& faults)
{
    return Amount()
        .in_any_order(faults.crowded_edges)
        .in_any_order(faults.lonely_vertices)
        .in_any_order(faults.torn_vertices);
}

/// Which group keeps a vertex, and which gets a copy, is free. `mesh` is not the one that the unit got, but equal to
/// that as it was.
Amount amount_of(const IndexedMesh& result, const IndexedMesh& mesh)
{
    std::size_t right = 0;
    for (std::size_t i = 0; i < std::min(result.triangles.size(), mesh.triangles.size()); ++i)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = result.triangles[i][k];
            if (vertex < result.positions.size() && result.positions[vertex] == mesh.positions[mesh.triangles[i][k]])
                ++right;
        }
    return Amount().count(result.positions.size()).count(result.triangles.size()).count(right);
}

void record_work(Random& random, Recorder& out)
{
    for (const char* name : {"faults", "coherent", "outward", "separated"})
        out.text(std::string(name) + ".names", "triangles");
    for (const std::uint32_t size : {10U, 15U, 22U, 33U}) {
        const IndexedMesh mesh = shuffled(joined(torus(2 * size, size), disc(2 * size * size), {3, 0, 0}), random);
        record_cost(out, "faults", mesh.triangles.size(), [&] { return amount_of(ask<manifold_faults>(out, mesh)); });
        record_cost(out, "coherent", mesh.triangles.size(),
                    [&] { return amount_of(ask<coherent_triangles>(out, mesh).value_or(std::vector<glm::uvec3>{})); });
        record_cost(out, "outward", mesh.triangles.size(),
                    [&] { return amount_of(ask<outward_triangles>(out, mesh)); });
        record_cost(out, "separated", mesh.triangles.size(),
                    [&] { return amount_of(ask<separated>(out, IndexedMesh(mesh)), mesh); });
    }
}

}

const Driver driver = {
    {"small",
     [](Case& c, Recorder& out) {
         out.text("faults.names", names_of_faults);
         for (const IndexedMesh& written : in_random_order(c.vary, small_suspects())) {
             Random* const random = c.vary.random();
             const IndexedMesh mesh = random != nullptr ? shuffled(resized(written, *random), *random) : written;
             record_faults(out, mesh);
             record_separated(out, mesh);
         }
     }},
    {"manifold",
     [](Case& c, Recorder& out) {
         out.text("faults.names", names_of_faults);
         for (const IndexedMesh& mesh : suspects(c.vary, c.random)) record_faults(out, mesh);
     }},
    {"coherent", [](Case& c, Recorder& out) { record_windings(c.vary, c.random, out); }},
    {"outward",
     [](Case& c, Recorder& out) {
         // The same in units of other sizes: no volume is a small one.
         for (const int exponent : {0, -10, 3, 0}) record_outward(out, crowd(c.random, exponent));
     }},
    {"one body",
     [](Case& c, Recorder& out) {
         for (const IndexedMesh& mesh : single_bodies(c.random)) record_outward(out, mesh);
     }},
    {"far from the origin", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"separated",
     [](Case& c, Recorder& out) {
         for (const IndexedMesh& mesh : suspects(c.vary, c.random)) record_separated(out, mesh);
         for (const IndexedMesh& mesh : {torus(9, 7), hourglass(20), staircase(4)})
             record_separated(out, with_large_indices(mesh, c.random));
     }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("sides", picture_of_sides(out, c.random)); }},
};

}
