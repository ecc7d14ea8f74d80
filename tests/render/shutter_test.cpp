#include "render/rays/shutter.hpp"

#include <gtest/gtest.h>

#include "render/rays/ray_effects.hpp"
#include "scene/motion.hpp"
#include "scenes.hpp"

// What moves while the shutter is open, against shares of time that can be worked out on paper.
namespace umbral::render::rays::test {
namespace {

using render::test::bare;
using render::test::instance;

/// A shining square of side 2 that moves along x; it stands in the middle of the picture at time 0.
scene::Scene passing(float velocity, float shutter_seconds)
{
    scene::Scene scene = bare();
    scene.lights.clear();
    scene.materials = {{.name = "shining", .emission = glm::vec3(1), .diffuse = glm::vec3(0)}};
    scene.geometries.push_back({"square", scene::Plane{}});
    scene::Instance square =
        instance("square", scene.geometries.size() - 1, {scene::Rotate{{1, 0, 0}, 90}, scene::Move{{velocity, 0, 0}}});
    square.sides = scene::Sides::both;
    scene.instances = {square};
    scene.camera.shutter_seconds = shutter_seconds;
    return scene;
}

TEST(Shutter, shows_as_much_of_a_thing_as_the_time_that_it_is_there)
{
    // The square's edge, at first a unit beside the middle, crosses it after so many seconds, of two.
    for (const float velocity : {0.75F, 1.0F, 2.0F, 8.0F}) {
        const Frame frame = draw_with_open_shutter(passing(velocity, 2), 0, 1, 1, {.rays = 1});
        EXPECT_EQ(frame.color.at(0, 0).a, 1) << "one ray sees one moment";
        scene::Scene scene = passing(velocity, 2);
        scene.camera.fovy_degrees = 1;
        const Frame blurred = draw_with_open_shutter(scene, 0, 1, 1, {.rays = 640});
        EXPECT_NEAR(blurred.color.at(0, 0).a, std::min(1.0F, 1 / velocity / 2), 1.0 / 64) << velocity;
        EXPECT_NEAR(blurred.color.at(0, 0).r, blurred.color.at(0, 0).a, 1e-6F) << velocity;
    }
    // It opens when half of the way is behind.
    scene::Scene scene = passing(1, 1);
    scene.camera.fovy_degrees = 1;
    EXPECT_NEAR(draw_with_open_shutter(scene, 0.5, 1, 1, {.rays = 640}).color.at(0, 0).a, 0.5, 1.0 / 64);
    EXPECT_EQ(draw_with_open_shutter(scene, 1.5, 1, 1, {.rays = 64}).color.at(0, 0).a, 0);
}

TEST(Shutter, changes_nothing_where_nothing_moves)
{
    scene::Scene scene = passing(0, 2);
    scene.instances[0].transforms = {scene::Rotate{{1, 0.2F, 0}, 70}};
    EXPECT_FALSE(is_blurred_by_motion(scene));
    const Effort effort{.rays = 9};
    const Frame open = draw_with_open_shutter(scene, 3, 24, 16, effort);
    const Frame expected = draw_by_rays(make_draw_list(scene, 24, 16, true), 24, 16, effort);
    EXPECT_EQ(open.color.cells, expected.color.cells);
    EXPECT_EQ(open.depth.cells, expected.depth.cells);
    EXPECT_EQ(open.ids.cells, expected.ids.cells);
}

TEST(Shutter, of_a_standing_thing_the_moments_make_the_picture_of_one)
{
    // Something out of sight moves: there are many moments, and all look alike.
    scene::Scene scene = passing(0, 2);
    scene.instances[0].transforms = {scene::Rotate{{1, 0.2F, 0}, 70}};
    scene::Instance far = scene.instances[0];
    far.transforms = {scene::Move{{1, 0, 0}}, scene::Translate{{0, 0, 50}}};
    scene.instances.push_back(far);
    ASSERT_TRUE(is_blurred_by_motion(scene));
    const Effort effort{.rays = 7};
    const Frame moments = draw_with_open_shutter(scene, 0, 24, 16, effort);
    const Frame expected = draw_by_rays(make_draw_list(scene::at_time(scene, 0), 24, 16, true), 24, 16, effort);
    for (std::size_t i = 0; i < expected.color.cells.size(); ++i)
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(moments.color.cells[i][channel], expected.color.cells[i][channel], 1e-6F);
    EXPECT_EQ(moments.depth.cells, expected.depth.cells);
}

TEST(Shutter, gives_the_same_picture_by_any_number_of_threads)
{
    const scene::Scene scene = passing(1, 1.5F);
    const Frame one = draw_with_open_shutter(scene, 0, 20, 20, {.rays = 12, .threads = 1});
    const Frame three = draw_with_open_shutter(scene, 0, 20, 20, {.rays = 12, .threads = 3});
    EXPECT_EQ(one.color.cells, three.color.cells);
}

TEST(RayEffects, are_called_for_by_what_is_in_the_scene)
{
    const auto called_for = [](const scene::Scene& scene) {
        std::string names;
        for (const RayEffect& effect : ray_effects(scene))
            if (effect.called_for) names += std::string(effect.name) + ": " + effect.why + "; ";
        return names;
    };
    EXPECT_EQ(called_for(passing(1, 0)), "");
    EXPECT_EQ(called_for(passing(1, 0.5F)),
              "shutter: instance \"square\" moves in the 0.5 s that the shutter is open; ");
    scene::Scene scene = bare();
    scene.lights = {{.name = "lamp", .positional = true, .radius = 0.25F}};
    scene.materials[0].transmit = glm::vec3(1);
    scene.materials[0].name = "pane";
    scene.camera.lens_radius = 0.5F;
    scene.bounces = 2;
    EXPECT_EQ(
        called_for(scene),
        "shadows: light \"lamp\" may be hidden; soft: light \"lamp\" has a size; glass: material \"pane\" lets light "
        "through; lens: the camera's lens has a radius of 0.5; indirect: light goes on from surface to surface, 2 "
        "times at most; ");
}

}
}
