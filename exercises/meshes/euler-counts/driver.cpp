#include <kit/varied.hpp>
#include <umbral/meshes/euler.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../zoo.hpp"
#include "gallery.hpp"
#include "mixtures.hpp"

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

void name_counts(Recorder& out)
{
    out.columns("elements", "vertices, isolated vertices, edges, faces");
    out.columns("boundary", "boundary edges, boundary loops");
    out.columns("pieces", "components, edges of three faces or more");
}

void record_genus(Recorder& out, const IndexedMesh& mesh)
{
    const std::optional<int> handles = ask<genus>(out, mesh);
    out.append("genus", handles ? std::optional<float>(static_cast<float>(*handles)) : std::nullopt);
}

void record_random(Random& random, Recorder& out)
{
    std::vector<Sample> tame = tame_meshes();
    std::vector<Sample> wild = wild_meshes();
    for (const Sample& sample : with_several_rims())
        for (std::vector<Sample>* const samples : {&tame, &wild}) samples->push_back(sample);
    for (int i = 0; i < 40; ++i) {
        const IndexedMesh mesh = with_mixed_winding(mixture(i % 2 == 0 ? tame : wild, random), random);
        record_counts(out, i % 4 < 2 ? mesh : with_one_twice(mesh, random));
    }
    name_counts(out);
}

