#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_facts.hpp"
#include "render/agreement.hpp"
#include "render/draw_list.hpp"
#include "render/renderers.hpp"
#include "scene/scene_json.hpp"

// The Stanford bunny, as the package glmark2-data has it: the largest mesh that a scene reads from a file.
namespace umbral::render::test {
namespace {

class Bunny : public testing::Test {
protected:
    [[nodiscard]] const scene::Triangles& triangles() const
    {
        const auto found = std::find_if(scene_.geometries.begin(), scene_.geometries.end(),
                                        [](const scene::Geometry& one) { return one.name == "bunny"; });
        return std::get<scene::Triangles>(found->shape);
    }

    scene::Scene scene_ = scene::read_scene(UMBRAL_SOURCE_DIR "/reference/scenes/bunny.json");
};

// Stanford's scan has holes in its base. They are filled in the package's mesh: by Euler's formula V - E + T = 2, and
// where every edge has two triangles 2 E = 3 T.
TEST_F(Bunny, is_a_sphere_bent_without_a_hole)
{
    const Surface surface = make_surface(triangles());
    EXPECT_EQ(surface.mesh.positions.size(), 34'835U);
    EXPECT_EQ(surface.mesh.triangles.size(), 69'666U);
    const MeshFacts facts = facts_of(surface.mesh);
    EXPECT_EQ(facts.borders, 0);
    EXPECT_EQ(facts.most_triangles_at_an_edge, 2);
    EXPECT_TRUE(facts.is_oriented);
    EXPECT_EQ(facts.parts, 1);
    EXPECT_EQ(facts.euler, 2);
    const std::size_t edges = 104'499;
    EXPECT_EQ(2 * edges, 3 * surface.mesh.triangles.size());
    EXPECT_EQ(surface.mesh.positions.size() - edges + surface.mesh.triangles.size(), 2U);
}

TEST_F(Bunny, fits_into_the_cube_and_its_front_is_outside)
{
    glm::vec3 low(1e9F);
    glm::vec3 high(-1e9F);
    double volume = 0;
    for (const glm::vec3& place : triangles().positions) low = min(low, place), high = max(high, place);
    for (const glm::uvec3& t : triangles().triangles)
        volume += dot(glm::dvec3(triangles().positions[t.x]),
                      cross(glm::dvec3(triangles().positions[t.y]), glm::dvec3(triangles().positions[t.z]))) /
                  6;
    EXPECT_EQ(low.x, -1);
    EXPECT_EQ(high.x, 1);
    EXPECT_NEAR(low.y, -high.y, 1e-6);
    EXPECT_NEAR(low.z, -high.z, 1e-6);
    EXPECT_GT(volume, 1);
    EXPECT_LT(volume, 8);
}

TEST_F(Bunny, has_unit_normals)
{
    const VertexMesh mesh = make_vertices(make_surface(triangles()), true);
    // More than positions: along the seam some have two pairs of texture coordinates.
    EXPECT_GE(mesh.vertices.size(), 34'835U);
    EXPECT_LT(mesh.vertices.size(), 36'000U);
    for (const Vertex& vertex : mesh.vertices) ASSERT_NEAR(length(vertex.normal), 1, 1e-5);
}

TEST_F(Bunny, is_drawn_alike_by_all_renderers)
{
    scene_.bounces = 0;
    const auto bunny = std::find_if(scene_.instances.begin(), scene_.instances.end(),
                                    [](const scene::Instance& one) { return one.name == "bunny"; });
    scene_.instances = {*bunny};
    Studio studio;
    const SceneAgreement agreement = compare_renderers(studio, scene_, false, 320, 240);
    EXPECT_TRUE(agrees(agreement)) << agreement_notes(agreement);
    EXPECT_TRUE(agreement.missing.empty());
    ASSERT_EQ(agreement.pairs.size(), 5U);
    for (const PairComparison& pair : agreement.pairs) {
        EXPECT_GT(pair.comparison.covered_first, pair.comparison.pixels / 10) << pair.first;
        EXPECT_LE(pair.comparison.coverage_differs, 8U) << pair.first << " " << pair.second;
    }
}

TEST(UnreadMesh, is_not_drawn)
{
    EXPECT_THROW((void)make_surface(scene::MeshFile{"bunny.obj", "", false}), std::invalid_argument);
}

}
}
