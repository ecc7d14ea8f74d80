#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <umbral/core/random.hpp>

#include "mesh_facts.hpp"
#include "render/fields/isosurface.hpp"
#include "render/surface.hpp"
#include "scene/parts.hpp"

// Surfaces that are known by their distance, as triangles.
namespace umbral::render::test {
namespace {

using fields::Distance;
using fields::isosurface;

double sphere(const glm::dvec3& place, const glm::dvec3& centre, double radius)
{
    return distance(place, centre) - radius;
}

double torus(const glm::dvec3& place, double ring, double tube)
{
    return std::hypot(std::hypot(place.x, place.z) - ring, place.y) - tube;
}

double volume(const meshes::IndexedMesh& mesh)
{
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += dot(glm::dvec3(mesh.positions[t.x]),
                   cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
               6;
    return sum;
}

void expect_closed(const meshes::IndexedMesh& mesh, const char* what)
{
    const MeshFacts facts = facts_of(mesh);
    EXPECT_EQ(facts.borders, 0) << what;
    EXPECT_EQ(facts.most_triangles_at_an_edge, 2) << what;
    EXPECT_TRUE(facts.is_oriented) << what;
}

TEST(Isosurface, of_spheres_and_rings_is_closed_and_has_their_euler_characteristic)
{
    struct Case {
        const char* name;
        Distance field;
        int euler;
        int parts;
    };
    const Case cases[] = {
        {"sphere",
         [](const glm::dvec3& p) {
             return sphere(p, {0.03, -0.01, 0.02}, 0.8);
         },
         2, 1},
        {"sphere on the grid's points", [](const glm::dvec3& p) { return sphere(p, glm::dvec3(0), 0.5); }, 2, 1},
        {"ring", [](const glm::dvec3& p) { return torus(p, 0.6, 0.25); }, 0, 1},
        {"two spheres",
         [](const glm::dvec3& p) {
             return std::min(sphere(p, {-0.5, 0, 0}, 0.3), sphere(p, {0.5, 0, 0}, 0.4));
         },
         4, 2},
        {"a ball with a hollow",
         [](const glm::dvec3& p) { return std::max(sphere(p, glm::dvec3(0), 0.8), -sphere(p, glm::dvec3(0), 0.4)); }, 4,
         2},
    };
    for (const Case& one : cases)
        for (const int cells : {16, 21, 40}) {
            const meshes::IndexedMesh mesh = isosurface(one.field, cells);
            expect_closed(mesh, one.name);
            const MeshFacts facts = facts_of(mesh);
            EXPECT_EQ(facts.euler, one.euler) << one.name << ", " << cells;
            EXPECT_EQ(facts.parts, one.parts) << one.name << ", " << cells;
        }
}

TEST(Isosurface, lies_on_the_surface_and_encloses_its_volume)
{
    for (const int cells : {16, 48}) {
        const double cell = 2.0 / cells;
        const meshes::IndexedMesh ball = isosurface(
            [](const glm::dvec3& p) {
                return sphere(p, {0.1, 0.05, -0.02}, 0.7);
            },
            cells);
        for (const glm::vec3& place : ball.positions)
            EXPECT_LE(std::abs(sphere(glm::dvec3(place), {0.1, 0.05, -0.02}, 0.7)), 1.001e-3 * cell + 1e-7);
        // Chords of a curve of radius r and length c stand c² / 8r from it.
        const double pi = std::numbers::pi;
        EXPECT_NEAR(volume(ball), 4 * pi / 3 * 0.343, 4 * pi * 0.49 * cell * cell / 0.7);
        EXPECT_GT(volume(ball), 0) << "its front is outside";
        const meshes::IndexedMesh ring = isosurface([](const glm::dvec3& p) { return torus(p, 0.6, 0.25); }, cells);
        for (const glm::vec3& place : ring.positions)
            EXPECT_LE(std::abs(torus(glm::dvec3(place), 0.6, 0.25)), 1.001e-3 * cell + 1e-7);
        EXPECT_NEAR(volume(ring), 2 * pi * pi * 0.6 * 0.0625, 4 * pi * pi * 0.6 * 0.25 * cell * cell / 0.25);
    }
}

TEST(Isosurface, is_closed_whatever_the_field_is_like)
{
    // Values by chance at every place, positive near the cube's sides: every case of every cell occurs.
    const Distance noise = [](const glm::dvec3& p) {
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 0.9) return 0.01;
        return 0.02 * std::sin(931 * p.x + 17 * p.y) * std::sin(713 * p.y - 29 * p.z) * std::sin(577 * p.z + 41 * p.x);
    };
    const meshes::IndexedMesh mesh = isosurface(noise, 24);
    EXPECT_GT(mesh.triangles.size(), 20000U);
    expect_closed(mesh, "noise");
    EXPECT_TRUE(isosurface([](const glm::dvec3&) { return 0.001; }, 8).triangles.empty());
}

TEST(Fields, are_closed_surfaces_within_the_cube_and_within_what_a_scene_may_hold)
{
    for (const int cells : {8, 40, 96}) {
        const scene::DistanceField shape{scene::FieldKind::mandelbulb, cells};
        const Surface surface = make_surface(shape);
        ASSERT_FALSE(surface.mesh.triangles.empty());
        expect_closed(surface.mesh, "mandelbulb");
        EXPECT_LE(surface.mesh.triangles.size(), scene::triangle_count(shape)) << cells;
        EXPECT_GT(volume(surface.mesh), 0);
        for (const glm::vec3& p : surface.mesh.positions)
            EXPECT_LT(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1);
    }
}

TEST(Fields, change_by_little_more_than_the_distance_between_places)
{
    const Distance field = fields::field_of(scene::FieldKind::mandelbulb);
    Random random(8);
    const auto anywhere = [&] {
        return glm::dvec3(random.uniform(-1.0F, 1.0F), random.uniform(-1.0F, 1.0F), random.uniform(-1.0F, 1.0F));
    };
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 one = anywhere();
        const glm::dvec3 other = one + 0.1 * anywhere();
        // Within the fractal's solid the estimate is one number, and close to it it is no distance any more.
        if (std::min(field(one), field(other)) < 0.02) continue;
        most = std::max(most, std::abs(field(one) - field(other)) / distance(one, other));
    }
    EXPECT_LE(most, 1.1);
    EXPECT_GT(most, 0.5);
}

TEST(Fields, have_texture_coordinates_that_do_not_jump_within_a_triangle)
{
    const Surface surface = make_surface(scene::DistanceField{scene::FieldKind::mandelbulb, 48});
    ASSERT_EQ(surface.uv_triangles.size(), surface.mesh.triangles.size());
    for (std::size_t i = 0; i < surface.uv_triangles.size(); ++i) {
        // On the axis they turn round at once, as at a sphere's poles.
        const glm::vec3& place = surface.mesh.positions[surface.mesh.triangles[i].x];
        if (length(glm::vec2(place.x, place.z)) < 2.0F / 48) continue;
        const glm::uvec3& t = surface.uv_triangles[i];
        const float low = std::min({surface.uvs[t.x].x, surface.uvs[t.y].x, surface.uvs[t.z].x});
        const float high = std::max({surface.uvs[t.x].x, surface.uvs[t.y].x, surface.uvs[t.z].x});
        EXPECT_LE(high - low, 0.5F);
    }
}

}
}