// In pairs: a surface that has a genus, and one that has none for a single reason. In every second round both have as
// many triangles, though other counts.
void record_genera(Random& random, Recorder& out)
{
    std::vector<Sample> tame = tame_meshes();
    tame.push_back({"torus with a hole", opened(torus(6, 4), random)});
    tame.push_back({"plate with two holes, cut open", opened(plate_with_holes(2), random)});
    tame.push_back({"pillow", pillow(true)});
    for (const Sample& sample : with_several_rims()) tame.push_back(sample);
    for (std::uint32_t round = 0; round < 4; ++round) {
        const std::vector<IndexedMesh> without = {moebius(5 + round),  klein_bottle(4 + round, 5),
                                                  projective_plane(),  book(3 + round),
                                                  bow_tie(),           cubes_at_an_edge(),
                                                  cubes_at_a_corner(), with_mixed_winding(torus(6 + round, 5), random)};
        const auto record_both = [&](const IndexedMesh& mesh, const IndexedMesh& other) {
            const bool first = random.below(2) == 1;
            record_genus(out, first ? other : mesh);
            record_genus(out, first ? mesh : other);
        };
        const auto record_pair = [&](IndexedMesh mesh) {
            IndexedMesh other = mixture(tame, random);
            if (round % 2 == 1) pad_to_equal_size(mesh, other);
            record_both(mesh, other);
        };
        for (const IndexedMesh& mesh : without) record_pair(another(mesh, random));
        record_pair(with_one_twice(mixture(tame, random), random));
        for (int i = 0; i < 4; ++i) {
            const IndexedMesh closed = i % 2 == 0 ? ball(5, 4) : cube();
            const IndexedMesh open = i < 2 ? disc(6 + round) : flat_sheet(3, 3);
            record_pair(another(glued(closed, open, random), random));
        }
        for (const bool is_alone : {true, false}) {
            IndexedMesh beside = is_alone ? IndexedMesh{} : mixture(tame, random);
            beside = with_lonely_vertices(std::move(beside), static_cast<int>(random.below(60)));
            record_both(another(joined(beside, pillow(false)), random), another(joined(beside, pillow(true)), random));
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
        mesh = another(mesh, random);
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
    name_counts(out);
}

// A double does not hold numbers of 18 digits, but their billions and the rest: where the question is so large, these
// are two values instead of one.
template <auto from>
void record_sphere(Recorder& out, std::int64_t number)
{
    constexpr std::int64_t billion = 1'000'000'000;
    const std::optional<ElementCounts> counts = ask<from>(out, number);
    const auto append = [&](const char* name, auto part) {
        out.append(name,
                   counts ? std::optional(glm::dvec3(part(counts->vertices), part(counts->edges), part(counts->faces)))
                          : std::nullopt);
    };
    if (number < billion) return append("counts", [](std::int64_t count) { return count; });
    append("billions", [](std::int64_t count) { return count / billion; });
    append("last nine digits", [](std::int64_t count) { return count % billion; });
}

void record_spheres(Variation& vary, Recorder& out)
{
    std::vector<std::int64_t> numbers{-6, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 13, 20, 30, 36, 41, 999, 30'000};
    for (std::int64_t& number : numbers) {
        if (number > 9 && vary) number += 40 + vary.near<std::int64_t>(5000, 4999);
        if (number < 0) number = vary.near<std::int64_t>(number, -number - 1);
    }
    for (const std::int64_t number : in_random_order(vary, numbers)) {
        record_sphere<sphere_from_vertices>(out, number);
        record_sphere<sphere_from_edges>(out, number);
        record_sphere<sphere_from_faces>(out, number);
    }
    // Powers of two and their like are exact in float; in 32 bits three times as many do not fit.
    const int bits = vary.one_of(40, std::array{38, 39, 41, 42});
    record_sphere<sphere_from_vertices>(out, (std::int64_t{1} << bits) + 2);
    record_sphere<sphere_from_edges>(out, std::int64_t{3} << bits);
    record_sphere<sphere_from_faces>(out, std::int64_t{2} << bits);
    // These cannot be told from their neighbours in double.
    constexpr std::int64_t most = 1'000'000'000'000'000'000;
    const std::int64_t less = vary.near(std::int64_t{500}, std::int64_t{400});
    record_sphere<sphere_from_vertices>(out, most);
    record_sphere<sphere_from_vertices>(out, most - 1);
    record_sphere<sphere_from_vertices>(out, most / 7 - less);
    record_sphere<sphere_from_edges>(out, most / 7 * 3 - 3 * less);
    record_sphere<sphere_from_faces>(out, most / 7 * 2 - 2 * less);
    record_sphere<sphere_from_edges>(out, most);
    record_sphere<sphere_from_edges>(out, most - 1);
    record_sphere<sphere_from_faces>(out, most);
    record_sphere<sphere_from_faces>(out, most - 1);
    for (const char* name : {"counts", "billions", "last nine digits"}) out.columns(name, "vertices, edges, faces");
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
    samples.insert(samples.end(), {{"pillow", pillow(true)},
                                   {"sheet with holes", pierced_sheet(vary.one_of(2U, std::array{1U, 3U}))},
                                   {"pieces that share a vertex", bow_tie()},
                                   {"cubes that share a vertex", cubes_at_a_corner()},
                                   {"three faces at an edge", book(3)},
                                   {"four faces at an edge", book(4)}});
    for (const Sample& sample : in_random_order(vary, samples)) {
        Random* const random = vary.random();
        const IndexedMesh mesh = random != nullptr ? another(sample.mesh, *random) : sample.mesh;
        record_counts(out, mesh);
        record_genus(out, mesh);
    }
    // 26 vertices and 48 triangles have either: sizes do not tell them apart, and with other inputs one stands in the
    // other's place.
    const bool is_ball = vary.one_of(0, std::array{1}) == 1;
    IndexedMesh one_of_both = is_ball ? ball(6, 5) : with_lonely_vertices(torus(6, 4), 2);
    if (Random* const random = vary.random()) one_of_both = another(one_of_both, *random);
    record_counts(out, one_of_both);
    record_genus(out, one_of_both);
    name_counts(out);
}

void record_large_indices(Random& random, Variation& vary, Recorder& out)
{
    for (const std::uint32_t slices : {3U, 8U, 60U}) {
        const auto others = std::array{slices + 1, slices + 2, slices + 3};
        record_counts(out, cones_with_large_indices(vary.one_of(slices, others)));
    }
    record_counts(out, spread(tube(vary.near(9U, 2U), 7), 100'000, random));
    name_counts(out);
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"sphere", [](Case& c, Recorder& out) { record_spheres(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"genus", [](Case& c, Recorder& out) { record_genera(c.random, out); }},
    {"no faces", [](Case& c, Recorder& out) { record_degenerate(c.random, c.vary, out); }},
    {"large indices", [](Case& c, Recorder& out) { record_large_indices(c.random, c.vary, out); }},
    {"a million vertices",
     [](Case& c, Recorder& out) {
         record_counts(out, another(disc(c.vary.near(20U, 9U)), c.random));
         record_counts(out, million(tube(c.vary.near(19U, 9U), 4), c.random));
         record_counts(out, another(flat_sheet(c.vary.near(20U, 9U), 2), c.random));
         name_counts(out);
     }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_gallery(out, c.vary)); }},
};

}
