#include "raytrace/hierarchy.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/triangle.hpp>

// The engine's rays against a loop over all triangles, with the unit's intersection, which computes in double.
namespace umbral::raytrace::test {
namespace {

constexpr std::uint64_t seed = 20261123;

std::vector<Corners> random_triangles(Random& random, std::size_t count, float size)
{
    std::vector<Corners> all;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 at = random.in_cube();
        all.push_back({at, at + size * random.in_cube(), at + size * random.in_cube()});
    }
    return all;
}

/// A bumpy sphere without gaps: rings x 2 rings squares of two triangles, which share their corners.
std::vector<Corners> closed_mesh(int rings)
{
    const auto corner = [&](int i, int j) {
        const double polar = std::acos(-1) * i / rings;
        const double azimuth = std::acos(-1) * (j % (2 * rings)) / rings;
        const double radius = 1 + (i % rings == 0 ? 0 : 0.1 * std::sin(5 * azimuth) * std::sin(7 * polar));
        return glm::vec3(radius * glm::dvec3(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                             std::sin(polar) * std::sin(azimuth)));
    };
    std::vector<Corners> all;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < 2 * rings; ++j) {
            const glm::vec3 a = i == 0 ? glm::vec3(0, 1, 0) : corner(i, j);
            const glm::vec3 b = i == 0 ? a : corner(i, j + 1);
            const glm::vec3 c = i + 1 == rings ? glm::vec3(0, -1, 0) : corner(i + 1, j + 1);
            const glm::vec3 d = i + 1 == rings ? c : corner(i + 1, j);
            all.push_back({a, b, c});
            all.push_back({a, c, d});
        }
    return all;
}

std::optional<float> nearest_by_loop(const std::vector<Corners>& triangles, const Ray& ray)
{
    std::optional<float> best;
    for (const Corners& one : triangles)
        if (const auto hit = raytracing::intersect(ray, {one.a, one.b, one.c}))
            if (!best || hit->t < *best) best = hit->t;
    return best;
}

/// How near the ray passes to an edge of any triangle, in shares of the triangle: then float may decide otherwise.
bool is_close_call(const std::vector<Corners>& triangles, const Ray& ray)
{
    for (const Corners& one : triangles) {
        const glm::dvec3 ab = glm::dvec3(one.b) - glm::dvec3(one.a);
        const glm::dvec3 ac = glm::dvec3(one.c) - glm::dvec3(one.a);
        const glm::dvec3 direction(ray.direction);
        const glm::dvec3 from = glm::dvec3(ray.origin) - glm::dvec3(one.a);
        const double volume = dot(ab, cross(direction, ac));
        if (std::abs(volume) < 1e-4 * length(ab) * length(ac)) return true;
        const double u = dot(from, cross(direction, ac)) / volume;
        const double v = dot(direction, cross(from, ab)) / volume;
        for (const double edge : {u, v, 1 - u - v})
            if (std::abs(edge) < 1e-3) return true;
    }
    return false;
}

TEST(Hierarchy, finds_what_a_loop_over_all_triangles_finds)
{
    Random random(seed);
    int hits = 0;
    for (int round = 0; round < 40; ++round) {
        const std::size_t count = round < 20 ? random.below(40) : random.below(600);
        const std::vector<Corners> triangles = random_triangles(random, count, 0.6F);
        const Hierarchy hierarchy = make_hierarchy(triangles);
        for (int i = 0; i < 60; ++i) {
            const Ray ray{2.0F * random.in_cube(), random.in_cube(), random.uniform(0, 0.5F), random.uniform(0.5F, 9)};
            if (is_close_call(triangles, ray)) continue;
            const std::optional<float> expected = nearest_by_loop(triangles, ray);
            const Hit hit = first_hit(hierarchy, ray);
            ASSERT_EQ(hit.triangle != Hit::nothing, expected.has_value()) << "seed " << seed << " round " << round;
            EXPECT_EQ(is_blocked(hierarchy, ray), expected.has_value());
            if (!expected) continue;
            ++hits;
            EXPECT_NEAR(hit.t, *expected, 2e-4F * (1 + *expected)) << "seed " << seed << " round " << round;
            const Corners& met = triangles[hit.triangle];
            const glm::vec3 by_weights = (1 - hit.u - hit.v) * met.a + hit.u * met.b + hit.v * met.c;
            EXPECT_LT(distance(by_weights, ray.origin + hit.t * ray.direction), 2e-3F);
        }
    }
    EXPECT_GT(hits, 150);
}

