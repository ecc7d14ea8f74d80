#include <gtest/gtest.h>

#include <cmath>
#include <lighting/flat-gouraud-phong/scenes.hpp>

// Linked with the reference; what is expected follows from the plane that a scene lies in, in long double.

using namespace umbral;
using namespace umbral::lighting;

namespace {

constexpr int size = 20;

/// How often a draw asked, and what it left.
struct Drawn {
    int asked = 0;
    pipeline::Layer layer = empty_layer(size, size);
};

template <class Model>
Drawn drawn(decltype(&draw_flat) draw, const StagedMesh& mesh, Model model)
{
    Drawn result;
    const auto counted = [&](const SurfacePoint& at) {
        ++result.asked;
        return model(at);
    };
    draw(mesh.vertices, mesh.triangles, counted, result.layer);
    return result;
}

glm::vec3 place(const SurfacePoint& at) { return at.position; }
glm::vec3 normal(const SurfacePoint& at) { return at.normal; }

int covered(const Drawn& drawn)
{
    int count = 0;
    for (const float depth : drawn.layer.depths.cells) count += depth < 1 ? 1 : 0;
    return count;
}

}

// The statement's numbers: between normals that lean by 0.6 the light is 50, and 20.48 at both ends.
TEST(ShadingMethods, loses_the_highlight_at_the_vertices_only)
{
    const StagedMesh mesh = square(0, size, 0.5F, 0.75F);
    const auto highlight = [](const SurfacePoint& at) {
        return glm::vec3(50 * std::pow(std::max(0.0F, at.normal.z), 4.0F));
    };
    const float at_vertices = highlight(mesh.vertices[0].at).x;
    const Drawn gouraud = drawn(draw_gouraud, mesh, highlight);
    const Drawn phong = drawn(draw_phong, mesh, highlight);
    float most = 0;
    for (int i = 0; i < size * size; ++i) {
        EXPECT_NEAR(gouraud.layer.colors.cells[static_cast<std::size_t>(i)].x, at_vertices, 1e-4F);
        most = std::max(most, phong.layer.colors.cells[static_cast<std::size_t>(i)].x);
    }
    EXPECT_GT(most, 49);
    EXPECT_NEAR(std::pow(0.8, 4) * 50, 20.48, 1e-12);
}

TEST(ShadingMethods, each_asks_as_often_as_it_must)
{
    const StagedMesh mesh = square(4, 16, 0.5F, 0.3F);
    EXPECT_EQ(drawn(draw_flat, mesh, place).asked, 2);
    EXPECT_EQ(drawn(draw_gouraud, mesh, place).asked, 4);
    EXPECT_EQ(drawn(draw_phong, mesh, place).asked, 12 * 12);
    StagedMesh twice = mesh;
    twice.triangles.insert(twice.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    EXPECT_EQ(drawn(draw_phong, twice, place).asked, 12 * 12) << "the second square is as deep, and hidden";
}

// A square without perspective: places are linear in pixels.
TEST(ShadingMethods, places_are_those_of_the_pixels)
{
    const StagedMesh mesh = square(2, 18, 0.5F, 1);
    for (const auto draw : {draw_gouraud, draw_phong}) {
        const Drawn result = drawn(draw, mesh, place);
        EXPECT_EQ(covered(result), 256);
        for (int y = 2; y < 18; ++y)
            for (int x = 2; x < 18; ++x) {
                const glm::vec3 expected((static_cast<float>(x) - 9.5F) / 8, -(static_cast<float>(y) - 9.5F) / 8, 0);
                ASSERT_LT(length(result.layer.colors.at(x, y) - expected), 1e-6F) << x << ", " << y;
            }
    }
}

// With perspective the plane's homogeneous coordinates are linear in pixels.
TEST(ShadingMethods, places_are_right_in_perspective)
{
    const float inverse_w = 0.25F;
    const StagedMesh mesh = square(2, 18, 0.5F, 1, inverse_w);
    const Drawn result = drawn(draw_phong, mesh, place);
    for (int y = 2; y < 18; ++y)
        for (int x = 2; x < 18; ++x) {
            const long double u = (x + 0.5L - 2) / 16;
            const long double v = 1 - (y + 0.5L - 2) / 16;
            if (u <= v) continue;  // the triangle with the far corner (1, -1): weights 1 - u, u - v, v on the screen
            const long double w0 = 1 - u;
            const long double w1 = (u - v) * static_cast<long double>(inverse_w);
            const long double total = w0 + w1 + v;
            const glm::vec3 expected(static_cast<float>((-w0 + w1 + v) / total),
                                     static_cast<float>((-w0 - w1 + v) / total), 0);
            ASSERT_LT(length(result.layer.colors.at(x, y) - expected), 1e-6F) << x << ", " << y;
        }
}

TEST(ShadingMethods, normals_are_unit_for_random_triangles)
{
    constexpr std::uint64_t seed = 20701;
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
        const StagedMesh mesh = random_mesh(random, size, 9, 12);
        const Drawn phong = drawn(draw_phong, mesh, normal);
        const Drawn flat = drawn(draw_flat, mesh, normal);
        const Drawn flat_place = drawn(draw_flat, mesh, place);
        for (std::size_t k = 0; k < phong.layer.colors.cells.size(); ++k) {
            ASSERT_EQ(phong.layer.depths.cells[k], flat.layer.depths.cells[k]) << "seed " << seed;
            if (phong.layer.depths.cells[k] == 1) continue;
            ASSERT_NEAR(length(phong.layer.colors.cells[k]), 1, 1e-6) << "seed " << seed;
            // A flat normal is at right angles to the sides of a triangle that ends at that place.
            const glm::vec3 n = flat.layer.colors.cells[k];
            bool fits = false;
            for (const glm::uvec3& t : mesh.triangles) {
                const glm::vec3 c = mesh.vertices[t.z].at.position;
                if (c != flat_place.layer.colors.cells[k]) continue;
                const glm::vec3 u = mesh.vertices[t.x].at.position - c;
                const glm::vec3 v = mesh.vertices[t.y].at.position - c;
                fits = fits || (std::abs(dot(n, u)) < 5e-6F && std::abs(dot(n, v)) < 5e-6F &&
                                determinant(glm::mat3(u, v, n)) > 0);
            }
            ASSERT_TRUE(fits) << "seed " << seed << ", pixel " << k;
        }
    }
}

