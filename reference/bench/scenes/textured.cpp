// Surfaces with pictures on them.

#include "scenes.hpp"
#include "shapes.hpp"
#include "staging.hpp"
#include "textures.hpp"

namespace umbral::bench::scenes {
namespace {

// About a texel a pixel, and in perspective.
Model dense(const Pose& pose)
{
    Model m = framed(pose, {0.5F, -0.9F, 2.6F});
    m.encoded = false;
    m.textures = {{.texels = weave(128)}};
    m.batches = {with_texture(
        solid(square(), pose.put({0, 0, 0}, 12 * pose.time(), {0, 0, 1}, glm::vec3(1.6F)), plain_paint()), 0, {2, 2})};
    return m;
}

Model checker_floor(const Pose& pose)
{
    Model m = framed(pose, {0, 1.1F, 3}, {0, 0.35F, -1});
    m.background = {0.55F, 0.72F, 0.90F, 1};
    m.camera.far = 200;
    m.textures = {{.texels = tiles(64, 2, {0.92F, 0.90F, 0.85F}, {0.15F, 0.17F, 0.2F}), .mipmaps = true}};
    m.batches = {with_texture(
        solid(ground(), pose.put({0, 0, -20}, 10 * pose.time(), {0, 1, 0}, {40, 1, 40}), plain_paint()), 0, {24, 24})};
    return m;
}

Model painted_vase(const Pose& pose)
{
    Model m = framed(pose, {0, 1.0F, 4.4F});
    m.background = {0.9F, 0.88F, 0.84F, 1};
    m.ambient = glm::vec3(0.25F);
    m.lights = {sun({1, 1, 1.4F}, glm::vec3(0.8F)), sun({-1, 0.3F, 0.5F}, {0.1F, 0.15F, 0.25F})};
    m.textures = {{.texels = painting(256)}};
    m.batches = {with_texture(solid(vase(64), pose.put({0, 0, 0}, 40 * pose.time(), {0.1F, 1, 0}, glm::vec3(1.25F)),
                                    glossy(glm::vec3(1), 0.35F, 30)),
                              0, {2, 1})};
    m.batches[0].cull = Cull::none;
    return m;
}

Model bumpy_wall(const Pose& pose)
{
    Model m = framed(pose, {0.5F, 0.3F, 3.0F});
    m.ambient = glm::vec3(0.12F);
    m.lights = {lamp({1.6F, 1.4F, 1.4F}, {0.9F, 0.85F, 0.75F}), sun({-1, 0.2F, 0.7F}, {0.1F, 0.12F, 0.22F})};
    m.textures = {{.texels = bumps(256)}};
    Material stone = glossy({0.75F, 0.6F, 0.5F}, 0.4F, 24);
    stone.style = Style::bumpy;
    m.batches = {
        with_texture(solid(square(), pose.put({0, 0, 0}, 25 * pose.time(), {0, 1, 0.2F}), stone), 0, {1.5F, 1.5F})};
    return m;
}

Model foliage(const Pose& pose)
{
    Model m = framed(pose, {0.6F, 0.9F, 4.2F}, {0, 0.1F, 0});
    m.background = {0.72F, 0.84F, 0.95F, 1};
    m.textures = {{.texels = leaves(256), .repeat = false}, {.texels = bricks(128)}};
    m.camera.far = 60;
    Material cut = plain_paint();
    cut.alpha_test = true;
    m.batches = {with_texture(
        solid(ground(), pose.put({0, -1, 0}, 0, {0, 1, 0}, {3, 1, 3}), plain_paint({0.7F, 0.75F, 0.65F, 1})), 1,
        {3, 3})};
    for (int i = 0; i < 6; ++i) {
        const float a = static_cast<float>(i);
        const Triangles card = square();
        Batch leaf = with_texture(solid(card,
                                        pose.put({0.9F * std::sin(a * 1.9F), 0.05F * a, 0.9F * std::cos(a * 1.9F)},
                                                 20 * a + 12 * pose.time()),
                                        cut),
                                  0);
        leaf.cull = Cull::none;
        m.batches.push_back(leaf);
    }
    return m;
}

// No background is left, and no third dimension.
Model full_picture(const Pose& pose)
{
    Model m = flat_picture(pose.size, pose.size, 2);
    m.textures = {{.texels = painting(200)}};
    m.batches = {with_texture(
        solid(square(2), pose.put({0.1F * pose.time(), 0, 0}, 0, {0, 0, 1}, glm::vec3(1.15F)), plain_paint()), 0,
        {1.5F, 1.5F})};
    return m;
}

Model textured_ball(const Pose& pose)
{
    Model m = framed(pose, {0, 0.8F, 3.4F});
    m.background = {0.03F, 0.03F, 0.06F, 1};
    m.ambient = glm::vec3(0.06F);
    m.lights = {sun({1.2F, 0.6F, 0.9F}, glm::vec3(1.1F))};
    m.textures = {{.texels = tiles(256, 8, {0.85F, 0.8F, 0.3F}, {0.2F, 0.35F, 0.6F})}};
    m.batches = {with_texture(solid(ball(64, 32), pose.put({0, 0, 0}, 30 * pose.time(), {0.2F, 1, 0}, glm::vec3(1.05F)),
                                    glossy(glm::vec3(1), 0.25F, 16)),
                              0, {2, 1})};
    return m;
}

}

std::vector<Scene> textured_scenes(int size)
{
    using namespace groups;
    using enum Flaw;
    return {
        model_scene("dense texture", "A woven cloth, about a texel a pixel.", Home::opengl, size, dense,
                    {any,
                     placed,
                     textured,
                     {affine_uv, nearest_for_linear, half_texel_off, clamp_for_repeat, missing_triangle, rotation_sign,
                      stale_frame, brightness_3_percent, sample_at_corner}}),
        model_scene("checker floor", "Tiles up to the horizon, filtered by mipmaps.", Home::opengl, size, checker_floor,
                    {placed,
                     textured,
                     {affine_uv, nearest_for_linear, half_texel_off, clamp_for_repeat, no_mipmaps,
                      near_clipping_missing, far_plane_too_near, near_plane_too_far, half_pixel_centre, gamma_twice,
                      stale_frame, shifted_one_pixel, blank}}),
        model_scene("painted vase", "A picture round a vase, lit.", Home::software, size, painted_vase,
                    {placed,
                     meshes,
                     textured,
                     encoded,
                     {abs_cosine, ambient_missing, one_light_missing, brightness_5_percent, clamp_for_repeat,
                      nearest_for_linear, half_texel_off, stale_frame, sample_at_corner, phong_for_blinn}},
                    {Way::light_in_world_space}),
        model_scene(
            "textured ball", "A tiled ball in the dark.", Home::software, size, textured_ball,
            {placed,
             textured,
             encoded,
             {nearest_for_linear, half_texel_off, ambient_missing, abs_cosine, flat_for_smooth, missing_triangle,
              stale_frame, cracks, clamp_for_repeat, brightness_3_percent, half_pixel_centre, upside_down}},
            {Way::light_in_world_space}),
        model_scene("bumpy wall", "A wall whose bumps are in a normal map.", Home::opengl, size, bumpy_wall,
                    {placed,
                     textured,
                     {bump_not_decoded, bump_green_inverted, one_light_missing, light_in_wrong_space, affine_uv,
                      ambient_missing, phong_for_blinn, shininess_halved, half_texel_off, stale_frame, viewer_fixed,
                      half_pixel_centre, gamma_twice, abs_cosine}},
                    {Way::light_in_world_space, Way::lights_reversed}),
        model_scene("foliage", "Leaves cut out by alpha, before a brick floor.", Home::opengl, size, foliage,
                    {any,
                     placed,
                     {alpha_test_missing, alpha_threshold_wrong, nearest_for_linear, depth_test_off, depth_inverted,
                      v_flipped, u_mirrored, rotation_sign, stale_frame, half_texel_off, front_faces_culled,
                      gamma_missing, missing_triangle}}),
        model_scene("full picture", "Colours from edge to edge, without background.", Home::software, size,
                    full_picture,
                    {any,
                     textured,
                     {nearest_for_linear, half_texel_off, clamp_for_repeat, missing_triangle, stale_frame,
                      sixteen_levels, gamma_twice, brightness_3_percent, brightness_5_percent, green_5_percent,
                      camera_1_percent_off, fov_3_percent_wrong, mirrored}}),
    };
}

}
