#include <kit/amount.hpp>
#include <kit/drawing.hpp>
#include <map>
#include <umbral/meshes/weld.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/not_finite.hpp>

#include "../show.hpp"
#include "soups.hpp"

namespace umbral {
namespace {

using namespace meshes;

/// Rows are the soup's number and a position, or three vertices; more rows than corners are never right.
class MeshLog {
public:
    explicit MeshLog(Recorder& out) : out_(&out) {}

    void add(const std::string& name, const Soup& soup)
    {
        ++count_;
        vertex_names_ += std::to_string(count_) + " " + name + ": vertex at\n";
        triangle_names_ += std::to_string(count_) + " " + name + ": triangle\n";
        const IndexedMesh mesh = ask<weld>(*out_, soup);
        const auto code = static_cast<float>(count_);
        for (std::size_t i = 0; i < std::min(mesh.positions.size(), soup.size() + 10); ++i) {
            const glm::vec3& p = mesh.positions[i];
            out_->append("vertices", std::array{code, recordable(p.x), recordable(p.y), recordable(p.z)});
        }
        for (std::size_t i = 0; i < std::min(mesh.triangles.size(), soup.size() + 10); ++i) {
            const glm::vec3 t(mesh.triangles[i]);
            out_->append("triangles", std::array{code, t.x, t.y, t.z});
        }
    }

    void finish() const
    {
        out_->text("vertices.names", vertex_names_);
        out_->text("triangles.names", triangle_names_);
    }

private:
    Recorder* out_;
    std::string vertex_names_;
    std::string triangle_names_;
    int count_ = 0;
};

void record_known(Variation& vary, Recorder& out)
{
    const ExactMap map = vary.exact_map();
    const auto placed = [&](Soup soup) {
        for (glm::vec3& corner : soup) corner = map.place(corner);
        return soup;
    };
    MeshLog log(out);
    log.add("nothing", {});
    log.add("two triangles", placed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}));
    log.add("a triangle twice", placed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
    log.add("triangles whose corners coincide",
            placed({{2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}));
    log.add("coordinates in another order", placed({{1, 2, 3}, {3, 2, 1}, {2, 3, 1}, {1, 3, 2}, {3, 1, 2}, {2, 1, 3}}));
    log.add("cube", placed(soup_of(shuffled(cube(), vary))));
    log.add("octahedron", placed(soup_of(shuffled(octahedron(), vary))));
    log.add("ball", placed(soup_of(shuffled(ball(8, 6), vary))));
    log.finish();
}

void record_random(Random& random, Recorder& out)
{
    MeshLog log(out);
    for (const Sample& sample : tame_meshes()) log.add(sample.name, soup_of(shuffled(sample.mesh, random)));
    log.add("hills", soup_of(shuffled(hills(9, 8, random), random)));
    log.add("corners at few places", soup_of_few_places(random));
    log.add("knot", soup_of(shuffled(trefoil(30, 5, 0.4), random)));
    // A triangle, the same one turned, and one that is hardly one: all of so many corners, some with zeros.
    const glm::vec3 place = random.in_cube();
    const glm::vec3 other(place.y, 0, place.x);
    log.add("one triangle", {place, other, {0, 0, place.z}});
    log.add("one triangle", {other, {0, 0, place.z}, place});
    log.add("one triangle", {{0, 0, 0}, place, {0, 0, 0}});
    log.add("one triangle", {other, other, place});
    log.finish();
}

template <Soup (*make)(Random&)>
void record_special(Case& c, Recorder& out)
{
    MeshLog log(out);
    for (int i = 0; i < 3; ++i) log.add(c.name, make(c.random));
    log.finish();
}

void record_isolated(Random& random, Recorder& out)
{
    for (const IndexedMesh& mesh :
         {IndexedMesh{}, with_lonely_vertices({}, 3), cube(), shuffled(torus(5, 4), random),
          with_lonely_vertices(hills(4, 3, random), 3), with_coinciding_corners(random), of_few_vertices(60, random),
          of_few_vertices(1, random), of_few_vertices(2, random), of_few_vertices(2, random)}) {
        const Soup soup = ask<isolated_triangles>(out, mesh);
        for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i)
            out.append("corners", i < soup.size() ? soup[i] : glm::vec3(0));
        out.append("sizes", static_cast<float>(soup.size()));
    }
}

std::uint64_t blocks_for(Recorder& out, const Soup& soup)
{
    const std::uint64_t before = blocks_executed();
    static_cast<void>(ask<weld>(out, soup));
    return blocks_executed() - before;
}

// Only the last triangles are recorded: the table tells whether the numbers of vertices are right to the end. Whoever
// compares each corner with all before would run out of time, and is not asked: four times the corners, linear work is
// four to five times as much, and theirs sixteen times.
void record_many_vertices(Random& random, Recorder& out)
{
    constexpr std::size_t count = 64;
    const Soup soup = soup_of_many_places(count, random);
    const std::uint64_t few = blocks_for(out, Soup(soup.begin(), soup.begin() + 900));
    const bool is_asked = blocks_for(out, Soup(soup.begin(), soup.begin() + 3600)) <= 10 * few;
    const IndexedMesh mesh = is_asked ? ask<weld>(out, soup) : IndexedMesh{};
    if (!is_asked) out.refused("last triangles", "not asked: comparing with all before would take too long");
    out.columns("last triangles", "first vertex, second, third");
    const std::size_t first = soup.size() / 3 - count;
    for (std::size_t i = first; i < first + count; ++i)
        out.append("last triangles", i < mesh.triangles.size() ? glm::vec3(mesh.triangles[i]) : glm::vec3(-1));
}

/// How many vertices there are, and how many corners of the triangles lie where they should. `soup` is not the one that
/// the unit got, but equal to that as it was.
Amount amount_of(const IndexedMesh& mesh, const Soup& soup)
{
    std::size_t right = 0;
    for (std::size_t i = 0; i < soup.size() && i / 3 < mesh.triangles.size(); ++i) {
        const std::uint32_t vertex = mesh.triangles[i / 3][static_cast<glm::length_t>(i % 3)];
        if (vertex < mesh.positions.size() && mesh.positions[vertex] == soup[i]) ++right;
    }
    return Amount().count(mesh.positions.size()).count(mesh.triangles.size()).count(right);
}

void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "corners");
    out.text("blocks in a diagonal plane.names", "corners");
    for (const std::uint32_t side : {13U, 19U, 26U, 37U, 52U}) {
        // Of any size: a grid that is fine enough for a model in metres holds all of one in kilometres in a cell.
        Soup soup = soup_of(shuffled(torus(side, side), random));
        for (glm::vec3& corner : soup) corner *= 0x1p-20F;
        record_cost(out, "blocks", soup.size(), [&] { return amount_of(ask<weld>(out, Soup(soup)), soup); });
        const Soup diagonal = aligned_soup(side * side, random);
        record_cost(out, "blocks in a diagonal plane", diagonal.size(),
                    [&] { return amount_of(ask<weld>(out, Soup(diagonal)), diagonal); });
    }
}

