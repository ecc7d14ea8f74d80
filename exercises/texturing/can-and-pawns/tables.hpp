#pragma once

#include <kit/canonical.hpp>
#include <set>
#include <umbral/record/cost.hpp>

#include "plain.hpp"

/// Cases of rubric lines 1 and 3: tables of numbers.
namespace umbral::texturing {

// Rubric 1: tables of normals.

inline void record_normals(Recorder& out, const meshes::IndexedMesh& mesh)
{
    const NormalTables tables = ask<normals_of>(out, mesh);
    record_rows(out, "faces", tables.faces, mesh.triangles.size());
    record_rows(out, "vertices", tables.vertices, mesh.positions.size());
}

inline void normals(Case& c, Recorder& out)
{
    meshes::IndexedMesh other_corner_first = cube();
    for (glm::uvec3& triangle : other_corner_first.triangles) triangle = {triangle.y, triangle.z, triangle.x};
    const meshes::IndexedMesh corner = {{{0, 0, 0}, {2, 0, 0}, {2, 0, -3}, {0, 0, -3}, {0, 4, 0}},
                                        {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
    for (const meshes::IndexedMesh& mesh : {tetrahedron(), cube(), other_corner_first, corner})
        record_normals(out, turned(c.vary, mesh));
}

inline void random_normals(Case& c, Recorder& out)
{
    for (int i = 0; i < 6; ++i) record_normals(out, patch(c.random, 4 + i, 0.5F * static_cast<float>(1 + i * i)));
}

/// Three triangles that share an edge, 120° apart, one as far out as it likes. The unit normals cancel at both ends of
/// the edge, but for roundings: in float, too, their sum is shorter than 10⁻⁶, and as good as never 0.
inline meshes::IndexedMesh three_fins(Random& random)
{
    meshes::IndexedMesh mesh{{{0, 0, 0}, {0, 0, random.uniform(0.5F, 2)}}, {}};
    const double first = random.uniform(0, 6.2F);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const double angle = first + i * 2 * std::numbers::pi / 3;
        const double out = random.uniform(0.5F, 2);
        mesh.positions.emplace_back(out * std::cos(angle), out * std::sin(angle), 0);
        mesh.triangles.emplace_back(0, 1, 2 + i);
    }
    return mesh;
}

inline void odd_normals(Case& c, Recorder& out)
{
    record_normals(out, turned(c.vary, with_degenerate_ones()));
    record_normals(out, {});
    for (int i = 0; i < 6; ++i) record_normals(out, turned(c.vary, three_fins(c.random)));
    meshes::IndexedMesh small = turned(c.vary, cube());
    meshes::IndexedMesh large = turned(c.vary, cube());
    // Products of edges far below 10⁻¹², whose squares are numbers that a float still holds.
    for (glm::vec3& place : small.positions) place *= std::ldexp(1.0F, -24);
    for (glm::vec3& place : large.positions) place *= 1e6F;
    record_normals(out, small);
    record_normals(out, large);
}

inline void cost_of_normals(Case& c, Recorder& out)
{
    for (const int size : {16, 32, 64}) {
        const meshes::IndexedMesh mesh = patch(c.random, size);
        record_cost(out, "normals", mesh.triangles.size(), [&] { (void)ask<normals_of>(out, mesh); });
    }
}

inline constexpr const char* names_of_triangles = "-1 how many: vertices, coordinates, -\n1 triangle\n";

// Rubric 3: coordinates of surfaces of revolution.

/// Those of a surface's triangles that must be there: those without area may be, or not.
inline std::vector<glm::uvec3> with_area(const Revolved& surface, const profiles::Profile& profile)
{
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : surface.mesh.triangles) {
        const auto point = [&](std::uint32_t vertex) { return profile[vertex % profile.size()]; };
        const auto on_axis = [&](std::uint32_t a, std::uint32_t b) { return point(a) == point(b) && point(a).x == 0; };
        const bool along = point(t.x) == point(t.y) && point(t.y) == point(t.z);
        if (!along && !on_axis(t.x, t.y) && !on_axis(t.y, t.z) && !on_axis(t.z, t.x)) triangles.push_back(t);
    }
    return triangles;
}

inline void record_sizes(Recorder& out, const Revolved& surface)
{
    out.append("triangles", std::vector<float>{-1, static_cast<float>(surface.mesh.positions.size()),
                                               static_cast<float>(surface.coordinates.size()), 0});
}

inline void record_surface(Recorder& out, const profiles::Profile& profile, std::uint32_t copies)
{
    const Revolved surface = ask<revolve>(out, profile, copies);
    const std::size_t count = profile.size() * copies;
    record_rows(out, "places", surface.mesh.positions, count);
    record_rows(out, "coordinates", surface.coordinates, count);
    record_sizes(out, surface);
    record_indices(out, "triangles", 1, with_area(surface, profile), 2 * count);
}

/// Of a surface with more vertices than 16 bits count: the triangles whose first vertex is one of a few.
inline void record_large_surface(Recorder& out, Random& random, const profiles::Profile& profile)
{
    const std::uint32_t copies = 131'072 / static_cast<std::uint32_t>(profile.size()) + 100 + random.below(100);
    std::set<std::uint32_t> some;
    for (int i = 0; i < 1000; ++i) some.insert(random.below(copies * static_cast<std::uint32_t>(profile.size())));
    const Revolved surface = ask<revolve>(out, profile, copies);
    record_sizes(out, surface);
    std::vector<glm::uvec3> triangles = with_area(surface, profile);
    std::erase_if(triangles, [&](const glm::uvec3& t) { return !some.contains(canonical(t).x); });
    record_indices(out, "triangles", 1, triangles, 2 * some.size());
}

inline profiles::Profile random_profile(Random& random, std::uint32_t points)
{
    profiles::Profile profile{{random.uniform(0.5F, 2), 0}};
    while (profile.size() < points) {
        const float right = random.uniform(-1, 1);
        const float up = random.uniform(0.05F, 1.5F);
        const bool twice = random.below(6) == 0;
        profile.push_back(twice ? profile.back()
                                : glm::vec2(std::abs(profile.back().x + right) + 0.1F, profile.back().y + up));
    }
    profile.emplace_back(random.below(2) == 0 ? 0.0F : 1.0F, profile.back().y + 0.5F);
    return profile;
}

/// Surfaces whose coordinates follow without a calculator. Varied, they are higher or lower, and of more copies.
inline void known_surfaces(Case& c, Recorder& out)
{
    out.text("triangles.names", names_of_triangles);
    const auto record = [&](profiles::Profile profile, std::uint32_t copies) {
        const float height = c.vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.5F, 2.0F});
        for (glm::vec2& point : profile) point.y *= height;
        record_surface(out, profile, copies + c.vary.one_of(0U, std::array{1U, 2U, 3U}));
    };
    record({{2, 0}, {2, 3}, {1, 3}}, 5);
    record({{1, 0}, {1, 1}, {1, 4}, {4, 8}}, 4);
    record({{0, -1}, {1, -1}, {1, 1}, {0, 1}}, 9);
    record(profiles::can_top(), 7);
}

/// Three sizes of tables, each with three profiles: what is kept by its size is that of another one.
inline void random_surfaces(Case& c, Recorder& out)
{
    out.text("triangles.names", names_of_triangles);
    for (std::uint32_t size = 0; size < 3; ++size) {
        const std::uint32_t copies = 4 + c.random.below(12);
        const std::uint32_t points = 2 + 3 * size + c.random.below(3);
        for (int i = 0; i < 3; ++i) record_surface(out, random_profile(c.random, points), copies);
    }
    record_large_surface(out, c.random, random_profile(c.random, 10));
}

}
