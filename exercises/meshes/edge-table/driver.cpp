#include <kit/amount.hpp>
#include <kit/varied.hpp>
#include <map>
#include <string>
#include <umbral/meshes/edges.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../zoo.hpp"
#include "large_indices.hpp"
#include "wireframe.hpp"

namespace umbral {
namespace {

using namespace meshes;

/// Records tables of edges in a canonical order; rows are the mesh's number and two vertices.
class EdgeLog {
public:
    EdgeLog(Recorder& out, std::string name) : out_(&out), name_(std::move(name)) {}

    template <auto table>
    void add(const std::string& mesh_name, const IndexedMesh& mesh)
    {
        names_ += std::to_string(++count_) + " " + mesh_name + ": edge from, to\n";
        for (const glm::uvec2& edge : canonical(ask<table>(*out_, mesh), mesh))
            out_->append(
                name_, std::array{static_cast<float>(count_), static_cast<float>(edge.x), static_cast<float>(edge.y)});
    }

    void finish() const { out_->text(name_ + ".names", names_); }

private:
    Recorder* out_;
    std::string name_;
    std::string names_;
    int count_ = 0;
};

bool is_closed(const Sample& sample)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const glm::uvec3& t : sample.mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) ++sides[std::minmax(t[corner], t[(corner + 1) % 3])];
    return std::ranges::all_of(sides, [](const auto& side) { return side.second == 2; });
}

/// Tame meshes, and two that have vertices in one place: those of an edge, and those of two sides that are folded onto
/// each other. Small ones first.
std::vector<Sample> known_meshes(Variation& vary)
{
    std::vector<Sample> samples = tame_meshes(vary);
    samples.push_back({"corners in one place", tetrahedron()});
    samples.back().mesh.positions[0] = samples.back().mesh.positions[1 + vary.near(1, 1)];
    samples.push_back({"folded sheet", flat_sheet(2, vary.near(2U, 1U))});
    for (glm::vec3& position : samples.back().mesh.positions) position.x = std::abs(position.x);
    std::ranges::stable_sort(samples, {}, [](const Sample& sample) { return sample.mesh.triangles.size(); });
    return samples;
}

void record_known(Variation& vary, Recorder& out)
{
    EdgeLog any(out, "edges");
    EdgeLog closed(out, "edges of closed");
    for (const Sample& sample : in_random_order(vary, known_meshes(vary))) {
        const IndexedMesh mesh = shuffled(sample.mesh, vary);
        any.add<edge_table>(sample.name, mesh);
        if (is_closed(sample)) closed.add<edge_table_of_closed>(sample.name, mesh);
    }
    any.add<edge_table>("disc of many", disc(vary.near(40U, 8U)));  // the middle is the smallest vertex
    any.add<edge_table>("nothing", {});
    closed.add<edge_table_of_closed>("nothing", {});
    any.finish();
    closed.finish();
}

/// One vertex in three lies where another does, as along the seam of a texture: they are two all the same.
IndexedMesh with_seams(IndexedMesh mesh, Random& random)
{
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i + 2 < count; i += 3) mesh.positions[i] = mesh.positions[random.below(count)];
    return mesh;
}

void record_any_winding(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const Sample& sample : tame_meshes())
        log.add<edge_table>(sample.name, with_mixed_winding(with_seams(shuffled(sample.mesh, random), random), random));
    log.add<edge_table>("hills", with_mixed_winding(shuffled(hills(9, 7, random), random), random));
    log.finish();
}

void record_wild(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    // Short questions: one triangle, and one that is none, behind it or before.
    const auto v = in_random_order(random, std::vector<std::uint32_t>{0, 1, 2, 3});
    const glm::uvec3 one(v[0], v[1], v[2]);
    for (const glm::uvec3& none : {glm::uvec3(v[0], v[3], v[0]), {v[1], v[1], v[3]}, {v[3], v[2], v[2]}}) {
        log.add<edge_table>("two triangles, the second is none", {tetrahedron().positions, {one, none}});
        log.add<edge_table>("two triangles, the first is none", {tetrahedron().positions, {none, one}});
    }
    for (const Sample& sample : wild_meshes()) {
        IndexedMesh mesh = with_lonely_vertices(sample.mesh, 3);
        const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
        mesh.triangles.insert(mesh.triangles.end(), {{last, last, 0}, {1, last, 1}, {2, 2, 2}});
        log.add<edge_table>(sample.name, shuffled(mesh, random));
    }
    log.finish();
}

void record_closed(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const Sample& sample : tame_meshes())
        if (is_closed(sample))
            log.add<edge_table_of_closed>(sample.name, with_seams(shuffled(sample.mesh, random), random));
    log.add<edge_table_of_closed>("two tori", shuffled(joined(torus(6, 5), torus(9, 4)), random));
    log.add<edge_table_of_closed>("cubes at a corner", shuffled(cubes_at_a_corner(), random));
    log.finish();
}

