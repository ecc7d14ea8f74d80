#include <gtest/gtest.h>

#include <lighting/fixed-pipeline/scenes.hpp>
#include <optional>
#include <umbral/gl/context.hpp>

#include "exact_light.hpp"

// Linked with the reference. What is expected is the formula in double, numbers of the statement, and laws.

using namespace umbral;
using namespace umbral::lighting;

namespace {

class FixedPipeline : public testing::Test {
protected:
    FixedPipeline()
    {
        gl::forbid_driver_threads();
        context_.emplace();
    }

    /// A scene as light, 64 x 64.
    static Grid<glm::vec3> drawn(const LitScene& scene)
    {
        const LinearFrame frame(64, 64);
        glEnable(GL_DEPTH_TEST);
        draw_lit(scene);
        return frame.light();
    }

private:
    std::optional<gl::OffscreenContext> context_;
};

double largest_difference(const Grid<glm::vec3>& a, const Grid<glm::vec3>& b)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.cells.size(); ++i)
        worst = std::max(worst, largest(glm::dvec3(a.cells[i]) - glm::dvec3(b.cells[i])));
    return worst;
}

}

// The statement's numbers.
TEST_F(FixedPipeline, known_answers)
{
    const PlacedLight lamp{{{1, 2, 3, 1}, glm::vec3(1)}, LightFrame::world};
    const PlacedLight torch{{{1, 2, 3, 1}, glm::vec3(1)}, LightFrame::camera};
    FrameLighting lighting;
    lighting.lights = {lamp, torch};
    set_lighting(lighting, glm::translate(glm::mat4(1), {0, 0, -10}));
    EXPECT_EQ(position_of_light(0), glm::vec4(1, 2, -7, 1));
    EXPECT_EQ(position_of_light(1), glm::vec4(1, 2, 3, 1));

    Probe probe;
    probe.position = {0, 0, -4};
    probe.material = {glm::vec3(0.05F), glm::vec3(0.1F), glm::vec3(0.5F), glm::vec3(0.4F), 4};
    probe.lighting.lights = {{{{0, 0.6F, 0.8F, 0}, glm::vec3(1)}, LightFrame::camera}};
    probe.lighting.global_ambient = glm::vec3(0.2F);
    const LinearFrame frame(1, 1);
    EXPECT_NEAR(light_by_opengl(frame, probe).r, 0.894, 1e-5);
}

TEST_F(FixedPipeline, light_is_what_the_formula_says_whatever_was_set_before)
{
    constexpr std::uint64_t seed = 20441;
    Random random(seed);
    const LinearFrame frame(1, 1);
    for (int i = 0; i < 200; ++i) {
        disturb(random);
        const Probe probe = random_probe(random);
        if (is_grazed(probe)) continue;
        // Backs are seen as triangles, across which OpenGL interpolates.
        const double tolerance = probe.seen_from_behind ? 1e-3 : 2e-4;
        ASSERT_LE(largest(light_by_opengl(frame, probe) - exact_light(probe)), tolerance)
            << "seed " << seed << ", " << i;
    }
    for (const Probe& probe : probes_by_hand())
        EXPECT_LE(largest(light_by_opengl(frame, probe) - exact_light(probe)), 2e-4);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(FixedPipeline, a_scene_leaves_the_state_as_it_was)
{
    constexpr std::uint64_t seed = 20442;
    Random random(seed);
    const LinearFrame frame(16, 16);
    for (int i = 0; i < 12; ++i) {
        const LitScene scene = random_scene(random, coin(random));
        disturb(random);
        const std::vector<float> before = neutral_state();
        draw_lit(scene);
        ASSERT_EQ(neutral_state(), before) << "seed " << seed << ", " << i;
    }
}

// The mirror image of a scene, seen in a mirror, is the scene.
TEST_F(FixedPipeline, mirrored_things_are_lit_as_their_image_is)
{
    const glm::mat4 mirror = glm::scale(glm::mat4(1), {-1, 1, 1});
    LitScene scene = mirrored();
    const Grid<glm::vec3> straight = drawn(scene);
    for (LitThing& thing : scene.things) thing.model = mirror * thing.model;
    for (PlacedLight& placed : scene.lighting.lights) placed.light.position.x *= -1;
    Grid<glm::vec3> image = drawn(scene);
    for (int y = 0; y < 64; ++y) std::reverse(image.cells.begin() + 64 * y, image.cells.begin() + 64 * (y + 1));
    int different = 0;
    for (std::size_t i = 0; i < image.cells.size(); ++i)
        different += largest(glm::dvec3(straight.cells[i]) - glm::dvec3(image.cells[i])) > 0.01 ? 1 : 0;
    EXPECT_LE(different, 40) << "pixels of outlines, whose centres an edge crosses";
}

TEST_F(FixedPipeline, light_adds_up_and_no_colour_is_cut_off)
{
    LitScene scene = stretched();
    const Grid<glm::vec3> both = drawn(scene);
    scene.lighting.global_ambient = glm::vec3(0);
    LitScene other = scene;
    scene.lighting.lights.pop_back();
    other.lighting.lights.erase(other.lighting.lights.begin());
    other.lighting.global_ambient = glm::vec3(0.2F);
    Grid<glm::vec3> sum = drawn(scene);
    const Grid<glm::vec3> rest = drawn(other);
    for (std::size_t i = 0; i < sum.cells.size(); ++i) sum.cells[i] += rest.cells[i];
    EXPECT_LE(largest_difference(both, sum), 1e-5);

    for (PlacedLight& placed : other.lighting.lights) placed.light.color *= 1000.0F;
    other.lighting.global_ambient *= 1000.0F;
    Grid<glm::vec3> bright = drawn(other);
    for (glm::vec3& light : bright.cells) light /= 1000.0F;
    EXPECT_LE(largest_difference(bright, rest), 1e-5);
}
