#include "render/rays/draw.hpp"

#include <gtest/gtest.h>

#include "render/software.hpp"
#include "scenes.hpp"

// What rays draw, against the rasteriser and against what follows on paper.
namespace umbral::render::rays::test {
namespace {

using render::test::bare;
using render::test::first_light;
using render::test::instance;

glm::vec3 centre_of(const scene::Scene& scene, const Effort& effort)
{
    return glm::vec3(draw_by_rays(make_draw_list(scene, 1, 1), 1, 1, effort).color.at(0, 0));
}

/// The camera within a sphere whose inner side is seen.
scene::Scene furnace(float albedo, float emission, int bounces)
{
    scene::Scene scene = bare();
    scene.camera.eye = {0, 0, 0.4F};
    scene.camera.near = 0.01F;
    scene.lights.clear();
    scene.ambient = glm::vec3(1);
    scene.bounces = bounces;
    scene.materials = {
        {.name = "wall", .emission = glm::vec3(emission), .ambient = glm::vec3(1), .diffuse = glm::vec3(albedo)}};
    scene.instances = {instance("furnace", 0)};
    scene.instances[0].sides = scene::Sides::both;
    return scene;
}

TEST(Rays, agree_with_the_rasteriser_on_what_lies_where_and_on_unshadowed_light)
{
    scene::Scene scene = bare();
    scene.materials[0].specular = glm::vec3(0.4F);
    scene.materials[0].exponent = 20;
    scene.instances = {instance("ball", 0, {scene::Translate{{0.3F, -0.2F, 0}}})};
    constexpr int side = 96;
    const DrawList list = make_draw_list(scene, side, side);
    const Frame expected = draw_in_software(list, all_effects, side, side).frame;
    const Frame frame = draw_by_rays(list, side, side, {});
    int other = 0;
    int at_edges = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (frame.ids.at(x, y) != expected.ids.at(x, y)) {
                ++other;
                continue;
            }
            // Corners are moved to 1/256 of a pixel there, which shows in depth where the ball turns away.
            const float depth = std::abs(frame.depth.at(x, y) - expected.depth.at(x, y));
            at_edges += depth > 2e-5F ? 1 : 0;
            EXPECT_LT(depth, 1e-3F) << x << ", " << y;
            // At the edge of the light the triangles' own shadow begins.
            const glm::vec4 difference = abs(frame.color.at(x, y) - expected.color.at(x, y));
            EXPECT_LT(std::max({difference.r, difference.g, difference.b}), 0.06F) << x << ", " << y;
        }
    EXPECT_LE(at_edges, 60);
    EXPECT_LE(other, 12) << "of " << side * side << " pixels";
}

TEST(Rays, give_the_same_picture_by_any_number_of_threads)
{
    scene::Scene scene = first_light();
    scene.camera.lens_radius = 0.05F;
    scene.lights[1].radius = 0.3F;
    scene.bounces = 1;
    const DrawList list = make_draw_list(scene, 40, 30);
    const Frame one = draw_by_rays(list, 40, 30, {.rays = 3, .threads = 1});
    for (const int threads : {2, 3, 7}) {
        const Frame other = draw_by_rays(list, 40, 30, {.rays = 3, .threads = threads});
        EXPECT_EQ(other.color.cells, one.color.cells) << threads;
        EXPECT_EQ(other.depth.cells, one.depth.cells) << threads;
        EXPECT_EQ(other.ids.cells, one.ids.cells) << threads;
    }
}

TEST(Rays, light_a_furnace_by_the_sum_of_its_bounces)
{
    // A closed wall that sends E everywhere and reflects the share a: E (1 + a + a² + …), whatever the wall's shape.
    for (const int bounces : {1, 2, 6}) {
        double expected = 0;
        for (int i = 0; i <= bounces; ++i) expected += 0.5 * std::pow(0.7, i);
        EXPECT_NEAR(centre_of(furnace(0.7F, 0.5F, bounces), {.rays = 64}).r, expected, 1e-3) << bounces;
    }
}

TEST(Rays, add_ambient_light_only_where_no_bounces_stand_for_it)
{
    EXPECT_FLOAT_EQ(centre_of(furnace(0.7F, 0.25F, 0), {}).r, 1.25F);
    EXPECT_NEAR(centre_of(furnace(0, 0.25F, 1), {}).r, 0.25F, 1e-6F);
}

/// A pane across the view, before a wall that sends 1.
scene::Scene pane()
{
    scene::Scene scene = bare();
    scene.lights.clear();
    scene.geometries = {{"square", scene::Plane{}}};
    scene.materials = {{.name = "pane", .diffuse = glm::vec3(0)},
                       {.name = "wall", .emission = glm::vec3(1), .diffuse = glm::vec3(0)}};
    const scene::Rotate upright{{1, 0, 0}, 90};
    scene.instances = {instance("pane", 0, {upright, scene::Scale{{9, 9, 1}}}),
                       instance("wall", 0, {upright, scene::Scale{{99, 99, 1}}, scene::Translate{{0, 0, -5}}})};
    scene.instances[1].material = 1;
    return scene;
}

TEST(Rays, share_light_out_at_glass_by_fresnel)
{
    // Straight on: ((n - 1) / (n + 1))² is reflected, and what is behind is black.
    scene::Scene scene = pane();
    scene.materials[0].transmit = glm::vec3(1);
    scene.materials[0].index = 1.5F;
    EXPECT_NEAR(centre_of(scene, {}).r, 1 - 0.04, 1e-4);
    scene.materials[0].transmit = {0.5F, 0.25F, 1};
    EXPECT_NEAR(centre_of(scene, {}).g, 0.25 * 0.96, 1e-4);
    scene.depth = 0;
    EXPECT_EQ(centre_of(scene, {}).r, 0) << "no glass may be met";
}

TEST(Rays, see_mirrors_and_the_sky_in_them)
{
    scene::Scene scene = pane();
    scene.materials[0].mirror = {0.5F, 0.5F, 1};
    // The mirror is looked at straight on, and so is the horizon behind the camera: half of either background.
    scene.background_top = {1, 0, 0};
    scene.background_bottom = {0, 0, 1};
    const glm::vec3 seen = centre_of(scene, {});
    EXPECT_NEAR(seen.r, 0.25, 1e-5);
    EXPECT_NEAR(seen.b, 0.5, 1e-5);
}

/// A floor under the camera, lit from straight above, and a roof that hides the half x < 0 of the lamp's sky.
TEST(Rays, soften_shadows_by_the_share_of_the_light_that_is_seen)
{
    scene::Scene scene = bare();
    scene.camera = {.eye = {0, 1, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .fovy_degrees = 1, .near = 0.1F, .far = 9};
    scene.lights = {{.name = "lamp", .positional = true, .where = {0, 4, 0}, .color = glm::vec3(1)}};
    scene.materials = {{.name = "chalk", .diffuse = glm::vec3(1)}};
    scene.geometries = {{"square", scene::Plane{}}};
    scene.instances = {instance("floor", 0, {scene::Scale{{9, 1, 9}}}),
                       instance("roof", 0, {scene::Scale{{5, 1, 5}}, scene::Translate{{-5, 2, 0}}})};
    scene.lights[0].where.x = 0.05F;
    EXPECT_NEAR(centre_of(scene, {}).r, 1, 1e-3) << "a point of light, just in sight";
    scene.lights[0].where.x = -0.05F;
    EXPECT_NEAR(centre_of(scene, {}).r, 0, 1e-6) << "a point of light, just hidden";
    scene.lights[0].where.x = 0;
    scene.lights[0].radius = 0.5F;
    EXPECT_NEAR(centre_of(scene, {.rays = 1024}).r, 0.5, 0.01) << "half of the lamp is seen";
}

TEST(Rays, blur_by_the_lens_what_is_out_of_focus)
{
    // A wall's edge at twice the focused distance: the lens sees both sides of it by its area.
    scene::Scene scene = pane();
    scene.instances.erase(scene.instances.begin());
    scene.instances[0].transforms = {scene::Rotate{{1, 0, 0}, 90}, scene::Scale{{9, 9, 1}},
                                     scene::Translate{{9, 0, -4}}};
    scene.camera.fovy_degrees = 1;
    scene.camera.lens_radius = 0.3F;
    scene.camera.focus_distance = 4;
    const Frame blurred = draw_by_rays(make_draw_list(scene, 1, 1), 1, 1, {.rays = 1024});
    EXPECT_NEAR(blurred.color.at(0, 0).a, 0.5, 0.02);
    scene.camera.focus_distance = 8;
    const Frame sharp = draw_by_rays(make_draw_list(scene, 63, 63), 63, 63, {.rays = 16});
    EXPECT_EQ(sharp.color.at(2, 31).a, 0);
    EXPECT_EQ(sharp.color.at(60, 31).a, 1);
}

TEST(Rays, refuse_what_is_no_picture)
{
    const DrawList list = make_draw_list(bare(), 1, 1);
    EXPECT_THROW((void)draw_by_rays(list, 0, 1, {}), std::invalid_argument);
    EXPECT_THROW((void)draw_by_rays(list, 1, 16385, {}), std::invalid_argument);
    EXPECT_THROW((void)draw_by_rays(list, 1, 1, {.rays = 0}), std::invalid_argument);
}

}
}
