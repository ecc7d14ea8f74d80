#include <kit/magnitude.hpp>
#include <kit/numbers_changed.hpp>
#include <kit/refusal.hpp>
#include <kit/row_of.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "scene.hpp"
#include "triangles.hpp"

namespace umbral {
namespace {

using namespace texturing;

void record_sphere(Recorder& out, const std::vector<glm::vec3>& points)
{
    for (const glm::vec3& point : points) out.append("sphere", ask<spherical_coordinates>(out, point));
}

void record_triangles(Recorder& out, const std::vector<Corners>& triangles)
{
    out.columns("corners", "u, v");
    for (const Corners& corners : triangles)
        for (const glm::vec2& at : ask<spherical_triangle>(out, corners)) out.append("corners", at);
}

// A plane through a point, with any two perpendicular unit axes.
TexturePlane random_plane(Random& random, float reach)
{
    const glm::vec3 u_axis = random.unit_vector();
    const glm::vec3 other = std::abs(u_axis.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 side = normalize(cross(u_axis, other));
    const float angle = random.uniform(0, 2 * pi);
    const glm::vec3 v_axis = std::cos(angle) * side + std::sin(angle) * cross(u_axis, side);
    return {reach * random.in_cube(), u_axis, v_axis};
}

// In any direction, at least a degree off the seam and the axis.
glm::vec3 random_point(Random& random)
{
    const float longitude = random.uniform(-3.12F, 3.12F);
    return random.uniform(0.2F, 5) * at_angles(longitude, random.uniform(-1.55F, 1.55F));
}

// Numbers that a hand can work out. Varied, points are moved: along the axis where there is one.
void by_hand(Variation& vary, Recorder& out)
{
    const auto risen = [&](const glm::vec3& point) { return point + glm::vec3(0, vary.near(0.0F, 0.7F), 0); };
    for (const TexturePlane& plane : {TexturePlane{}, {{1, 2, 3}, {0, 0.6F, 0.8F}, {1, 0, 0}}})
        for (const glm::vec3& point : {glm::vec3(0.25F, 0.5F, 7), {-3, 1, 0}, {1, 2, 3}, {2, 7, 13}})
            out.append("plane",
                       ask<planar_coordinates>(out, point + glm::vec3(vary.near(glm::ivec3(0), 8)) / 4.0F, plane));
    for (const glm::vec3& point : {glm::vec3(1, 0, 0),
                                   {0, 0, 1},
                                   {0, 0, -1},
                                   {1, 1, 0},
                                   {0, -2, 2},
                                   {3, 0, 3},
                                   {-1, 0, 1},
                                   {-1, 0, -1},
                                   {0, 3, -3}})
        record_sphere(out, {risen(point)});
    for (const glm::vec3& point : {glm::vec3(2, 1, 0), {0, 1.5F, 2}, {0, 4, -1}, {-1, 2.5F, 1}, {1, -1, 1}, {3, 6, -3}})
        out.append("cylinder", ask<cylindrical_coordinates>(out, risen(point), 1, 4));
    for (const glm::vec3& point : {glm::vec3(2, 1, 0), {0, 2.5F, -1}, {1, 5, 1}})
        out.append("cylinder", ask<cylindrical_coordinates>(out, risen(point), 4, 1));
    record_triangles(out, mirrored(vary, triangles_by_hand()));
}

// Off the axis and the seam by a degree at least; in front, z may be 0.
bool is_clear(const glm::vec3& p)
{
    const float flat = length(glm::vec2(p.x, p.z));
    return flat > 0.03F * std::abs(p.y) && flat > 0.01F && (p.x > 0 || std::abs(p.z) > 0.03F * -p.x);
}

// What random planes, points and heights are not: 0, equal, or alone in being another than in the call before.
void record_changed(Random& random, Recorder& out)
{
    using OnPlane = std::pair<glm::vec3, TexturePlane>;
    const OnPlane first(2.0F * random.in_cube(), random_plane(random, 2));
    const auto same_axes = [&](const OnPlane& q) {
        return q.second.u_axis == first.second.u_axis && q.second.v_axis == first.second.v_axis;
    };
    OnPlane on_plane;
    for (const OnPlane& changed : numbers_changed(random, first, 4, same_axes)) {
        out.append("plane", ask<planar_coordinates>(out, changed.first, changed.second));
        on_plane = changed;
    }
    auto& [point, plane] = on_plane;
    plane.u_axis = -plane.u_axis;
    out.append("plane", ask<planar_coordinates>(out, point, plane));
    plane.v_axis = -plane.v_axis;
    out.append("plane", ask<planar_coordinates>(out, point, plane));
    // Axes as floors and walls have them, and one axis kept while the other changes.
    const std::uint32_t way = random.below(3);
    for (std::uint32_t next = 1; next < 3; ++next) {
        plane.u_axis = plane.v_axis = glm::vec3(0);
        plane.u_axis[static_cast<glm::length_t>(way)] = random.below(2) == 0 ? 1.0F : -1.0F;
        plane.v_axis[static_cast<glm::length_t>((way + next) % 3)] = 1;
        out.append("plane", ask<planar_coordinates>(out, point, plane));
    }

    for (const glm::vec3& p : numbers_changed(random, random_point(random), 3, is_clear)) record_sphere(out, {p});

    using Ring = std::tuple<glm::vec3, float, float>;
    const Ring ring(random_point(random), random.uniform(0.6F, 2), random.uniform(-2, 0.4F));
    const auto is_tall = [](const Ring& r) {
        return is_clear(std::get<0>(r)) && std::abs(std::get<1>(r) - std::get<2>(r)) > 0.2F;
    };
    for (const auto& [p, one, other] : numbers_changed(random, ring, 5, is_tall)) {
        out.append("cylinder", ask<cylindrical_coordinates>(out, p, one, other));
        out.append("cylinder", ask<cylindrical_coordinates>(out, p, other, one));
    }
}

void random_points(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) record_changed(random, out);
    for (int i = 0; i < 400; ++i) {
        const TexturePlane plane = random_plane(random, 3);
        out.append("plane", ask<planar_coordinates>(out, 3.0F * random.in_cube(), plane));
    }
    for (int i = 0; i < 400; ++i) record_sphere(out, {random_point(random)});
    for (int i = 0; i < 400; ++i) {
        const float y_min = random.uniform(-4, 2);
        const float height = random.uniform(0.5F, 4) * (i % 8 == 0 ? -1.0F : 1.0F);
        glm::vec3 point = random_point(random);
        point.y = y_min + random.uniform(-0.5F, 1.5F) * height;
        out.append("cylinder", ask<cylindrical_coordinates>(out, point, y_min, y_min + height));
    }
}

// How many there are, then each pair, as long as there are as many as there should be.
void record_grid(Recorder& out, int columns, int rows)
{
    const std::vector<glm::vec2> grid = ask<parametric_coordinates>(out, columns, rows);
    out.append("sizes", static_cast<std::int32_t>(grid.size()));
    const std::size_t size = static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1);
    for (std::size_t i = 0; i < size; ++i) out.append("table", row_of(grid, i));
}

// More columns or rows than 16 bits count: how many pairs there are, and those at the ends of rows.
void record_long_grid(Recorder& out, int columns, int rows)
{
    const std::vector<glm::vec2> grid = ask<parametric_coordinates>(out, columns, rows);
    out.append("sizes", static_cast<std::int32_t>(grid.size()));
    const std::size_t row = static_cast<std::size_t>(columns) + 1;
    const std::size_t size = row * (static_cast<std::size_t>(rows) + 1);
    for (const std::size_t place : {std::size_t{1}, row - 1, row, size - row, size - 1})
        out.append("table", row_of(grid, place));
}

void grids(Random& random, Recorder& out)
{
    for (const glm::ivec2 size : {glm::ivec2(4, 2), {1, 1}, {1, 3}, {5, 1}, {49, 3}, {3, 49}})
        record_grid(out, size.x, size.y);
    record_grid(out, 2 + static_cast<int>(random.below(12)), 2 + static_cast<int>(random.below(12)));
    record_long_grid(out, 32'768 + static_cast<int>(random.below(60'000)), 1);
    record_long_grid(out, 1, 32'768 + static_cast<int>(random.below(60'000)));
    for (const glm::ivec2 size : {glm::ivec2(0, 3), {3, 0}, {0, 0}, {-2, 4}, {4, -1}, {-1, -1}}) {
        const bool good_first = random.below(2) == 0;
        for (const bool good : {good_first, !good_first})
            record_refusal(out, "refused", [&] {
                return good ? ask<parametric_coordinates>(out, 3, 2) : ask<parametric_coordinates>(out, size.x, size.y);
            });
    }
}