// The header's guarantees, against long double.
TEST(ShadingMethods, normals_are_as_exact_as_promised)
{
    using Vector = glm::vec<3, long double>;
    constexpr std::uint64_t seed = 20702;
    Random random(seed);
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        const StagedMesh mesh = random_mesh(random, size, 3, 1);
        const glm::uvec3& t = mesh.triangles[0];
        const StagedVertex* const corners[] = {&mesh.vertices[t.x], &mesh.vertices[t.y], &mesh.vertices[t.z]};
        std::vector<pipeline::Fragment> fragments;
        rasterize_triangle({corners[0]->window, corners[1]->window, corners[2]->window}, size, size, fragments);
        const Vector a(corners[0]->at.position);
        const Vector exact = normalize(cross(Vector(corners[1]->at.position) - a, Vector(corners[2]->at.position) - a));
        const Drawn flat = drawn(draw_flat, mesh, normal);
        const Drawn phong = drawn(draw_phong, mesh, normal);
        for (const pipeline::Fragment& fragment : fragments) {
            Vector sum(0);
            for (int k = 0; k < 3; ++k)
                sum += static_cast<long double>(fragment.weights[k]) * Vector(corners[k]->at.normal);
            const glm::ivec2& p = fragment.pixel;
            ASSERT_LE(length(Vector(flat.layer.colors.at(p.x, p.y)) - exact), 1e-7L) << "seed " << seed;
            if (length(sum) < 1e-3L) continue;
            ++compared;
            ASSERT_LE(length(Vector(phong.layer.colors.at(p.x, p.y)) - normalize(sum)), 1e-7L) << "seed " << seed;
        }
    }
    EXPECT_GT(compared, 2000);
}

TEST(ShadingMethods, null_vectors_stay_null)
{
    StagedMesh mesh = square(2, 18, 0.5F, 1);
    for (StagedVertex& vertex : mesh.vertices) {
        vertex.at.normal = glm::vec3(0);
        vertex.at.position *= 1e-30F;
    }
    const auto seen = [](const SurfacePoint& at) { return at.normal + 1.0F; };
    EXPECT_EQ(drawn(draw_phong, mesh, seen).layer.colors.at(10, 10), glm::vec3(1));
    EXPECT_EQ(drawn(draw_flat, mesh, seen).layer.colors.at(10, 10), glm::vec3(1, 1, 2)) << "small, but no line";
    for (StagedVertex& vertex : mesh.vertices) vertex.at.position = glm::vec3(3);
    EXPECT_EQ(drawn(draw_flat, mesh, seen).layer.colors.at(10, 10), glm::vec3(1));
}
