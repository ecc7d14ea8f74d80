#include <kit/amount.hpp>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/meshes/normals.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "stage.hpp"

namespace umbral {
namespace {

using namespace meshes;

void record(Recorder& out, const IndexedMesh& mesh)
{
    for (const glm::vec3& normal : ask<face_normals>(out, mesh)) out.append("faces", normal);
    for (const glm::vec3& normal : ask<vertex_normals>(out, mesh)) out.append("vertices", normal);
}

// Behind so many other vertices, in one place, and so many triangles without area; nobody records either.
void record_behind_others(Recorder& out, IndexedMesh mesh, std::uint32_t vertices, std::size_t triangles)
{
    mesh.positions.insert(mesh.positions.begin(), vertices, glm::vec3(0));
    for (glm::uvec3& triangle : mesh.triangles) triangle += vertices;
    mesh.triangles.insert(mesh.triangles.begin(), triangles, glm::uvec3(0, 1, 2));
    const std::vector<glm::vec3> normals = ask<vertex_normals>(out, mesh);
    for (std::size_t i = vertices; i < normals.size(); ++i) out.append("vertices", normals[i]);
}

/// A mesh that is written down, longer or shorter along each axis, and its axes turned.
IndexedMesh varied(Variation& vary, const IndexedMesh& mesh)
{
    const ExactMap map = vary.exact_map(0);
    const glm::vec3 stretch(vary.scaled(1.0F, 1.5F), vary.scaled(1.0F, 1.5F), vary.scaled(1.0F, 1.5F));
    return mapped(mesh, [&](const glm::vec3& position) { return map.place(stretch * position); });
}

// Meshes whose normals a student can work out by hand.
void record_known(Variation& vary, Recorder& out)
{
    const auto record_varied = [&](const IndexedMesh& mesh) { record(out, varied(vary, mesh)); };
    record_varied({{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}});
    record_varied({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    // The pyramid of the statement: the four sides are unlike in size and meet the base at unlike angles.
    IndexedMesh pyramid{{{0, 0, 0}, {4, 0, 0}, {4, 0, -3}, {0, 0, -3}, {0, 2, 0}}, {}};
    add_quad(pyramid, {0, 3, 2, 1});
    pyramid.triangles.insert(pyramid.triangles.end(), {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    record_varied(pyramid);
    // The sides of a cube are cut into triangles along a diagonal: its corners see three, four, five or six of them.
    IndexedMesh cube;
    for (const float z : {0.0F, 1.0F})
        for (const float y : {0.0F, 1.0F})
            for (const float x : {0.0F, 1.0F}) cube.positions.emplace_back(x, y, z);
    for (const glm::uvec4& side :
         {glm::uvec4(4, 5, 7, 6), {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}})
        add_quad(cube, side);
    record_varied(cube);
}

/// Adds so many triangles round one vertex, the fan's peak, in any order. They go round it once for every fifty, so
/// that few are slivers.
void add_fan(IndexedMesh& mesh, std::uint32_t count, Random& random)
{
    IndexedMesh fan{{{0, 1, 0}}, {}};
    for (std::uint32_t i = 0; i <= count; ++i) {
        const double angle = 6.283185307179586 * i / 50;
        const double out = 1 + random.uniform_double();
        fan.positions.emplace_back(out * std::sin(angle), 0.5 * random.uniform_double(), out * std::cos(angle));
    }
    turn(fan, random);
    const auto peak = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), fan.positions.begin(), fan.positions.end());
    for (std::uint32_t i = 1; i <= count; ++i) fan.triangles.emplace_back(peak, peak + i, peak + i + 1);
    fan.triangles = in_random_order(random, std::move(fan.triangles));
    begin_anywhere(fan, random);
    mesh.triangles.insert(mesh.triangles.end(), fan.triangles.begin(), fan.triangles.end());
}

// Vertices with hundreds of triangles, in most cases as many as no byte counts. The others of their triangles are as
// elsewhere, and nobody records them.
void record_peaks(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        IndexedMesh mesh;
        std::vector<std::size_t> peaks;
        for (const std::uint32_t count : {i % 2 == 0 ? 512 : 200 + random.below(300), 256U, 256U, 256U}) {
            peaks.push_back(mesh.positions.size());
            add_fan(mesh, count, random);
        }
        const std::vector<glm::vec3> normals = ask<vertex_normals>(out, mesh);
        for (const std::size_t peak : peaks)
            if (peak < normals.size()) out.append("vertices", normals[peak]);
    }
}

/// Some triangles twice: they count twice, whether the two follow each other or not.
void repeat_some(IndexedMesh& mesh, Random& random)
{
    std::vector<glm::uvec3> all;
    for (const glm::uvec3& triangle : mesh.triangles) {
        all.push_back(triangle);
        if (random.below(6) == 0) all.push_back(triangle);
        if (random.below(12) == 0) all.push_back(mesh.triangles.front());
    }
    mesh.triangles = std::move(all);
}

void record_random(Random& random, Variation& vary, Recorder& out)
{
    for (int i = 0; i < 5; ++i) {
        IndexedMesh mesh = hills(12, 9, random);
        turn(mesh, random);
        begin_anywhere(mesh, random);
        if (i % 2 == 1) repeat_some(mesh, random);
        record(out, mesh);
    }
    record(out, varied(vary, trefoil(40, 7, 0.4)));
}

// In a case of their own, where the many small meshes do not outnumber them.
void record_many(Random& random, Recorder& out)
{
    // More than 16 bits count, of the one and of the other: both together would take whoever searches too long.
    record_behind_others(out, hills(12, 9, random), 70'000, 0);
    record_behind_others(out, hills(12, 9, random), 3, 70'000);
    record_peaks(random, out);
}

// The places of a sheet's vertices are multiples of 1/64, so that degenerate triangles are exactly degenerate in any
// arithmetic.
IndexedMesh sheet_on_grid(Random& random)
{
    return mapped(hills(6, 6, random), [](const glm::vec3& position) { return round(64.0F * position) / 64.0F; });
}

void record_degenerate(Random& random, Recorder& out)
{
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();

    record(out, {{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {1, 0, 0}}, {{0, 1, 2}, {0, 3, 2}}});  // corners on one line
    record(out, {{{1, 2, 3}, {1, 2, 3}, {4, 5, 7}, {0, 0, 1}}, {{0, 1, 2}, {1, 3, 2}}});  // two corners in one place
    record(out, {{{1, 2, 3}, {4, 5, 7}, {0, 0, 1}}, {{0, 0, 1}, {1, 1, 1}, {2, 0, 1}}});  // one corner twice
    record(out, {{{1, 2, 3}, {4, 5, 6}}, {}});                                            // no triangles
    record(out, {{{1, 2, 3}}, {}});
    record(out, {});  // nothing at all

    record(out, sharp_folds(1e-7, 12, random));  // two normals cancel, but for less than counts

    for (int i = 0; i < 4; ++i) {
        IndexedMesh mesh = sheet_on_grid(random);
        const auto count = static_cast<std::uint32_t>(mesh.positions.size());
        const auto some = [&] { return random.below(count); };
        for (int k = 0; k < 12; ++k) {
            const std::uint32_t repeated = some();
            mesh.triangles.emplace_back(repeated, some(), repeated);
        }
        // Vertices of no triangle, a vertex in the place of another one, and a needle along an edge.
        mesh.positions.insert(mesh.positions.end(),
                              {{9, 9, 9}, {-1, 2, 0}, mesh.positions[7], 2.0F * mesh.positions[1] - mesh.positions[0]});
        mesh.triangles.insert(mesh.triangles.end(), {{7, count + 2, 20}, {0, 1, count + 3}});
        // A sheet with a front and a back: all normals of a vertex cancel.
        const IndexedMesh front = sheet_on_grid(random);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), front.positions.begin(), front.positions.end());
        for (const glm::uvec3& t : front.triangles)
            mesh.triangles.insert(mesh.triangles.end(),
                                  {{first + t.x, first + t.y, first + t.z}, {first + t.y, first + t.x, first + t.z}});
        record(out, mesh);

        // A broken vertex spoils its triangles, and no others.
        IndexedMesh broken = sheet_on_grid(random);
        broken.positions[random.below(count)][i % 3] = not_a_number;
        broken.positions[random.below(count)][(i + 1) % 3] = i % 2 == 0 ? infinity : -infinity;
        begin_anywhere(broken, random);
        record(out, broken);
    }
}

// Triangles whose corners lie on a grid, and whose edges are so nearly parallel that their sine is 1e-6 to 1e-8; for
// most below 1e-7. No difference is rounded, and in double no product.
IndexedMesh grid_slivers(int count, Random& random)
{
    IndexedMesh mesh;
    for (int i = 0; i < count; ++i) {
        // The parallelogram of b and c keeps its area, 1, while they grow.
        glm::vec2 b(1, 0);
        glm::vec2 c(0, 1);
        while (dot(b, b) * dot(c, c) < (i % 4 == 0 ? 0x1p40F : 0x1p46F)) {
            b += static_cast<float>(1 + random.below(2)) * c;
            c += static_cast<float>(1 + random.below(2)) * b;
        }
        const glm::vec3 corner(glm::round(0x1p11F * random.in_cube()));
        const glm::vec2 slope(random.below(3), random.below(3));
        const int axis = static_cast<int>(random.below(3));
        const auto placed = [&](const glm::vec2& p) {
            glm::vec3 place;
            place[axis] = p.x;
            place[(axis + 1) % 3] = p.y;
            place[(axis + 2) % 3] = dot(slope, p);
            return 0x1p-11F * (corner + place);
        };
        add_triangle(mesh, placed({0, 0}), placed(b), placed(c));
    }
    return mesh;
}

// Sharp folds along whose edge stand many more triangles, each with its own back, so that nothing of them is left in
// the sum: it is far shorter than their number says, and still longer than 1e-6.
IndexedMesh crowded_folds(int count, Random& random)
{
    IndexedMesh mesh = sharp_folds(2e-5, count, random);
    const std::vector<glm::uvec3> folds = mesh.triangles;
    for (std::size_t i = 0; i < folds.size(); i += 2)
        for (int k = 0; k < 15; ++k)
            mesh.triangles.insert(mesh.triangles.end(), {folds[i], {folds[i].y, folds[i].x, folds[i].z}});
    return mesh;
}

// Edges that are nearly parallel.
void record_slivers(Random& random, Recorder& out)
{
    for (const double sine : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        IndexedMesh slivers = sliver_triangles(sine, 100, random);
        begin_anywhere(slivers, random);
        for (const glm::vec3& normal : ask<face_normals>(out, slivers)) out.append("faces", normal);
    }
    for (const glm::vec3& normal : ask<face_normals>(out, grid_slivers(200, random))) out.append("faces", normal);
}

// Folds that are nearly closed: the normal of the edge is what is left when two normals nearly cancel.
void record_folds(Random& random, Recorder& out)
{
    for (const double angle : {1e-1, 1e-2, 1e-3, 1e-4, 2e-5})
        for (const glm::vec3& normal : ask<vertex_normals>(out, sharp_folds(angle, 50, random)))
            out.append("vertices", normal);
    for (const glm::vec3& normal : ask<vertex_normals>(out, crowded_folds(50, random))) out.append("vertices", normal);
}

void record_scales(Random& random, Recorder& out)
{
    for (const float scale : {1e-35F, 1e-30F, 1e-20F, 1e-12F, 1e10F, 1e18F, 1e25F, 1e36F}) {
        IndexedMesh mesh = hills(5, 5, random);
        turn(mesh, random);
        record(out, mapped(mesh, [&](const glm::vec3& position) { return scale * position; }));
    }
}

// Cells of about 10 units, a million units from the origin, where floats lie 1/16 apart.
void record_far(Random& random, Recorder& out)
{
    for (int i = 0; i < 4; ++i) {
        IndexedMesh mesh = hills(8, 8, random);
        turn(mesh, random);
        const glm::vec3 away = 1e6F * random.unit_vector();
        record(out, mapped(mesh, [&](const glm::vec3& position) { return away + 10.0F * position; }));
    }
}

void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "triangles");
    for (const std::uint32_t side : {8U, 11U, 16U, 22U, 32U}) {
        IndexedMesh mesh = hills(side, side, random);
        add_fan(mesh, static_cast<std::uint32_t>(mesh.triangles.size()), random);  // half of them round one vertex
        record_cost(out, "blocks", mesh.triangles.size(), [&] {
            const std::vector<glm::vec3> faces = ask<face_normals>(out, mesh);
            return Amount().in_order(faces).in_order(ask<vertex_normals>(out, mesh));
        });
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, c.vary, out); }},
    {"many", [](Case& c, Recorder& out) { record_many(c.random, out); }},
    {"degenerate", [](Case& c, Recorder& out) { record_degenerate(c.random, out); }},
    {"slivers", [](Case& c, Recorder& out) { record_slivers(c.random, out); }},
    {"sharp folds", [](Case& c, Recorder& out) { record_folds(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_scales(c.random, out); }},
    {"far from the origin", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"picture",
     [](Case& c, Recorder& out) {
         const IndexedMesh knot = varied(c.vary, trefoil(72, 8, 0.55));
         const shapes::Shape left = flat(knot, ask<face_normals>(out, knot));
         const shapes::Shape right = smooth(knot, ask<vertex_normals>(out, knot));
         out.image("colours", draw_side_by_side(left, right));
     }},
};

}
