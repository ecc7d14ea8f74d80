#include <map>
#include <string>
#include <umbral/meshes/edges.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../zoo.hpp"
#include "wireframe.hpp"

namespace umbral {
namespace {

using namespace meshes;
using EdgeTable = std::vector<glm::uvec2>(const IndexedMesh&);

/// Records tables of edges in a canonical order; rows are the mesh's number and two vertices.
class EdgeLog {
public:
    EdgeLog(Recorder& out, std::string name) : out_(&out), name_(std::move(name)) {}

    void add(const std::string& mesh_name, const IndexedMesh& mesh, EdgeTable* table)
    {
        names_ += std::to_string(++count_) + " " + mesh_name + ": edge\n";
        for (const glm::uvec2& edge : canonical(table(mesh), mesh))
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

void record_known(Recorder& out)
{
    EdgeLog any(out, "edges");
    EdgeLog closed(out, "edges of closed");
    for (const Sample& sample : tame_meshes()) {
        any.add(sample.name, sample.mesh, edge_table);
        if (is_closed(sample)) closed.add(sample.name, sample.mesh, edge_table_of_closed);
    }
    any.finish();
    closed.finish();
}

void record_any_winding(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const Sample& sample : tame_meshes())
        log.add(sample.name, with_mixed_winding(shuffled(sample.mesh, random), random), edge_table);
    log.add("hills", with_mixed_winding(shuffled(hills(9, 7, random), random), random), edge_table);
    log.finish();
}

void record_wild(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const Sample& sample : wild_meshes()) {
        IndexedMesh mesh = with_lonely_vertices(sample.mesh, 3);
        const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
        mesh.triangles.insert(mesh.triangles.end(), {{last, last, 0}, {1, last, 1}, {2, 2, 2}});
        log.add(sample.name, shuffled(mesh, random), edge_table);
    }
    log.finish();
}

void record_closed(Random& random, Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const Sample& sample : tame_meshes())
        if (is_closed(sample)) log.add(sample.name, shuffled(sample.mesh, random), edge_table_of_closed);
    log.add("two tori", shuffled(joined(torus(6, 5), torus(9, 4)), random), edge_table_of_closed);
    log.add("cubes at a corner", shuffled(cubes_at_a_corner(), random), edge_table_of_closed);
    log.finish();
}

void record_large_indices(Recorder& out)
{
    EdgeLog log(out, "edges");
    for (const std::uint32_t slices : {5U, 40U}) log.add("three cones", cones_with_large_indices(slices), edge_table);
    log.finish();
}

void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "triangles");
    out.text("blocks of closed.names", "triangles");
    for (const std::uint32_t side : {9U, 13U, 18U, 26U, 36U}) {
        const IndexedMesh mesh = shuffled(torus(side, side), random);
        const IndexedMesh mixed = with_mixed_winding(mesh, random);
        record_cost(out, "blocks", mesh.triangles.size(), [&] { (void)edge_table(mixed); });
        record_cost(out, "blocks of closed", mesh.triangles.size(), [&] { (void)edge_table_of_closed(mesh); });
    }
}

// A Moebius strip from the first function, a knot from the second.
Image draw_wireframes()
{
    Drawing drawing(600, 300, {-4.4, -2.2}, {4.4, 2.2});
    const auto tilted = [](const glm::vec3& p) {
        return 1.45F * glm::vec3(p.x, 0.8F * p.y - 0.6F * p.z, 0.6F * p.y + 0.8F * p.z);
    };
    const IndexedMesh strip = mapped(moebius(48, 5), tilted);
    draw_wireframe(drawing, strip, canonical(edge_table(strip), strip), {-2.35, 0}, 9, ink::orange, ink::red);
    const IndexedMesh knot = mapped(trefoil(54, 8, 0.5), [](const glm::vec3& p) { return 0.55F * p; });
    draw_wireframe(drawing, knot, canonical(edge_table_of_closed(knot), knot), {2.3, 0}, 9, ink::blue, ink::green);
    return drawing.picture();
}

}

const Driver driver = {
    {"known", [](Case&, Recorder& out) { record_known(out); }},
    {"any winding", [](Case& c, Recorder& out) { record_any_winding(c.random, out); }},
    {"odd meshes", [](Case& c, Recorder& out) { record_wild(c.random, out); }},
    {"closed", [](Case& c, Recorder& out) { record_closed(c.random, out); }},
    {"large indices", [](Case&, Recorder& out) { record_large_indices(out); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", draw_wireframes()); }},
};

}
