#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <umbral/gl/context.hpp>

#include "render/agreement.hpp"
#include "render/compare.hpp"
#include "render/normals.hpp"
#include "render/opengl.hpp"
#include "render/opengl_fixed.hpp"
#include "render/software.hpp"
#include "render/vertex_light.hpp"
#include "scenes.hpp"

// OpenGL's fixed function against software that computes light at the vertices as well, and shares no drawing with it.
namespace umbral::render::test {
namespace {

class FixedFunction : public testing::Test {
protected:
    FixedFunction()
    {
        gl::forbid_driver_threads();
        context_.emplace();
    }

    static Frame draw(const scene::Scene& scene, int width, int height)
    {
        const DrawList list = make_draw_list(scene, width, height);
        return draw_with_fixed_function(list, derive_effects(list, scene).set, width, height);
    }

    /// Ids may differ where an edge passes a pixel's centre: the fixed function multiplies its matrices first.
    static Comparison expect_light_at_vertices(const scene::Scene& scene, int width, int height, double color)
    {
        const DrawList list = make_draw_list(scene, width, height);
        const Comparison c = compare(draw(scene, width, height), draw_with_light_at_vertices(list, width, height));
        EXPECT_TRUE(agrees(c)) << c.ids_differ << " ids, depth " << c.depth_max << ", " << c.color_beyond << " of "
                               << c.interior;
        EXPECT_LT(c.color_max, color);
        EXPECT_GT(c.covered_first, 0U);
        return c;
    }

private:
    std::optional<gl::OffscreenContext> context_;
};

scene::Scene all_terms()
{
    scene::Scene scene = through_the_near_plane();
    scene.ambient = {0.2F, 0.1F, 0.3F};
    scene.materials[0].emission = {0.05F, 0.1F, 0.02F};
    scene.instances[0].smooth = true;
    return scene;
}

scene::Scene textured()
{
    scene::Scene scene = all_terms();
    scene.textures = {{.name = "squares", .size = 64, .cells = 4, .second = glm::vec3(0.4F)}};
    scene.materials[0].texture = 0;
    scene.materials[0].texture_scale = {2, 3};
    return scene;
}

TEST_F(FixedFunction, is_light_at_vertices)
{
    for (const scene::Scene& scene : {plain(), all_terms(), mirrored(), degenerate()}) {
        expect_light_at_vertices(scene, 201, 151, 0.1);
        expect_light_at_vertices(scene, 64, 64, 0.1);
    }
}

TEST_F(FixedFunction, multiplies_by_textures_before_it_adds_highlights)
{
    expect_light_at_vertices(textured(), 201, 151, 2);
    scene::Scene nearest = textured();
    nearest.textures[0].bilinear = false;
    nearest.textures[0].repeat = false;
    nearest.materials[0].texture_scale = {1, 1};
    const Comparison c = expect_light_at_vertices(nearest, 201, 151, 255);
    EXPECT_LT(c.color_mean, 0.2) << "another texel at the edge of one, and nothing else";
}

TEST_F(FixedFunction, draws_the_first_scene)
{
    const Comparison c = expect_light_at_vertices(first_light(), 320, 240, 20);
    EXPECT_LE(c.ids_differ, 3U);
    EXPECT_LT(c.color_mean, 0.02);
}

// What it shares with the renderers that light pixels: everything but colour.
TEST_F(FixedFunction, shares_coverage_ids_and_depth_with_software)
{
    for (const scene::Scene& scene : {first_light(), mirrored(), all_terms()}) {
        const DrawList list = make_draw_list(scene, 240, 240);
        const Frame fixed = draw(scene, 240, 240);
        const Comparison c = compare(draw_in_software(list, all_effects, 240, 240).frame, fixed);
        EXPECT_LE(c.ids_differ, 8U);
        EXPECT_LE(c.depth_mean, Agreement{}.depth_mean);
        EXPECT_LE(c.depth_max, Agreement{}.depth_most);
        EXPECT_LT(c.color_mean, 5) << "light at vertices";
        for (const std::uint32_t id : fixed.ids.cells) ASSERT_LE(id, list.draws.size());
    }
}

TEST_F(FixedFunction, cuts_nothing_off_at_one)
{
    scene::Scene scene = plain();
    scene.lights[0].color = glm::vec3(5);
    expect_light_at_vertices(scene, 64, 64, 0.1);
    float most = 0;
    for (const glm::vec4& color : draw(scene, 64, 64).color.cells) most = std::max(most, color.r);
    EXPECT_GT(most, 3);
}

TEST_F(FixedFunction, takes_large_exponents_for_128)
{
    scene::Scene scene = all_terms();
    scene.materials[0].exponent = 400;
    const Frame large = draw(scene, 96, 96);
    scene.materials[0].exponent = 128;
    EXPECT_EQ(compare(large, draw(scene, 96, 96)).color_rmse, 0);
    scene.materials[0].exponent = 100;
    EXPECT_GT(compare(large, draw(scene, 96, 96)).color_rmse, 0);
}

TEST_F(FixedFunction, takes_eight_lights_and_refuses_nine)
{
    scene::Scene scene = plain();
    scene.lights.resize(8, {.name = "lamp", .positional = true, .where = {3, 1, 2}, .color = glm::vec3(0.1F)});
    expect_light_at_vertices(scene, 64, 64, 0.1);
    scene.lights.push_back(scene.lights.back());
    try {
        (void)draw(scene, 64, 64);
        FAIL() << "nine lights were drawn";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("expected at most 8 lights, got 9"), std::string::npos);
    }
}

// One context serves several pictures by either way: neither leaves anything to the other.
TEST_F(FixedFunction, leaves_no_state_behind)
{
    const auto by_shaders = [](const scene::Scene& scene) {
        const DrawList list = make_draw_list(scene, 64, 64);
        return draw_with_opengl(list, derive_effects(list, scene).set, 64, 64);
    };
    const Frame fixed = draw(plain(), 64, 64);
    const Frame shaded = by_shaders(plain());
    for (const scene::Scene& other : {textured(), mirrored(), first_light()}) {
        (void)draw(other, 64, 64);
        EXPECT_EQ(compare(draw(plain(), 64, 64), fixed).color_rmse, 0);
        EXPECT_EQ(compare(by_shaders(plain()), shaded).color_rmse, 0);
        (void)by_shaders(other);
        EXPECT_EQ(compare(draw(plain(), 64, 64), fixed).color_rmse, 0);
    }
}

// The table of all renderers: each scene's normals are shared by those that light vertices and those that light pixels.
TEST(RendererAgreement, holds_for_small_scenes_and_shows_their_normals)
{
    Studio studio;
    for (const scene::Scene& scene : {plain(), textured(), mirrored()}) {
        const SceneAgreement agreement = compare_renderers(studio, scene, false, 160, 120);
        EXPECT_TRUE(agrees(agreement)) << agreement_notes(agreement);
        ASSERT_EQ(agreement.pairs.size(), 5U);
        for (const PairComparison& pair : agreement.pairs) {
            EXPECT_LT(pair.normals.largest, 0.1) << pair.first << " " << pair.second;
            EXPECT_GT(pair.comparison.interior, 1000U);
        }
    }
}

// The normals of a picture are those of the square that it shows, and another's are told apart.
TEST(RendererAgreement, sees_normals_that_are_turned)
{
    const auto normals = [](float degrees, Frame& frame) {
        scene::Scene scene = bare();
        scene.geometries = {{"square", scene::Plane{}}};
        scene.instances = {instance("square", 0, {scene::Rotate{{1, 0, 0}, degrees}})};
        scene.materials[0].diffuse = {0.1F, 0.9F, 0.3F};
        const DrawList list = make_draw_list(scene, 64, 64);
        frame = draw_in_software(list, all_effects, 64, 64).frame;
        return normals_of(draw_in_software(normals_list(list, false), all_effects, 64, 64).frame,
                          draw_in_software(normals_list(list, true), all_effects, 64, 64).frame);
    };
    Frame first;
    Frame second;
    const Grid<glm::vec3> a = normals(60, first);
    const Grid<glm::vec3> b = normals(63, second);
    const glm::vec3 expected(0, std::cos(glm::radians(60.0F)), std::sin(glm::radians(60.0F)));
    EXPECT_LT(length(a.at(32, 32) - expected), 1e-6F);
    const NormalComparison apart = compare_normals(a, b, first, second);
    EXPECT_NEAR(apart.largest, 3, 1e-3);
    EXPECT_NEAR(apart.mean, 3, 1e-3);
    EXPECT_EQ(compare_normals(a, a, first, first).largest, 0);
}

}
}