// Far from the seam, across it, and with a corner exactly on it.
void seam(Random& random, Recorder& out)
{
    std::vector<Corners> triangles;
    for (int i = 0; i < 120; ++i) {
        triangles.push_back(triangle_at(random, random.uniform(-1.6F, 1.6F)));
        const float longitude = pi + random.uniform(-0.4F, 0.4F);
        triangles.push_back(triangle_at(random, longitude));
        if (i % 4 == 0) {
            Corners touching = triangle_at(random, random.below(2) == 0 ? 1.65F : -1.65F);
            touching[random.below(3)] = {-random.uniform(0.5F, 2), random.uniform(-1, 1), zero_of_any_sign(random)};
            triangles.push_back(touching);
            triangles.push_back(half_turn_at_seam(random));
        }
    }
    change_balls(random, triangles);
    // Of these only one number differs from the triangle before, and two corners may be the same.
    for (int i = 0; i < 40; ++i) {
        Corners corners = triangle_at(random, random.uniform(0.6F, 1.4F) * pi);
        if (i % 4 == 0) corners[random.below(3)] = corners[random.below(3)];
        const auto changed = is_narrow(corners) ? numbers_changed(random, corners, 3, is_narrow) : std::vector{corners};
        triangles.insert(triangles.end(), changed.begin(), changed.end());
    }
    record_triangles(out, triangles);
}