// Left: triangles before welding, drawn apart. Right: the welded mesh; the more triangles a vertex has, the larger and
// the warmer its disc.
Image draw_before_and_after(Variation& vary, Recorder& out)
{
    const Soup soup = soup_of(ball(vary.one_of(12U, std::array{9U, 10U, 14U}), vary.one_of(8U, std::array{6U, 7U})));
    Show show(2, 1, 300, 300);
    const Camera camera{{0, 2.3F, 5.2F}, {0, 0, 0}, 31};
    show.pane(0, 0, camera);
    IndexedMesh apart;
    std::vector<glm::vec3> colors;
    for (std::size_t i = 0; i + 2 < soup.size(); i += 3) {
        const glm::vec3 middle = (soup[i] + soup[i + 1] + soup[i + 2]) / 3.0F;
        const auto shifted = [&](const glm::vec3& corner) { return 1.12F * middle + 0.82F * (corner - middle); };
        add_triangle(apart, shifted(soup[i]), shifted(soup[i + 1]), shifted(soup[i + 2]));
        colors.push_back(glm::mix(ink::blue, ink::green, 0.5F + 0.5F * middle.y));
    }
    show.mesh(apart, colors, {0, ink::slate, 0.8F});

    show.pane(1, 0, camera);
    const IndexedMesh welded = ask<weld>(out, soup);
    show.mesh(welded, colors, {1.2F, {}, 0});
    std::map<int, std::vector<glm::vec3>> places;
    std::vector<int> uses(std::min(welded.positions.size(), soup.size()), 0);
    for (const glm::uvec3& t : welded.triangles)
        for (int corner = 0; corner < 3; ++corner)
            if (t[corner] < uses.size()) ++uses[t[corner]];
    for (std::size_t i = 0; i < uses.size(); ++i) places[std::min(uses[i], 12)].push_back(welded.positions[i]);
    for (const auto& [count, positions] : places)
        show.points(
            positions,
            glm::mix(ink::white, ink::orange, static_cast<float>(count) / 8 > 1 ? 1.0F : static_cast<float>(count) / 8),
            1.5F + 0.5F * static_cast<float>(count));
    return show.picture();
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"two zeros", record_special<soup_of_two_zeros>},
    {"close places", record_special<soup_of_close_places>},
    {"not a number", record_special<soup_of_broken_corners>},
    {"isolated", [](Case& c, Recorder& out) { record_isolated(c.random, out); }},
    {"many vertices", [](Case& c, Recorder& out) { record_many_vertices(c.random, out); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_before_and_after(c.vary, out)); }},
};

}
