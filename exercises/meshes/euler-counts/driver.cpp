#include <kit/varied.hpp>
#include <umbral/meshes/euler.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../zoo.hpp"
#include "gallery.hpp"

namespace umbral {
namespace {

using namespace meshes;

void append(Recorder& out, std::string_view name, std::initializer_list<int> numbers)
{
    std::vector<float> row;
    for (const int number : numbers) row.push_back(static_cast<float>(number));
    out.append(name, row);
}

void record_counts(Recorder& out, const IndexedMesh& mesh)
{
    const TopologyCounts counts = ask<count_topology>(out, mesh);
    append(out, "elements", {counts.vertices, counts.isolated_vertices, counts.edges, counts.faces});
    append(out, "boundary", {counts.boundary_edges, counts.boundary_loops});
    append(out, "pieces", {counts.components, counts.non_manifold_edges});
}

void record_genus(Recorder& out, const IndexedMesh& mesh)
{
    const std::optional<int> handles = ask<genus>(out, mesh);
    out.append("genus", handles ? std::optional<float>(static_cast<float>(*handles)) : std::nullopt);
}

// Two or three meshes side by side, in an order that says nothing.
IndexedMesh mixture(const std::vector<Sample>& meshes, Random& random)
{
    IndexedMesh mesh;
    for (std::uint32_t parts = 2 + random.below(2); parts > 0; --parts)
        mesh = joined(mesh, meshes[random.below(static_cast<std::uint32_t>(meshes.size()))].mesh);
    return shuffled(with_lonely_vertices(mesh, static_cast<int>(random.below(4))), random);
}

// One triangle comes twice, the second time right behind the first, from the same corner or another one.
IndexedMesh with_one_twice(IndexedMesh mesh, Random& random)
{
    if (mesh.triangles.empty()) return mesh;
    const auto first = mesh.triangles.begin() + random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
    const glm::uvec3 t = *first;
    mesh.triangles.insert(first + 1, random.below(2) == 0 ? t : glm::uvec3(t.y, t.z, t.x));
    return mesh;
}

void record_random(Random& random, Recorder& out)
{
    const std::vector<Sample> tame = tame_meshes();
    const std::vector<Sample> wild = wild_meshes();
    for (int i = 0; i < 40; ++i) {
        const IndexedMesh mesh = with_mixed_winding(mixture(i % 2 == 0 ? tame : wild, random), random);
        record_counts(out, i % 4 < 2 ? mesh : with_one_twice(mesh, random));
    }
}

// Two meshes that share one vertex of each, wherever these lie: inside, or on a rim.
IndexedMesh glued(const IndexedMesh& first, const IndexedMesh& second, Random& random)
{
    IndexedMesh mesh = joined(first, second);
    const auto here = random.below(static_cast<std::uint32_t>(first.positions.size()));
    const auto there = static_cast<std::uint32_t>(first.positions.size()) +
                       random.below(static_cast<std::uint32_t>(second.positions.size()));
    for (glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            if (t[corner] == there) t[corner] = here;
    return mesh;
}

// A closed surface, with a rim where a triangle was.
IndexedMesh opened(IndexedMesh mesh, Random& random)
{
    mesh.triangles.erase(mesh.triangles.begin() + random.below(static_cast<std::uint32_t>(mesh.triangles.size())));
    return mesh;
}

// In pairs: a surface that has a genus, and one that has none for a single reason.
void record_genera(Random& random, Recorder& out)
{
    std::vector<Sample> tame = tame_meshes();
    tame.push_back({"torus with a hole", opened(torus(6, 4), random)});
    tame.push_back({"plate with two holes, cut open", opened(plate_with_holes(2), random)});
    for (std::uint32_t round = 0; round < 4; ++round) {
        const std::vector<IndexedMesh> without = {moebius(5 + round),  klein_bottle(4 + round, 5),
                                                  projective_plane(),  book(3 + round),
                                                  bow_tie(),           cubes_at_an_edge(),
                                                  cubes_at_a_corner(), with_mixed_winding(torus(6 + round, 5), random)};
        const auto record_pair = [&](const IndexedMesh& mesh) {
            const IndexedMesh other = mixture(tame, random);
            const bool first = random.below(2) == 1;
            record_genus(out, first ? other : mesh);
            record_genus(out, first ? mesh : other);
        };
        for (const IndexedMesh& mesh : without) record_pair(shuffled(mesh, random));
        record_pair(with_one_twice(mixture(tame, random), random));
        for (int i = 0; i < 4; ++i) {
            const IndexedMesh closed = i % 2 == 0 ? ball(5, 4) : cube();
            const IndexedMesh open = i < 2 ? disc(6 + round) : flat_sheet(3, 3);
            record_pair(shuffled(glued(closed, open, random), random));
        }
    }
}

void record_degenerate(Random& random, Variation& vary, Recorder& out)
{
    // A vertex that only a triangle that is no face has is isolated; whoever counts its edges finds some that are not
    // there.
    for (const Sample& sample : in_random_order(vary, tame_meshes(vary))) {
        IndexedMesh mesh = with_lonely_vertices(sample.mesh, 2);
        const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
        mesh.triangles.insert(mesh.triangles.begin(), {{0, last, last}, {1, 0, 1}, {2, 2, 2}});
        mesh = shuffled(mesh, random);
        std::vector<IndexedMesh> pair{mesh};
        // Nothing but triangles that are no faces, but vertices, or nothing at all.
        mesh.triangles.resize(0);
        switch (random.below(3)) {
            case 0: mesh = {}; break;
            case 1: mesh.triangles = {{0, last, last}, {1, 0, 1}, {2, 2, 2}}; break;
            default: break;
        }
        pair.push_back(mesh);
        for (const IndexedMesh& one : in_random_order(random, pair)) {
            record_counts(out, one);
            record_genus(out, one);
        }
    }
}

void record_sphere(Recorder& out, const std::optional<ElementCounts>& counts)
{
    for (const auto member : {&ElementCounts::vertices, &ElementCounts::edges, &ElementCounts::faces})
        out.append("counts", counts ? std::optional<float>(static_cast<float>((*counts).*member)) : std::nullopt);
}

void record_spheres(Variation& vary, Recorder& out)
{
    std::vector<std::int64_t> numbers{-6, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 13, 20, 30, 36, 41, 999, 30'000};
    for (std::int64_t& number : numbers)
        if (number > 9) number = vary.near(number, number / 4);
    for (const std::int64_t number : in_random_order(vary, numbers)) {
        record_sphere(out, ask<sphere_from_vertices>(out, number));
        record_sphere(out, ask<sphere_from_edges>(out, number));
        record_sphere(out, ask<sphere_from_faces>(out, number));
    }
    // Powers of two and their like are exact in float; in 32 bits three times as many do not fit.
    const int bits = vary.one_of(40, std::array{38, 39, 41, 42});
    record_sphere(out, ask<sphere_from_vertices>(out, (std::int64_t{1} << bits) + 2));
    record_sphere(out, ask<sphere_from_edges>(out, std::int64_t{3} << bits));
    record_sphere(out, ask<sphere_from_faces>(out, std::int64_t{2} << bits));
    // These cannot be told from their neighbours in double.
    constexpr std::int64_t most = 1'000'000'000'000'000'000;
    record_sphere(out, ask<sphere_from_vertices>(out, most));
    record_sphere(out, ask<sphere_from_edges>(out, most));
    record_sphere(out, ask<sphere_from_edges>(out, most - 1));
    record_sphere(out, ask<sphere_from_faces>(out, most));
    record_sphere(out, ask<sphere_from_faces>(out, most - 1));
}

void record_work(Recorder& out)
{
    out.text("blocks.names", "triangles");
    for (const std::uint32_t side : {9U, 13U, 18U, 26U, 36U}) {
        const IndexedMesh mesh = torus(side, side);
        record_cost(out, "blocks", mesh.triangles.size(), [&] {
            const TopologyCounts counts = ask<count_topology>(out, mesh);
            const std::optional<int> handles = ask<genus>(out, mesh);
            return std::vector<float>{static_cast<float>(counts.vertices), static_cast<float>(counts.edges),
                                      static_cast<float>(counts.faces), static_cast<float>(counts.components),
                                      static_cast<float>(handles.value_or(-1))};
        });
    }
}

/// The course's PLY file: its six quadrilaterals cut into fans.
IndexedMesh course_example()
{
    IndexedMesh mesh{
        {{0, 0, 0}, {0, 0, 2}, {0, 1.3F, 1}, {0, 1.4F, 0}, {1.1F, 0, 0}, {1, 0, 2}, {1, 0.8F, 1.5F}, {0.5F, 1, 0}}, {}};
    for (const glm::uvec4& face :
         {glm::uvec4(0, 1, 2, 3), {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
        add_quad(mesh, face);
    return mesh;
}

void record_known(Variation& vary, Recorder& out)
{
    std::vector<Sample> samples = tame_meshes(vary);
    samples.insert(samples.begin(), {"the course's example", course_example()});
    for (const Sample& sample : in_random_order(vary, samples)) {
        record_counts(out, sample.mesh);
        record_genus(out, sample.mesh);
    }
    // 26 vertices and 48 triangles have either: sizes do not tell them apart, and with other inputs one stands in the
    // other's place.
    const bool is_ball = vary.one_of(0, std::array{1}) == 1;
    const IndexedMesh one_of_both = is_ball ? ball(6, 5) : with_lonely_vertices(torus(6, 4), 2);
    record_counts(out, one_of_both);
    record_genus(out, one_of_both);
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"sphere", [](Case& c, Recorder& out) { record_spheres(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"genus", [](Case& c, Recorder& out) { record_genera(c.random, out); }},
    {"no faces", [](Case& c, Recorder& out) { record_degenerate(c.random, c.vary, out); }},
    {"large indices",
     [](Case& c, Recorder& out) {
         for (const std::uint32_t slices : {3U, 8U, 60U}) {
             const auto others = std::array{slices + 1, slices + 2, slices + 3};
             record_counts(out, cones_with_large_indices(c.vary.one_of(slices, others)));
         }
         record_counts(out, spread(tube(c.vary.near(9U, 2U), 7), 100'000, c.random));
     }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_gallery(out, c.vary)); }},
};

}