// One corner on the axis, in the triangle's middle or at its end; two; all. Every other triangle lies near the seam.
void poles(Random& random, Recorder& out)
{
    std::vector<Corners> triangles;
    for (int i = 0; i < 80; ++i) {
        Corners corners = triangle_at(random, i % 2 == 0 ? random.uniform(-pi, pi) : pi + random.uniform(-0.4F, 0.4F));
        const std::uint32_t first = random.below(3);
        corners[first] = pole(random);
        if (i % 10 == 0) corners[(first + 1) % 3] = pole(random);
        triangles.push_back(corners);
    }
    for (int i = 0; i < 2; ++i) triangles.push_back({pole(random), pole(random), pole(random)});
    change_balls(random, triangles);
    record_triangles(out, triangles);
}

// Where atan2 has two answers or none, with each sign of zero; a cylinder without height.
void edges(Recorder& out)
{
    std::vector<glm::vec3> points;
    for (const float zero : {0.0F, -0.0F}) {
        for (const float other : {0.0F, -0.0F})
            for (const float y : {1.0F, -3.0F, 0.0F, -0.0F}) points.emplace_back(zero, y, other);
        for (const float y : {0.0F, 1.0F, -1.0F}) {
            points.emplace_back(-1, y, zero);
            points.emplace_back(2, y, zero);
            points.emplace_back(zero, y, 3);
        }
    }
    record_sphere(out, points);
    for (const glm::vec3& point : points) out.append("cylinder", ask<cylindrical_coordinates>(out, point, -1, 3));
    for (const float y : {2.0F, 1.0F, 3.0F}) out.append("cylinder", ask<cylindrical_coordinates>(out, {1, y, 1}, 2, 2));
}

// Point and plane far from the origin, and near each other: products of large numbers cancel.
void far_plane(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        TexturePlane plane = random_plane(random, 1e5F);
        const glm::vec3 point = plane.origin + random.in_cube();
        out.append("plane", ask<planar_coordinates>(out, point, plane));
    }
}

// Planes and points near them in very small and very large units of length: nothing is too near to count.
void plane_in_any_unit(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const TexturePlane plane = random_plane(random, 1);
        const float unit = random_unit(random, -100, 100);
        const float u = random.uniform(0.4F, 1) * (random.below(2) == 0 ? 1.0F : -1.0F);
        const glm::vec3 aside = random.uniform(-1, 1) * cross(plane.u_axis, plane.v_axis);
        const glm::vec3 point = plane.origin + u * plane.u_axis + random.uniform(-1, 1) * plane.v_axis + aside;
        out.append("plane", ask<planar_coordinates>(out, unit * point,
                                                    TexturePlane{unit * plane.origin, plane.u_axis, plane.v_axis}));
    }
}

// Sizes whose squares overflow or vanish in float, and latitudes where arc sine and arc cosine lose half the digits.
void extreme(Random& random, Recorder& out)
{
    plane_in_any_unit(random, out);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 point = random_point(random) * std::pow(10.0F, random.uniform(25, 37));
        const glm::vec3 speck = random_point(random) * std::pow(10.0F, random.uniform(-36, -25));
        const float off = std::pow(10.0F, random.uniform(-4, -1.7F));
        const float longitude = random.uniform(-3.12F, 3.12F);
        const glm::vec3 near_pole(off * std::cos(longitude), random.below(2) == 0 ? 1 : -1, off * std::sin(longitude));
        record_sphere(out, {point, speck, near_pole});
        Corners corners = triangle_at(random, random.uniform(-pi, pi));
        const std::uint32_t changed = random.below(3);
        if (i % 4 == 0)  // close to the axis, but not on it: its own longitude counts
            corners[changed] *= glm::vec3(off * 1e-3F, 1, off * 1e-3F);
        const float size = i % 4 < 2 ? 1.0F : std::pow(10.0F, random.uniform(-36, -25));
        for (glm::vec3& corner : corners) corner *= size;
        record_triangles(out, {corners});
        const float low = random.uniform(-3.3e38F, -2e38F);
        const float high = random.uniform(2e38F, 3.3e38F);
        const glm::vec3 tall(point.x, 3e38F * random.uniform(-1, 1), point.z);
        out.append("cylinder", ask<cylindrical_coordinates>(out, tall, low, high));
        // Thin ones have a height too.
        const float thin = std::pow(10.0F, i % 2 == 0 ? random.uniform(-30, -5) : random.uniform(-36, -28));
        const float bottom = thin * random.uniform(-4, 4);
        const glm::vec3 on_ring(corners[0].x, bottom + thin * random.uniform(0, 1), corners[0].z);
        out.append("cylinder", ask<cylindrical_coordinates>(out, on_ring, bottom, bottom + thin));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { random_points(c.random, out); }},
    {"grids", [](Case& c, Recorder& out) { grids(c.random, out); }},
    {"seam", [](Case& c, Recorder& out) { seam(c.random, out); }},
    {"poles", [](Case& c, Recorder& out) { poles(c.random, out); }},
    {"edges", [](Case&, Recorder& out) { edges(out); }},
    {"far", [](Case& c, Recorder& out) { far_plane(c.random, out); }},
    {"extreme", [](Case& c, Recorder& out) { extreme(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(out, c.vary)); }},
};

}
