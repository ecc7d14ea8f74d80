#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/patterns.hpp"
#include "render/surface.hpp"
#include "render/textures.hpp"

// Boxes, cylinders, cones, discs, profiles that are turned; and textures like wood, marble and bricks.
namespace umbral::render::test {
namespace {

double area(const Surface& surface)
{
    double sum = 0;
    for (const glm::uvec3& t : surface.mesh.triangles) {
        const glm::dvec3 a(surface.mesh.positions[t.x]);
        sum += 0.5 *
               length(cross(glm::dvec3(surface.mesh.positions[t.y]) - a, glm::dvec3(surface.mesh.positions[t.z]) - a));
    }
    return sum;
}

/// By the divergence theorem: positive if the surface is closed and counter-clockwise seen from outside.
double volume(const Surface& surface)
{
    double sum = 0;
    for (const glm::uvec3& t : surface.mesh.triangles)
        sum += dot(glm::dvec3(surface.mesh.positions[t.x]),
                   cross(glm::dvec3(surface.mesh.positions[t.y]), glm::dvec3(surface.mesh.positions[t.z]))) /
               6;
    return sum;
}

// Of a regular polygon with so many corners.
double polygon(int sectors) { return 0.5 * sectors * std::sin(2 * std::numbers::pi / sectors); }

TEST(Solids, have_the_volumes_and_areas_of_geometry)
{
    const double pi = std::numbers::pi;
    EXPECT_NEAR(volume(make_surface(scene::Box{})), 8, 1e-6);
    EXPECT_NEAR(area(make_surface(scene::Box{})), 24, 1e-6);
    for (const int sectors : {3, 64}) {
        EXPECT_NEAR(volume(make_surface(scene::Cylinder{sectors})), 2 * polygon(sectors), 1e-6);
        EXPECT_NEAR(volume(make_surface(scene::Cone{sectors})), 2 * polygon(sectors) / 3, 1e-6);
        EXPECT_NEAR(area(make_surface(scene::Disc{sectors})), polygon(sectors), 1e-6);
        EXPECT_EQ(make_surface(scene::Cylinder{sectors}).mesh.triangles.size(), 4U * static_cast<unsigned>(sectors));
        EXPECT_EQ(make_surface(scene::Cone{sectors}).mesh.triangles.size(), 2U * static_cast<unsigned>(sectors));
    }
    // A half circle turned is a sphere.
    scene::Revolution sphere{{}, 512};
    for (int i = 0; i <= 256; ++i)
        sphere.profile.emplace_back(i == 0 || i == 256 ? 0 : std::sin(pi * i / 256), -std::cos(pi * i / 256));
    EXPECT_NEAR(volume(make_surface(sphere)), 4 * pi / 3, 1e-3);
    EXPECT_NEAR(area(make_surface(sphere)), 4 * pi, 2e-3);
}

TEST(Solids, face_outwards_with_edges_where_a_point_stands_twice)
{
    const VertexMesh disc = make_vertices(make_surface(scene::Disc{8}), true);
    for (const Vertex& vertex : disc.vertices) EXPECT_NEAR(vertex.normal.y, 1, 1e-6);
    const VertexMesh cylinder = make_vertices(make_surface(scene::Cylinder{64}), true);
    for (const Vertex& vertex : cylinder.vertices) {
        const bool is_side = std::abs(vertex.normal.y) < 0.5F;
        EXPECT_NEAR(is_side ? length(glm::vec2(vertex.normal.x, vertex.normal.z)) : std::abs(vertex.normal.y), 1, 1e-5)
            << "no normal between the side's and the end's";
    }
    // The same profile with and without an edge in it.
    const auto leaning = [](const std::vector<glm::vec2>& profile) {
        int count = 0;
        for (const Vertex& vertex : make_vertices(make_surface(scene::Revolution{profile, 16}), true).vertices)
            count += std::abs(vertex.normal.y) > 0.1F && std::abs(vertex.normal.y) < 0.9F ? 1 : 0;
        return count;
    };
    EXPECT_GT(leaning({{0, 0}, {1, 0}, {1, 1}}), 0);
    EXPECT_EQ(leaning({{0, 0}, {1, 0}, {1, 0}, {1, 1}}), 0);
}

TEST(Solids, show_the_whole_texture)
{
    for (const scene::Shape& shape : {scene::Shape(scene::Box{}), scene::Shape(scene::Cylinder{}),
                                      scene::Shape(scene::Disc{}), scene::Shape(scene::Revolution{{{1, 0}, {1, 3}}})}) {
        const Surface surface = make_surface(shape);
        glm::vec2 low(1);
        glm::vec2 high(0);
        for (const glm::vec2& uv : surface.uvs) {
            low = min(low, uv);
            high = max(high, uv);
        }
        EXPECT_EQ(low, glm::vec2(0));
        EXPECT_EQ(high, glm::vec2(1));
    }
}

TEST(Patterns, join_themselves_without_a_seam)
{
    for (const scene::TextureKind kind : {scene::TextureKind::wood, scene::TextureKind::marble}) {
        const scene::Texture texture{
            .name = "", .kind = kind, .size = 512, .cells = 4, .first = glm::vec3(0.9F), .second = glm::vec3(0.1F)};
        const auto texels = make_texture(texture);
        // Across the border two texels differ no more than they do somewhere inside.
        float inside = 0;
        float across = 0;
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) {
                const float step = std::abs(texels.at(x, y).x - texels.at(x, (y + 1) % 512).x);
                (y == 511 ? across : inside) = std::max(y == 511 ? across : inside, step);
            }
        EXPECT_LE(across, inside);
        EXPECT_GT(inside, 0.01F);
    }
}

TEST(Patterns, are_of_both_colours_and_nothing_beyond)
{
    for (const scene::TextureKind kind :
         {scene::TextureKind::wood, scene::TextureKind::marble, scene::TextureKind::bricks}) {
        const scene::Texture texture{.name = "",
                                     .kind = kind,
                                     .size = 256,
                                     .cells = 6,
                                     .first = {0.8F, 0.1F, 0.1F},
                                     .second = {0.1F, 0.1F, 0.8F}};
        int first = 0;
        int second = 0;
        for (const glm::vec4& texel : make_texture(texture).cells) {
            for (int i = 0; i < 3; ++i) ASSERT_TRUE(texel[i] >= 0 && texel[i] <= 1) << "not finite, or beyond";
            (texel.x > texel.z ? first : second) += 1;
        }
        EXPECT_GT(first, 1000);
        EXPECT_GT(second, 1000);
    }
}

TEST(Patterns, noise_repeats_and_is_bounded)
{
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 place(0.013F * static_cast<float>(i), 0.007F * static_cast<float>(i * i % 991));
        const float here = periodic_noise(place, {3, 5});
        EXPECT_LE(std::abs(here), 1);
        EXPECT_NEAR(here, periodic_noise(place + glm::vec2(3, -5), {3, 5}), 1e-4) << place.x << ", " << place.y;
    }
}

}
}
