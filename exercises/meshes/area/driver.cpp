#include <algorithm>
#include <array>
#include <cmath>
#include <kit/numbers_changed.hpp>
#include <limits>
#include <umbral/meshes/area.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../zoo.hpp"
#include "degenerate.hpp"
#include "diagram.hpp"
#include "large_meshes.hpp"

namespace umbral {
namespace {

using namespace meshes;

void record_triangles(Recorder& out, const IndexedMesh& mesh)
{
    for (const glm::uvec3& t : mesh.triangles)
        out.append("triangles", ask<triangle_area>(out, mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
}

void record(Recorder& out, const IndexedMesh& mesh)
{
    record_triangles(out, mesh);
    out.append("meshes", ask<surface_area>(out, mesh));
}

// The course's example of a PLY file, each quadrilateral cut from its first corner.
IndexedMesh course_example()
{
    IndexedMesh mesh{
        {{0, 0, 0}, {0, 0, 2}, {0, 1.3F, 1}, {0, 1.4F, 0}, {1.1F, 0, 0}, {1, 0, 2}, {1, 0.8F, 1.5F}, {0.5F, 1, 0}}, {}};
    for (const glm::uvec4& side :
         {glm::uvec4(0, 1, 2, 3), {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
        add_quad(mesh, side);
    return mesh;
}

/// A mesh that is written down, longer or shorter along each axis.
IndexedMesh varied(Variation& vary, const IndexedMesh& mesh)
{
    const glm::vec3 stretch(vary.scaled(1.0F, 1.5F), vary.scaled(1.0F, 1.5F), vary.scaled(1.0F, 1.5F));
    return mapped(mesh, [&](const glm::vec3& position) { return stretch * position; });
}

void record_known(Variation& vary, Recorder& out)
{
    const auto record_varied = [&](const IndexedMesh& mesh) { record(out, varied(vary, mesh)); };
    record_varied({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
    record_varied({{{1, 1, 1}, {1, 3, 1}, {1, 1, 6}, {9, 9, 9}}, {{0, 1, 2}, {2, 1, 0}}});
    record_varied(cube_surface({{0, 0, 0}}));
    record_varied(tetrahedron());
    record_varied(octahedron());
    record_varied(flat_sheet(4, 3));
    record_varied(course_example());
}

/// Each triangle that is drawn comes again, from either side: whoever counts a triangle once has too little.
IndexedMesh with_some_twice(IndexedMesh mesh, Random& random)
{
    for (std::size_t left = mesh.triangles.size() / 20; left > 0; --left) {
        const glm::uvec3 t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
        mesh.triangles.push_back(random.below(2) == 0 ? t : glm::uvec3(t.y, t.x, t.z));
    }
    return mesh;
}

using Corners = std::array<glm::vec3, 3>;

/// No sliver: its area is a fifth of the square of its longest side at least, so that float is right by far.
bool is_broad(const Corners& corners)
{
    float longest = 0;
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, distance(corners[i], corners[(i + 1) % 3]));
    return longest > 0.3F && length(cross(corners[1] - corners[0], corners[2] - corners[0])) > 0.4F * longest * longest;
}

/// Triangles that differ from the one before in one number, which may be 0 or equal another one; meshes of one, two and
/// three triangles; the same places with other triangles, and other places for the same ones.
void record_changed(Random& random, Recorder& out)
{
    for (int i = 0; i < 16; ++i) {
        IndexedMesh mesh{{{-1, -0.6F, 0}, {1, -0.6F, 0}, {0, 1, 0}, 3.0F * random.in_cube()}, {{0, 1, 2}}};
        turn(mesh, random);
        const glm::vec3 away = random.in_cube();
        const auto corner = [&](std::size_t which) { return mesh.positions[which] + away; };
        for (const Corners& corners : numbers_changed(random, Corners{corner(0), corner(1), corner(2)}, 4, is_broad)) {
            std::ranges::copy(corners, mesh.positions.begin());
            record(out, mesh);
        }
        mesh.triangles.emplace_back(0, 2, 1);
        out.append("meshes", ask<surface_area>(out, mesh));
        mesh.triangles.emplace_back(2, 1, 0);
        out.append("meshes", ask<surface_area>(out, mesh));
        mesh.positions = {corner(1), corner(1), corner(2), corner(0)};
        mesh.triangles = {{0, 2, 3}};
        out.append("meshes", ask<surface_area>(out, mesh));
        mesh.triangles = {{2, 3, 1}, {0, 1, 2}};
        out.append("meshes", ask<surface_area>(out, mesh));
    }
}

// From small units to large ones, powers of two, though none in which the square of an area leaves float's range.
void record_random(Random& random, Variation& vary, Recorder& out)
{
    for (int i = 0; i < 8; ++i) {
        IndexedMesh mesh = with_some_twice(hills(9, 7, random), random);
        turn(mesh, random);
        const float unit = std::exp2(static_cast<float>(6 * i - 24 + static_cast<int>(random.below(7))));
        record(out, mapped(shuffled(mesh, random), [&](const glm::vec3& position) { return unit * position; }));
    }
    record(out, varied(vary, trefoil(30, 7, 0.4)));
    record_changed(random, out);
}

void record_degenerate(Random& random, Recorder& out)
{
    for (int i = 0; i < 16; ++i) record(out, degenerate_mesh(i, random));
    out.append("meshes", ask<surface_area>(out, IndexedMesh{}));
    out.append("meshes", ask<surface_area>(out, IndexedMesh{{{1, 2, 3}}, {}}));
}

void record_slivers(Random& random, Recorder& out)
{
    for (const double sine : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) record_triangles(out, sliver_triangles(sine, 100, random));
    record_triangles(out, thin_triangles(70, random));
}

void record_scales(Random& random, Recorder& out)
{
    for (const float scale : {1e-21F, 1e-20F, 1e-17F, 1e-15F, 1e-12F, 1e-10F, 1e10F, 1e13F, 1e15F, 1e17F, 1e17F}) {
        IndexedMesh mesh = hills(5, 5, random);
        turn(mesh, random);
        const glm::vec3 away = std::pow(10.0F, random.uniform(0, 3.5F)) * random.unit_vector();
        mesh = mapped(mesh, [&](const glm::vec3& position) { return scale * (position + away); });
        // The smallest areas are subnormal: a sum of such floats may have lost digits.
        record_triangles(out, mesh);
        if (scale > 1e-18F) out.append("meshes", ask<surface_area>(out, mesh));
    }
    record_triangles(out, triangles_next_to_the_largest_float(50, random));
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

// Hills, and the same ones three times as large: coordinates and areas round anew.
void record_enlarged(Random& random, Recorder& out)
{
    IndexedMesh mesh = hills(9, 7, random);
    turn(mesh, random);
    const IndexedMesh large = mapped(mesh, [](const glm::vec3& position) { return 3.0F * position; });
    for (const glm::uvec3& t : mesh.triangles) {
        out.append("as it is", ask<triangle_area>(out, mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
        out.append("enlarged",
                   ask<triangle_area>(out, large.positions[t.x], large.positions[t.y], large.positions[t.z]));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, c.vary, out); }},
    {"degenerate", [](Case& c, Recorder& out) { record_degenerate(c.random, out); }},
    {"slivers", [](Case& c, Recorder& out) { record_slivers(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_scales(c.random, out); }},
    {"far from the origin", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"a million triangles",
     [](Case& c, Recorder& out) {
         out.append("meshes", ask<surface_area>(out, varied(c.vary, torus(500, 1000))));
         out.append("meshes", ask<surface_area>(out, varied(c.vary, sheet_after_a_square(400))));
         out.append("meshes", ask<surface_area>(out, sheet_of_all_sizes(400, c.random)));
     }},
    {"laws", [](Case& c, Recorder& out) { record_enlarged(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_diagram(out, c.vary)); }},
};

}
