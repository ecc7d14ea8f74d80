#include <gtest/gtest.h>

#include <optional>
#include <umbral/gl/context.hpp>

#include "three_ways.hpp"

// Why OpenGL's fixed function, shaders and software differ: what docs/agreement.md says of each class of differences.

using namespace umbral;
using namespace umbral::lighting;

namespace {

class ThreeWays : public testing::Test {
protected:
    static constexpr int size = 192;

    ThreeWays()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        shaders_.reset(new gl::Program(reference_shaders()));
    }
    [[nodiscard]] Grid<glm::vec3> shaders(const LitScene& scene) const { return by_shaders(scene, size, *shaders_); }
    static Grid<glm::vec3> fixed(const LitScene& scene) { return by_fixed_function(scene, size); }
    static Grid<glm::vec3> software(const LitScene& scene) { return in_software(scene, size); }
    static Grid<glm::vec3> at_vertices(const LitScene& scene) { return light_at_vertices(scene, size); }

private:
    std::optional<gl::OffscreenContext> context_;
    std::unique_ptr<gl::Program> shaders_;
};

}

TEST_F(ThreeWays, shaders_and_software_agree_to_what_float_can_hold)
{
    for (const float e : {1.0F, 30.0F, 128.0F, 400.0F}) {
        const Distance apart = distance(shaders(ball(48, 0.5F, e)), software(ball(48, 0.5F, e)));
        EXPECT_LE(apart.largest, 1e-4) << e;
        EXPECT_LE(apart.rms, 2e-6) << e;
        EXPECT_GT(apart.pixels, size * size / 4);
    }
}

// All that the fixed function does otherwise in these scenes is where it computes the light.
TEST_F(ThreeWays, the_fixed_function_is_light_at_vertices)
{
    LitScene flat = ball(24, 0.5F, 30);
    flat.lighting.flat_shading = true;
    LitScene distant = ball(24, 0.5F, 30);
    distant.lighting.local_viewer = false;
    for (const LitScene& scene : {ball(16, 0, 1), ball(24, 0.5F, 30), ball(64, 0.5F, 128), flat, distant}) {
        EXPECT_LE(distance(fixed(scene), at_vertices(scene)).largest, 1e-4);
        EXPECT_GT(distance(fixed(scene), shaders(scene)).largest, 5e-3);
    }
}

// Twice as many triangles in each direction, a quarter of the error: what linear interpolation leaves.
TEST_F(ThreeWays, finer_meshes_bring_vertices_and_pixels_together)
{
    double before = 0;
    for (const int longitudes : {16, 32, 64, 128}) {
        const LitScene scene = ball(longitudes, 0, 1);
        const double apart = distance(fixed(scene), software(scene)).rms;
        if (before > 0) {
            EXPECT_GT(before / apart, 2.5) << longitudes;
            EXPECT_LT(before / apart, 5) << longitudes;
        }
        before = apart;
    }
}

TEST_F(ThreeWays, the_fixed_function_takes_large_exponents_for_128)
{
    LitScene scene = ball(64, 0.5F, 400);
    const Grid<glm::vec3> drawn = fixed(scene);
    EXPECT_GT(distance(drawn, at_vertices(scene)).largest, 0.05);
    scene.things.front().material.shininess = 128;
    EXPECT_LE(distance(drawn, at_vertices(scene)).largest, 1e-4);
}

TEST_F(ThreeWays, the_shaders_know_no_distant_viewer)
{
    LitScene scene = ball(128, 0.5F, 30);
    const Grid<glm::vec3> near = shaders(scene);
    scene.lighting.local_viewer = false;
    EXPECT_EQ(distance(shaders(scene), near).largest, 0);
    EXPECT_GT(distance(shaders(scene), software(scene)).largest, 0.05);
    EXPECT_LE(distance(fixed(scene), software(scene)).largest, 0.02) << "vertices against pixels alone";
}

// glLight called before the camera stands: the same numbers, in the camera's frame.
TEST_F(ThreeWays, positions_are_taken_to_the_eye_when_they_are_set)
{
    LitScene late = ball(128, 0, 1);
    LitScene early = late;
    early.lighting.lights.front().frame = LightFrame::camera;
    EXPECT_GT(distance(fixed(early), software(late)).largest, 0.05);
    EXPECT_LE(distance(fixed(early), software(early)).largest, 5e-3) << "vertices against pixels alone";
}

// Cut off at the vertices, a colour is interpolated from 1; cut off at the end, from what it was.
TEST_F(ThreeWays, clamping_at_vertices_spreads_less_light)
{
    LitScene scene = ball(24, 0.5F, 30);
    for (PlacedLight& placed : scene.lighting.lights) placed.light.color *= 3.0F;
    const Grid<glm::vec3> early = by_fixed_function(scene, size, Clamping::at_vertices);
    const Grid<glm::vec3> late = cut_off(fixed(scene));
    EXPECT_GT(distance(early, late).largest, 0.02);
    for (std::size_t i = 0; i < early.cells.size(); ++i) ASSERT_LE(early.cells[i].r, late.cells[i].r + 1e-5F);
}

// The shaders ask gl_FrontFacing, which a mirror exchanges; draw_lit says so with glFrontFace.
TEST_F(ThreeWays, the_shaders_turn_the_normals_of_mirrored_things_inwards)
{
    LitScene scene = ball(128, 0, 1);
    scene.things.front().model = glm::scale(scene.things.front().model, {-1, 1, 1});
    EXPECT_GT(distance(fixed(scene), shaders(scene)).largest, 0.1);
    const Grid<glm::vec3> mirrored = fixed(scene);
    std::vector<std::uint32_t>& indices = scene.meshes.front().indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i], indices[i + 1]);
    EXPECT_LE(distance(mirrored, shaders(scene)).largest, 5e-3) << "vertices against pixels alone";
}
