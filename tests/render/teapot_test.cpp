#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_facts.hpp"
#include "render/surface.hpp"

// Newell's teapot, by what is known of it without its tables of patches.
namespace umbral::render::test {
namespace {

struct Extent {
    glm::vec3 low{1e9F};
    glm::vec3 high{-1e9F};
};

Extent extent_of(const Surface& surface)
{
    Extent extent;
    for (const glm::vec3& place : surface.mesh.positions) {
        extent.low = min(extent.low, place);
        extent.high = max(extent.high, place);
    }
    return extent;
}

TEST(Teapot, is_two_discs_and_two_tubes_that_face_outwards)
{
    for (const int n : {2, 3, 7}) {
        const Surface surface = make_surface(scene::Teapot{n});
        const MeshFacts facts = facts_of(surface.mesh);
        EXPECT_EQ(facts.parts, 4) << "body, lid, handle, spout";
        EXPECT_EQ(facts.euler, 2) << "1 for each disc, 0 for each tube";
        EXPECT_EQ(facts.borders, 6) << "the rim's, the lid's, two of each tube";
        EXPECT_TRUE(facts.is_oriented);
        EXPECT_EQ(facts.most_triangles_at_an_edge, 2);
        // At the bottom's centre and the knob's top 4n triangles have no area.
        EXPECT_EQ(surface.mesh.triangles.size(), static_cast<std::size_t>(64 * n * n - 8 * n));
    }
}

double cubic(double a, double b, double c, double d, double t)
{
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

TEST(Teapot, has_the_size_of_the_published_one)
{
    // Control points give these: the table, the knob's top, the handle's and the spout's places, halved.
    const Extent extent = extent_of(make_surface(scene::Teapot{32}));
    EXPECT_EQ(extent.low.y, 0);
    EXPECT_FLOAT_EQ(extent.high.y, 1.575F);
    EXPECT_FLOAT_EQ(extent.low.x, -1.5F) << "the handle's corner at (-3, 1.8)";
    // The spout's lip in the plane of symmetry: a cubic with these x.
    double lip = 0;
    for (int i = 0; i <= 1000; ++i) lip = std::max(lip, cubic(3.3, 3.525, 3.45, 3.2, i / 1000.0));
    EXPECT_NEAR(extent.high.x, lip / 2, 1e-4);
    // A quarter's Bézier arc with the factor 0.56 swells by up to 0.45 % beyond its circle.
    EXPECT_NEAR(extent.high.z, 1, 0.005);
    EXPECT_NEAR(extent.low.z, -1, 0.005);
}

/// The area of what a quarter's cubic from (1, 0) over (1, k) and (k, 1) to (0, 1) encloses, four times.
double section_area(double k)
{
    double area = 0;
    const int steps = 20000;
    glm::dvec2 before(1, 0);
    for (int i = 1; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const glm::dvec2 now(cubic(1, 1, k, 0, t), cubic(0, k, 1, 1, t));
        area += 0.5 * (before.x * now.y - before.y * now.x);
        before = now;
    }
    return 4 * area;
}

TEST(Teapot, holds_what_its_profile_turned_round_holds)
{
    // The second row of the body's patches, from (1.5, 0.15) by (1.5, 0.225), (2, 0.45), (2, 0.9): the integral of r²
    // dy, times the section's area.
    double expected = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        const double r = cubic(1.5, 1.5, 2, 2, t);
        const double rise = cubic(0.15, 0.225, 0.45, 0.9, (i + 1.0) / steps) -
                            cubic(0.15, 0.225, 0.45, 0.9, static_cast<double>(i) / steps);
        expected += r * r * rise;
    }
    expected *= section_area(0.56) / 8;  // to half the size

    // The body's rows of cells come first; that at its bottom's centre has half as many triangles.
    constexpr std::size_t n = 48;
    const Surface surface = make_surface(scene::Teapot{n});
    const std::size_t first = 4 * n + 8 * n * (n - 1);
    // By the divergence theorem with the field (x, 0, z) / 2, which flows through no lid across y.
    double volume = 0;
    for (std::size_t i = first; i < first + 8 * n * n; ++i) {
        const glm::uvec3& t = surface.mesh.triangles[i];
        const glm::dvec3 a(surface.mesh.positions[t.x]);
        const glm::dvec3 b(surface.mesh.positions[t.y]);
        const glm::dvec3 c(surface.mesh.positions[t.z]);
        const glm::dvec3 area = 0.5 * cross(b - a, c - a);
        const glm::dvec3 centre = (a + b + c) / 3.0;
        volume += 0.5 * (centre.x * area.x + centre.z * area.z);
    }
    EXPECT_NEAR(volume, expected, 1e-3 * expected);
}

}
}