void record_large_indices(Case& c, Recorder& out)
{
    EdgeLog log(out, "edges");
    log.add<edge_table>("three cones", cones_with_large_indices(c.vary.near(40U, 9U)));
    for (const std::uint32_t factor : {1000U, 1024U, 4096U, 5000U, 10'000U, 16'384U, 65'536U, 100'000U, 131'072U}) {
        log.add<edge_table>("discs, factor " + std::to_string(factor), discs_with_equal_keys(factor, c.vary));
    }
    log.add<edge_table>("more than 32 bits", equal_keys_in_32_bits(c.vary, c.random));
    log.finish();
    EdgeLog closed(out, "edges of closed");
    closed.add<edge_table_of_closed>("tetrahedra, numbers 65,536 apart", tetrahedra_in_16_bits(20, c.random));
    closed.add<edge_table_of_closed>("ring, numbers 65,536 apart", spread(torus(9, 7), 65'536, c.random));
    closed.add<edge_table_of_closed>("ball, numbers 40,000 apart", spread(ball(9, 6), 40'000, c.random));
    closed.finish();
}

void record_large_mesh(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    const IndexedMesh mesh = shuffled(torus(70, 60), random);
    log.add<edge_table>("torus of 8400 triangles", with_mixed_winding(mesh, random));
    log.add<edge_table>("disc of hundreds", disc(260 + random.below(60)));  // more than 8 bits count
    log.finish();
    EdgeLog closed(out, "edges of closed");
    closed.add<edge_table_of_closed>("torus of 8400 triangles", mesh);
    closed.finish();
}

Amount amount_of(std::vector<glm::uvec2> edges)
{
    for (glm::uvec2& edge : edges) edge = {std::min(edge.x, edge.y), std::max(edge.x, edge.y)};
    return Amount().in_any_order(edges);
}

void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "triangles");
    out.text("blocks of closed.names", "triangles");
    for (const std::uint32_t side : {9U, 13U, 18U, 26U, 36U}) {
        const IndexedMesh mesh = shuffled(torus(side, side), random);
        const IndexedMesh mixed = with_mixed_winding(mesh, random);
        record_cost(out, "blocks", mesh.triangles.size(), [&] { return amount_of(ask<edge_table>(out, mixed)); });
        record_cost(out, "blocks of closed", mesh.triangles.size(),
                    [&] { return amount_of(ask<edge_table_of_closed>(out, mesh)); });
    }
}

// The second function asks nothing of vertices, and needs no memory but its result. A row is the number of edges, and
// how many pieces of memory were held at once: a vector that grows holds two, and up to three are as good as none.
void record_closed_alone(Variation& vary, Recorder& out)
{
    out.text("blocks.names", "vertices");
    for (const int vertices : {600, 1800, 5400, 16'200}) {
        const IndexedMesh mesh = with_lonely_vertices(torus(12, 10), vertices - 120);
        record_cost(out, "blocks", mesh.positions.size(),
                    [&] { return amount_of(ask<edge_table_of_closed>(out, mesh)); });
    }
    constexpr std::int64_t free_pieces = 3;
    out.text("edges and memory.names", "edges, pieces of memory");
    for (const std::uint32_t side : {5U, 8U, 12U, 17U, 23U, 30U}) {
        const IndexedMesh mesh = torus(vary.one_of(side, std::array{side + 1, side + 2, side + 4}), side);
        const AllocationCount memory;
        const std::vector<glm::uvec2> edges = ask<edge_table_of_closed>(out, mesh);
        out.append("edges and memory", glm::vec2(edges.size(), std::max(memory.most(), free_pieces)));
    }
}

// A Moebius strip from the first function, a knot from the second.
Image draw_wireframes(Variation& vary, Recorder& out)
{
    Drawing drawing(600, 300, {-4.4, -2.2}, {4.4, 2.2});
    const auto tilted = [](const glm::vec3& p) {
        return 1.45F * glm::vec3(p.x, 0.8F * p.y - 0.6F * p.z, 0.6F * p.y + 0.8F * p.z);
    };
    const IndexedMesh strip = mapped(moebius(vary.one_of(48U, std::array{36U, 40U, 43U}), 5), tilted);
    draw_wireframe(drawing, strip, canonical(ask<edge_table>(out, strip), strip), {-2.35, 0}, 9, ink::orange, ink::red);
    const IndexedMesh knot = mapped(trefoil(vary.one_of(54U, std::array{44U, 48U, 60U}), 8, 0.5),
                                    [](const glm::vec3& p) { return 0.55F * p; });
    draw_wireframe(drawing, knot, canonical(ask<edge_table_of_closed>(out, knot), knot), {2.3, 0}, 9, ink::blue,
                   ink::green);
    return drawing.picture();
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"any winding", [](Case& c, Recorder& out) { record_any_winding(c.random, out); }},
    {"odd meshes", [](Case& c, Recorder& out) { record_wild(c.random, out); }},
    {"closed", [](Case& c, Recorder& out) { record_closed(c.random, out); }},
    {"large indices", [](Case& c, Recorder& out) { record_large_indices(c, out); }},
    {"large mesh", [](Case& c, Recorder& out) { record_large_mesh(c.random, out); }},
    {"closed alone", [](Case& c, Recorder& out) { record_closed_alone(c.vary, out); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_wireframes(c.vary, out)); }},
};

}
