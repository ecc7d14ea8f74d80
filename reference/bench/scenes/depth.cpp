// What is in front of what, near and far.

#include <cmath>
#include <umbral/core/random.hpp>

#include "scenes.hpp"
#include "shapes.hpp"
#include "staging.hpp"
#include "textures.hpp"

namespace umbral::bench::scenes {
namespace {

Model intersecting(const Pose& pose)
{
    Model m = framed(pose, {1.6F, 2.0F, 4.4F});
    m.background = {0.93F, 0.93F, 0.95F, 1};
    m.lights = {sun({1, 1.6F, 0.8F}, glm::vec3(0.75F)), sun({-1, 0.4F, 0.5F}, {0.2F, 0.2F, 0.3F})};
    m.batches = {
        solid(torus(0.38F, 64, 32), pose.put({0, 0, 0}, 70 * pose.time(), {1, 0, 0.2F}), glossy({0.85F, 0.3F, 0.25F})),
        solid(torus(0.3F, 64, 32), pose.put({0.2F, 0.1F, 0.1F}, 20 * pose.time(), {0, 0, 1}),
              glossy({0.25F, 0.55F, 0.85F})),
        solid(box(glm::vec3(0.62F)), pose.put({0, 0, 0}, 30 * pose.time(), {0.4F, 1, 0.2F}),
              glossy({0.95F, 0.8F, 0.35F}, 0.2F, 10)),
        solid(gem(1), pose.put({-0.9F, 0.6F, 0.5F}, 0, {0, 1, 0}, glm::vec3(0.6F)), glossy({0.4F, 0.75F, 0.4F}))};
    return m;
}

// Boxes with signs painted on them, hundreds of units away.
Model far_away(const Pose& pose)
{
    Model m = framed(pose, {0, 90, 620}, {0, 25, 0});
    m.background = {0.70F, 0.80F, 0.90F, 1};
    m.camera.fovy_degrees = 22;
    m.camera.near = 100;
    m.camera.far = 2000;
    m.ambient = glm::vec3(0.25F);
    m.lights = {sun({1, 1.2F, 1.5F}, glm::vec3(0.75F))};
    m.batches = {solid(ground(), pose.put({0, 0, 0}, 0, {0, 1, 0}, {260, 1, 260}), glossy({0.35F, 0.5F, 0.28F}, 0, 1))};
    Random random(17);
    for (int i = 0; i < 9; ++i) {
        const glm::vec3 at(static_cast<float>(i % 3 - 1) * 68, 0, static_cast<float>(1 - i / 3) * 90);
        const float height = random.uniform(18, 46);
        const glm::vec3 wall(random.uniform(0.5F, 0.9F), random.uniform(0.45F, 0.7F), random.uniform(0.35F, 0.6F));
        const float turn = random.uniform(-25, 25) + 6 * pose.time();
        m.batches.push_back(
            solid(box({20, height, 20}), pose.put(at + glm::vec3(0, height, 0), turn), glossy(wall, 0, 1)));
        const glm::mat4 front = pose.put(at + glm::vec3(0, height, 0), turn);
        for (int k = 0; k < 2; ++k) {
            Triangles window = square();
            for (Vertex& v : window)
                v.position = {static_cast<float>(2 * k - 1) * 9 + 5.5F * v.position.x,
                              0.35F * height + 0.3F * height * v.position.y, 20};
            Batch sign = solid(window, front, glossy({0.1F, 0.15F, 0.3F}, 0, 1));
            sign.depth_offset = 2e-4F;
            m.batches.push_back(sign);
        }
    }
    return m;
}

Model in_fog(const Pose& pose)
{
    Model m = framed(pose, {1.2F, 1.5F, 5}, {0, 0.6F, -4});
    m.background = {0.74F, 0.77F, 0.80F, 1};
    m.fog = {{0.5153F, 0.5625F, 0.6120F}, 0.1F};
    m.lights = {sun({1, 1.5F, 1}, glm::vec3(0.8F))};
    constexpr glm::vec2 outline[] = {{0.4F, 0},     {0.4F, 0.15F}, {0.28F, 0.25F}, {0.24F, 1.2F},
                                     {0.26F, 2.0F}, {0.4F, 2.15F}, {0.42F, 2.3F}};
    const Triangles column = lathe(outline, 32);
    m.batches = {
        solid(ground(12), pose.put({0, 0, -8}, 0, {0, 1, 0}, {5, 1, 14}), glossy({0.55F, 0.5F, 0.4F}, 0.1F, 8))};
    for (int i = 0; i < 12; ++i)
        m.batches.push_back(solid(
            column,
            pose.put({i % 2 == 0 ? -1.5F : 1.5F, 0, 2.5F - 2.4F * static_cast<float>(i / 2) + 0.4F * pose.time()}),
            glossy({0.8F, 0.55F, 0.4F}, 0.3F, 20)));
    for (Batch& batch : m.batches) batch.cull = Cull::none;
    return m;
}

// The walls reach behind the camera.
Model corridor(const Pose& pose)
{
    Model m = framed(pose, {0.3F, 0.1F, 3.5F + 0.1F * pose.time()}, {0, 0, 0});
    m.camera.fovy_degrees = 65;
    m.camera.near = 0.3F;
    m.ambient = glm::vec3(0.3F);
    m.lights = {lamp({0, 0.7F, 1}, glm::vec3(0.8F))};
    m.lights[0].falloff = {0.6F, 0.1F, 0.06F};
    m.textures = {{.texels = bricks(128)}, {.texels = tiles(64, 2, {0.8F, 0.8F, 0.75F}, {0.25F, 0.3F, 0.35F})}};
    const auto wall = [&](float side) {
        Batch b = with_texture(
            solid(square(), pose.put({side, 0, 0}, -90 * side, {0, 1, 0}, {6, 1, 1}), glossy(glm::vec3(1), 0.1F, 8)), 0,
            {6, 2});
        b.cull = Cull::none;
        return b;
    };
    m.batches = {solid(ball(40, 20), pose.put({0.35F, -0.45F, 1.2F}, 0, {0, 1, 0}, glm::vec3(0.4F)),
                       glossy({0.9F, 0.7F, 0.2F}))};
    for (const float side : {-1.0F, 1.0F}) m.batches.push_back(wall(side));
    Batch floor_of = with_texture(
        solid(ground(), pose.put({0, -1, 0}, 0, {0, 1, 0}, {1, 1, 6}), glossy(glm::vec3(1), 0.2F, 10)), 1, {2, 12});
    floor_of.cull = Cull::none;
    Batch ceiling = solid(ground(), pose.put({0, 1, 0}, 180, {0, 0, 1}, {1, 1, 6}), glossy({0.8F, 0.75F, 0.7F}, 0, 1));
    ceiling.cull = Cull::none;
    m.batches.push_back(floor_of);
    m.batches.push_back(ceiling);
    return m;
}

// An engineering drawing: parallel projection, with a frame round it.
Model engineering(const Pose& pose)
{
    Model m = framed(pose, {0, 0, 6});
    m.width = pose.size * 4 / 3;
    m.camera.ortho_height = 3;
    m.background = {1, 1, 1, 1};
    m.encoded = false;
    m.ambient = glm::vec3(0.3F);
    m.lights = {sun({-1, 1.5F, 2}, glm::vec3(0.65F))};
    constexpr glm::vec2 outline[] = {{0.02F, -0.5F}, {0.55F, -0.5F}, {0.55F, 0.1F},
                                     {0.3F, 0.15F},  {0.3F, 0.7F},   {0.02F, 0.7F}};
    const glm::vec3 axis(1, -0.6F, 0.2F);
    const float degrees = 25 + 10 * pose.time();
    m.batches = {solid(box({1.0F, 0.16F, 0.7F}), pose.put({-0.2F, -0.4F, 0}, degrees, axis),
                       glossy({0.75F, 0.77F, 0.8F}, 0.3F, 20)),
                 solid(lathe(outline, 40), pose.put({-0.1F, 0.2F, 0.3F}, degrees, axis),
                       glossy({0.55F, 0.65F, 0.75F}, 0.3F, 20)),
                 solid(box({0.12F, 0.5F, 0.12F}), pose.put({1.1F, 0.2F, 0}, degrees, axis),
                       glossy({0.8F, 0.6F, 0.4F}, 0.3F, 20))};
    m.batches[1].cull = Cull::none;
    Batch frame = solid({}, glm::mat4(1), plain_paint());
    frame.edge_corners = 6;
    const float width = pose.flaw == Flaw::line_width_wrong ? 0.05F : 0.024F;
    const glm::vec4 ink(0.1F, 0.1F, 0.15F, 1);
    const glm::vec2 corners[] = {{-1.9F, -1.4F}, {1.9F, -1.4F}, {1.9F, 1.4F}, {-1.9F, 1.4F}};
    for (int i = 0; i < 4; ++i) add_stroke(frame.corners, corners[i], corners[(i + 1) % 4], width, ink);
    for (int i = 0; i < 5; ++i)
        add_stroke(frame.corners, {0.9F, -1.36F + 0.12F * static_cast<float>(i)},
                   {1.86F, -1.36F + 0.12F * static_cast<float>(i)}, width, ink);
    add_stroke(frame.corners, {-1.7F, 1.0F}, {-0.3F, 1.25F}, width, ink);
    for (Vertex& v : frame.corners) v.position.z = 2;
    m.batches.push_back(frame);
    return m;
}

Model tiny(const Pose& pose)
{
    Model m = flat_picture(pose.size, pose.size, 2);
    m.background = {0.88F, 0.88F, 0.88F, 1};
    const float t = 0.05F * pose.time();
    Triangles one = {{{0.21F + t, 0.30F, 0}, {0, 0, 1}, {0, 0}, {0.9F, 0.1F, 0.1F, 1}},
                     {{0.30F + t, 0.33F, 0}, {0, 0, 1}, {1, 0}, {0.1F, 0.7F, 0.1F, 1}},
                     {{0.24F + t, 0.42F, 0}, {0, 0, 1}, {0, 1}, {0.1F, 0.2F, 0.9F, 1}}};
    m.batches = {solid(one, glm::mat4(1), plain_paint())};
    return m;
}

}

std::vector<Scene> depth_scenes(int size)
{
    using namespace groups;
    using enum Flaw;
    return {
        model_scene("intersecting meshes", "Two rings, a box and a ball that pass through each other.", Home::software,
                    size, intersecting,
                    {placed,
                     meshes,
                     encoded,
                     {depth_inverted, depth_test_off, rotation_sign, stale_frame, one_light_missing, ambient_twice,
                      phong_for_blinn, near_plane_too_far, flat_for_smooth, half_pixel_centre, shifted_one_pixel,
                      light_in_wrong_space}},
                    {Way::light_in_world_space}),
        model_scene("far scene", "Houses with windows, hundreds of units away.", Home::opengl, size, far_away,
                    {placed,
                     {z_fighting, near_plane_tiny, depth_inverted, depth_test_off, far_plane_too_near,
                      near_plane_too_far, front_faces_culled, missing_triangle, ambient_missing, light_in_wrong_space,
                      stale_frame, half_pixel_centre, gamma_missing, rotation_sign, shifted_one_pixel}},
                    {Way::light_in_world_space}),
        model_scene("fog", "Columns that fade in the distance.", Home::software, size, in_fog,
                    {placed,
                     encoded,
                     {fog_missing, fog_factor_wrong, ambient_missing, missing_triangle, cracks, depth_inverted,
                      depth_test_off, far_plane_too_near, near_plane_too_far, stale_frame, phong_for_blinn,
                      brightness_3_percent, half_pixel_centre, mirrored}},
                    {Way::light_in_world_space}),
        model_scene("corridor", "Walls that reach behind the camera.", Home::opengl, size, corridor,
                    {placed,
                     textured,
                     encoded,
                     {near_clipping_missing, affine_uv, clamp_for_repeat, nearest_for_linear, attenuation_missing,
                      stale_frame, depth_inverted, depth_test_off, near_plane_too_far, light_in_wrong_space,
                      ambient_missing, shifted_one_pixel}},
                    {Way::light_in_world_space}),
        model_scene(
            "engineering view", "A machine part in parallel projection, in a frame.", Home::software, size, engineering,
            {any,
             placed,
             {missing_edge, line_width_wrong, aspect_ignored, missing_triangle, cracks, depth_inverted, depth_test_off,
              rotation_sign, stale_frame, phong_for_blinn, ambient_twice, gamma_twice, front_faces_culled, mirrored}},
            {Way::light_in_world_space}),
        model_scene("tiny triangle", "One triangle of some fifty pixels.", Home::opengl, size, tiny,
                    {any,
                     {stale_frame, flat_for_smooth, gamma_twice, brightness_5_percent, sixteen_levels,
                      fov_3_percent_wrong, camera_1_percent_off, sample_at_corner, mirrored, upside_down}}),
    };
}

}