TEST(Hierarchy, has_no_gap_at_edges_and_corners_of_a_closed_mesh)
{
    const std::vector<Corners> triangles = closed_mesh(40);
    const Hierarchy hierarchy = make_hierarchy(triangles);
    Random random(seed);
    for (int i = 0; i < 60'000; ++i) {
        const Corners& one = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
        const float along = random.uniform();
        const glm::vec3 aim = i % 2 == 0 ? one.a : one.a + along * (one.c - one.a);
        // From near the middle, in any direction that leads to an edge or a corner: it must come out somewhere.
        const glm::vec3 origin = 0.3F * random.in_cube();
        EXPECT_TRUE(is_blocked(hierarchy, {origin, aim - origin})) << "seed " << seed << ", ray " << i;
    }
}

TEST(Hierarchy, gives_the_same_hits_by_all_instructions)
{
    Random random(seed);
    const std::vector<Corners> triangles = random_triangles(random, 3000, 0.2F);
    const Hierarchy hierarchy = make_hierarchy(triangles);
    for (int i = 0; i < 5000; ++i) {
        const Ray ray{2.0F * random.in_cube(), random.in_cube(), 0, 100};
        const Hit expected = traversals().back().first_hit(hierarchy, ray);
        for (const Traversal& traversal : traversals()) {
            const Hit hit = traversal.first_hit(hierarchy, ray);
            ASSERT_EQ(hit.triangle, expected.triangle) << traversal.name;
            ASSERT_EQ(hit.t, expected.t) << traversal.name;
            ASSERT_EQ(hit.u, expected.u) << traversal.name;
            ASSERT_EQ(hit.v, expected.v) << traversal.name;
        }
    }
}

TEST(Hierarchy, ends_on_degenerate_triangles)
{
    const Corners flat{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Corners whole{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    std::vector<Corners> triangles(1000, flat);
    triangles.insert(triangles.end(), 1000, whole);
    // Sizes and places from the smallest floats to large ones.
    for (int exponent = -120; exponent < 60; ++exponent) {
        const float size = std::ldexp(1.0F, exponent);
        triangles.push_back({{10 + size, 0, 0}, {10 + size, size, 0}, {10 + size, 0, size}});
    }
    const Hierarchy hierarchy = make_hierarchy(triangles);
    const Hit hit = first_hit(hierarchy, {{0.1F, 0.1F, 5}, {0, 0, -1}});
    EXPECT_EQ(hit.triangle, 1000U) << "of equal ones the first in the list";
    EXPECT_EQ(hit.t, 5);
    EXPECT_EQ(first_hit(hierarchy, {{0.1F, 0.1F, 5}, {0, 0, -1}, 0, 5}).triangle, Hit::nothing) << "t_max is outside";
    EXPECT_EQ(first_hit(hierarchy, {{0.1F, 0.1F, 5}, {0, 0, -1}, 5}).triangle, Hit::nothing) << "t_min is outside";
    EXPECT_EQ(first_hit(hierarchy, {{0, 0, 5}, {0, 0, 0}}).triangle, Hit::nothing) << "no direction";
    EXPECT_EQ(first_hit(make_hierarchy({}), {{0, 0, 5}, {0, 0, -1}}).triangle, Hit::nothing) << "no triangles";
}

TEST(Hierarchy, is_small)
{
    const std::vector<Corners> triangles = closed_mesh(100);
    EXPECT_LT(make_hierarchy(triangles).bytes(), 110 * triangles.size());
}

}
}
