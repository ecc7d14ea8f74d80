#include <gtest/gtest.h>

#include <cmath>
#include <umbral/gl/context.hpp>

#include "render/compare.hpp"
#include "render/opengl.hpp"
#include "render/software.hpp"
#include "scenes.hpp"

// Two renderers that share matrices and vertices, and nothing after them.
namespace umbral::render::test {
namespace {

struct Both {
    Frame software;
    Frame gl;
    Comparison comparison;
};

Both draw(const scene::Scene& scene, int width, int height)
{
    const DrawList list = make_draw_list(scene, width, height);
    const EffectSet effects = derive_effects(list, scene).set;
    const gl::OffscreenContext context;
    Both both{draw_in_software(list, effects, width, height).frame, draw_with_opengl(list, effects, width, height), {}};
    both.comparison = compare(both.software, both.gl);
    return both;
}

/// No texture: what differs is arithmetic alone, a small part of a step. Sizes are odd, so that pixels have their
/// centres on edges.
void expect_closely_equal(const scene::Scene& scene, int width, int height)
{
    const Comparison c = draw(scene, width, height).comparison;
    EXPECT_TRUE(agrees(c));
    EXPECT_EQ(c.coverage_differs, 0U);
    EXPECT_EQ(c.ids_differ, 0U);
    EXPECT_LT(c.color_max, 0.05);
    EXPECT_GT(c.covered_first, 0U);
}

TEST(Agreement, of_the_first_scene_at_several_sizes)
{
    for (const auto& [width, height] : {std::pair{512, 512}, {640, 360}, {333, 77}, {64, 64}, {31, 97}}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
        const Comparison c = draw(first_light(), width, height).comparison;
        EXPECT_TRUE(agrees(c));
        // Vertices are the same bit by bit, and rounded to the same grid: not even edges differ.
        EXPECT_EQ(c.coverage_differs, 0U);
        EXPECT_EQ(c.ids_differ, 0U);
        EXPECT_GT(c.interior, c.pixels / 5);
    }
}

TEST(Agreement, of_one_pixel_and_of_one_row)
{
    for (const auto& [width, height] : {std::pair{1, 1}, {200, 1}, {1, 200}}) {
        const Comparison c = draw(plain(), width, height).comparison;
        EXPECT_TRUE(agrees(c));
        EXPECT_EQ(c.ids_differ, 0U) << width << " x " << height;
    }
}

TEST(Agreement, of_a_scene_without_effects) { expect_closely_equal(plain(), 201, 151); }

TEST(Agreement, of_triangles_seen_from_behind_and_mirrored)
{
    expect_closely_equal(mirrored(), 241, 241);
    const Both both = draw(mirrored(), 240, 240);
    std::array<int, 5> pixels{};
    for (const std::uint32_t id : both.software.ids.cells) ++pixels.at(id);
    for (const std::uint32_t id : {1U, 2U, 3U}) EXPECT_GT(pixels[id], 500) << id;
    EXPECT_EQ(pixels[4], 0) << "seen from behind only, and one-sided";
}

TEST(Agreement, of_degenerate_triangles) { expect_closely_equal(degenerate(), 121, 121); }

TEST(Agreement, where_an_object_crosses_the_near_plane)
{
    for (const auto& [width, height] : {std::pair{256, 256}, {301, 97}}) {
        const Both both = draw(through_the_near_plane(), width, height);
        // Clipping makes new vertices, each renderer with roundings of its own: an edge may move by a subpixel.
        EXPECT_TRUE(agrees(both.comparison));
        EXPECT_LE(both.comparison.ids_differ, 8U);
        EXPECT_LT(both.comparison.color_max, 0.05);
        EXPECT_GT(both.comparison.covered_first, both.comparison.pixels / 3);
        for (const glm::vec4& color : both.software.color.cells)
            ASSERT_TRUE(std::isfinite(color.r + color.g + color.b));
    }
}

TEST(Agreement, where_triangles_lead_past_the_camera_on_all_sides)
{
    for (const auto& [width, height] : {std::pair{256, 256}, {301, 97}, {90, 200}}) {
        const Both both = draw(around_the_camera(), width, height);
        // Mesa clips at the picture's sides, where the engine has a guard band: an edge may move by a subpixel, also
        // one between two triangles of the ring, which the comparison takes for its interior.
        EXPECT_LE(both.comparison.ids_differ, 2U);
        EXPECT_LE(both.comparison.color_beyond, 2U);
        EXPECT_LE(both.comparison.depth_mean, Agreement{}.depth_mean);
        EXPECT_EQ(both.comparison.covered_first, both.comparison.pixels);
        EXPECT_EQ(both.comparison.covered_second, both.comparison.pixels);
    }
}

TEST(Agreement, on_nothing)
{
    scene::Scene scene = bare();
    EXPECT_EQ(draw(scene, 40, 30).comparison.covered_first + draw(scene, 40, 30).comparison.covered_second, 0U);
    scene = behind_the_camera();
    const Both both = draw(scene, 40, 30);
    EXPECT_EQ(both.comparison.covered_first, 0U) << "one lies behind the camera, the other shows its inside";
    EXPECT_EQ(both.comparison.covered_second, 0U);
    scene.lights.clear();
    scene.instances[1].sides = scene::Sides::both;
    const Comparison inside = draw(scene, 40, 30).comparison;
    EXPECT_EQ(inside.covered_first, inside.pixels) << "without lights, from inside a sphere";
    EXPECT_EQ(inside.covered_second, inside.pixels);
    EXPECT_TRUE(agrees(inside));
}

// The comparison itself must see what is wrong.
TEST(Comparison, counts_what_was_changed)
{
    const DrawList list = make_draw_list(plain(), 60, 60);
    const Frame right = draw_in_software(list, all_effects, 60, 60).frame;
    EXPECT_TRUE(agrees(compare(right, right)));

    Frame other = right;
    other.ids.at(30, 30) = 2;
    other.ids.at(0, 0) = 1;
    const Comparison ids = compare(right, other);
    EXPECT_EQ(ids.ids_differ, 2U);
    EXPECT_EQ(ids.coverage_differs, 1U);
    EXPECT_FALSE(agrees(ids));
    EXPECT_EQ(ids.interior, compare(right, right).interior - 9);

    other = right;
    for (float& depth : other.depth.cells) depth += 0x1p-17F;
    EXPECT_FALSE(agrees(compare(right, other)));

    other = right;
    for (glm::vec4& color : other.color.cells) color *= 1.03F;
    EXPECT_FALSE(agrees(compare(right, other)));
    EXPECT_THROW((void)compare(right, Frame(60, 59)), std::invalid_argument);
}

}
}
