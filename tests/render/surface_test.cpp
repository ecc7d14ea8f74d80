#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "render/surface.hpp"
#include "render/textures.hpp"

namespace umbral::render::test {
namespace {

/// Every edge of a closed surface is met once in each direction.
void expect_closed(const Surface& surface)
{
    std::map<std::pair<unsigned, unsigned>, int> edges;
    for (const glm::uvec3& t : surface.mesh.triangles)
        for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    // Euler's formula, with edges counted twice: see each surface.
    EXPECT_EQ(edges.size() % 2, 0U);
}

long euler(const Surface& surface)
{
    const auto faces = static_cast<long>(surface.mesh.triangles.size());
    return static_cast<long>(surface.mesh.positions.size()) - faces * 3 / 2 + faces;
}

/// Corners are counter-clockwise seen from where `outward` points.
template <class Outward>
void expect_outward(const Surface& surface, const Outward& outward)
{
    for (const glm::uvec3& t : surface.mesh.triangles) {
        const auto& p = surface.mesh.positions;
        const glm::vec3 normal = cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
        ASSERT_GT(dot(normal, outward((p[t.x] + p[t.y] + p[t.z]) / 3.0F)), 0);
    }
}

TEST(Surface, sphere)
{
    for (const auto& [rings, sectors] : {std::pair{2, 3}, {7, 12}, {32, 64}}) {
        const Surface surface = make_surface(scene::Sphere{rings, sectors});
        EXPECT_EQ(surface.mesh.positions.size(), static_cast<std::size_t>((rings - 1) * sectors + 2));
        EXPECT_EQ(surface.mesh.triangles.size(), static_cast<std::size_t>(2 * (rings - 1) * sectors));
        EXPECT_EQ(euler(surface), 2);
        expect_closed(surface);
        expect_outward(surface, [](const glm::vec3& at) { return at; });
        for (const glm::vec3& position : surface.mesh.positions) EXPECT_NEAR(length(position), 1, 2e-7);
    }
}

TEST(Surface, torus)
{
    const Surface surface = make_surface(scene::Torus{24, 12, 0.25F});
    EXPECT_EQ(surface.mesh.positions.size(), 24U * 12U);
    EXPECT_EQ(euler(surface), 0);
    expect_closed(surface);
    expect_outward(surface, [](const glm::vec3& at) { return at - normalize(glm::vec3(at.x, 0, at.z)); });
    for (const glm::vec3& p : surface.mesh.positions)
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) - 1, p.y), 0.25, 2e-7);
}

TEST(Surface, wave_and_plane)
{
    const Surface plane = make_surface(scene::Plane{2, 3});
    EXPECT_EQ(plane.mesh.positions.size(), 12U);
    EXPECT_EQ(plane.mesh.positions.front(), glm::vec3(-1, 0, 1)) << "u = v = 0 is at the left, towards the viewer";
    EXPECT_EQ(plane.mesh.positions.back(), glm::vec3(1, 0, -1));
    expect_outward(plane, [](const glm::vec3&) { return glm::vec3(0, 1, 0); });

    const Surface wave = make_surface(scene::Wave{4, 4, 0.5F, {1, 0}});
    expect_outward(wave, [](const glm::vec3&) { return glm::vec3(0, 1, 0); });
    EXPECT_NEAR(wave.mesh.positions[1].y, 0.5, 1e-7) << "a quarter of the period";
    EXPECT_NEAR(wave.mesh.positions[3].y, -0.5, 1e-7);
}

TEST(Vertices, meet_at_a_seam_with_one_normal_and_two_texture_coordinates)
{
    const VertexMesh mesh = make_vertices(make_surface(scene::Sphere{16, 32}), true);
    std::map<std::array<float, 3>, std::vector<const Vertex*>> places;
    for (const Vertex& vertex : mesh.vertices)
        places[{vertex.position.x, vertex.position.y, vertex.position.z}].push_back(&vertex);
    int seams = 0;
    for (const auto& [place, vertices] : places) {
        for (const Vertex* vertex : vertices) {
            EXPECT_EQ(vertex->normal, vertices.front()->normal);
            EXPECT_GT(dot(vertex->normal, vertex->position), 0.99F);
        }
        seams += vertices.size() == 2 ? 1 : 0;
    }
    EXPECT_EQ(seams, 15);
}

TEST(Vertices, are_flat_if_asked)
{
    const VertexMesh mesh = make_vertices(make_surface(scene::Sphere{4, 6}), false);
    EXPECT_EQ(mesh.vertices.size(), 3 * mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        EXPECT_EQ(mesh.vertices[t.x].normal, mesh.vertices[t.y].normal);
        EXPECT_EQ(mesh.vertices[t.x].normal, mesh.vertices[t.z].normal);
    }
}

TEST(Vertices, have_unit_normals_whatever_the_mesh)
{
    scene::Triangles odd;
    odd.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    odd.triangles = {{0, 1, 2}, {0, 2, 1}, {3, 3, 3}, {0, 1, 1}};
    for (const bool smooth : {true, false})
        for (const Vertex& vertex : make_vertices(make_surface(odd), smooth).vertices)
            EXPECT_NEAR(length(vertex.normal), 1, 1e-6);
    EXPECT_TRUE(make_vertices(make_surface(scene::Triangles{}), true).triangles.empty());
}

TEST(Texture, has_its_first_colour_in_the_lower_left_corner)
{
    const Grid<glm::vec4> squares = make_texture({.name = "",
                                                  .kind = scene::TextureKind::checker,
                                                  .size = 8,
                                                  .cells = 4,
                                                  .first = {1, 0, 0},
                                                  .second = {0, 0, 1}});
    EXPECT_EQ(squares.at(0, 7), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(squares.at(1, 6), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(squares.at(2, 7), glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(squares.at(0, 5), glm::vec4(0, 0, 1, 1));
    const Grid<glm::vec4> stripes = make_texture({.name = "",
                                                  .kind = scene::TextureKind::stripes,
                                                  .size = 8,
                                                  .cells = 2,
                                                  .first = {1, 0, 0},
                                                  .second = {0, 0, 1}});
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(stripes.at(3, y), glm::vec4(1, 0, 0, 1));
        EXPECT_EQ(stripes.at(4, y), glm::vec4(0, 0, 1, 1));
    }
    for (const int size : {1, 7, 64})
        for (const glm::vec4& texel :
             make_texture({.name = "", .kind = scene::TextureKind::uv_grid, .size = size, .cells = 5}).cells)
            for (int i = 0; i < 4; ++i) ASSERT_TRUE(texel[i] >= 0 && texel[i] <= 1);
}

}
}
