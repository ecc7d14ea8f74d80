// What lets through what is behind it.

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>

#include "scenes.hpp"
#include "shapes.hpp"
#include "staging.hpp"
#include "textures.hpp"

namespace umbral::bench::scenes {
namespace {

Model panes(const Pose& pose)
{
    Model m = framed(pose, {0.6F, 0.5F, 4.6F});
    m.background = {0.85F, 0.87F, 0.9F, 1};
    m.encoded = false;
    m.lights = {sun({1, 1, 1}, glm::vec3(0.8F))};
    m.batches = {
        solid(ball(48, 24), pose.put({0.1F, -0.1F, -1.2F}, 0, {0, 1, 0}, glm::vec3(0.8F)), glossy({0.9F, 0.8F, 0.5F}))};
    const glm::vec4 colors[] = {{0.9F, 0.2F, 0.2F, 0.5F},
                                {0.2F, 0.6F, 0.25F, 0.45F},
                                {0.2F, 0.3F, 0.85F, 0.5F},
                                {0.9F, 0.8F, 0.1F, 0.4F},
                                {0.5F, 0.1F, 0.6F, 0.35F}};
    for (int i = 0; i < 5; ++i) {
        const float t = static_cast<float>(i);
        m.batches.push_back(layer(square(2),
                                  pose.put({0.5F * std::cos(1.3F * t), 0.45F * std::sin(1.3F * t), 0.3F * t - 0.3F},
                                           20 * t + 8 * pose.time(), {0, 0, 1}, glm::vec3(0.62F)),
                                  plain_paint(colors[i])));
    }
    return m;
}

Model glows(const Pose& pose)
{
    Model m = flat_picture(pose.size, pose.size, 2);
    m.background = {0.02F, 0.02F, 0.05F, 1};
    m.textures = {{.texels = glow(128), .repeat = false}};
    Random random(21);
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 at(random.uniform(-0.8F, 0.8F), random.uniform(-0.8F, 0.8F), 0);
        const float radius = random.uniform(0.15F, 0.5F);
        const glm::vec4 color(random.uniform(0.1F, 0.7F), random.uniform(0.1F, 0.5F), random.uniform(0.2F, 0.8F), 0.8F);
        Batch disc = with_texture(
            layer(square(), pose.put(at + glm::vec3(0.06F * pose.time(), 0, 0), 0, {0, 0, 1}, glm::vec3(radius)),
                  plain_paint(color), Blend::add),
            0);
        disc.depth_test = false;
        m.batches.push_back(disc);
    }
    return m;
}

// Points as squares that face the viewer, from back to front.
Model sprites(const Pose& pose)
{
    Model m = framed(pose, {0, 0, 5});
    m.background = {0.12F, 0.2F, 0.28F, 1};
    m.encoded = false;
    m.textures = {{.texels = glow(64), .repeat = false}};
    Random random(31);
    std::vector<glm::vec3> places;
    for (int i = 0; i < 150; ++i) {
        const float a = 0.25F * static_cast<float>(i) + 0.1F * pose.time();
        const float r = 0.2F + 0.009F * static_cast<float>(i);
        places.emplace_back(r * std::cos(a), 0.25F * random.uniform(-1, 1) + 0.6F * r * std::sin(a), r * std::sin(a));
    }
    std::sort(places.begin(), places.end(), [](const glm::vec3& a, const glm::vec3& b) { return a.z < b.z; });
    Batch all = with_texture(layer({}, glm::mat4(1), plain_paint()), 0);
    for (const glm::vec3& at : places) {
        const float warm = random.uniform();
        for (Vertex v : square()) {
            v.position = at + 0.13F * v.position;
            v.color = glm::vec4(glm::mix(glm::vec3(0.3F, 0.7F, 1), glm::vec3(1, 0.6F, 0.2F), warm), 0.95F);
            all.corners.push_back(v);
        }
    }
    m.batches = {all};
    return m;
}

Model glass(const Pose& pose)
{
    Model m = framed(pose, {0, 1.6F, 3.3F});
    m.background = {0.95F, 0.95F, 0.92F, 1};
    m.lights = {sun({1, 1.5F, 1}, glm::vec3(0.8F))};
    m.textures = {{.texels = tiles(64, 4, {0.9F, 0.85F, 0.8F}, {0.3F, 0.3F, 0.35F})}};
    Batch green = layer(knot(0.2F, 160, 20), pose.put({0, 0.1F, 0}, 25 * pose.time(), {0.3F, 1, 0}),
                        glossy({0.2F, 0.7F, 0.5F}, 0.7F, 40));
    green.material.color.a = 0.55F;
    green.cull = Cull::back;
    m.batches = {
        with_texture(solid(ground(), pose.put({0, -0.7F, 0}, 0, {0, 1, 0}, {2, 1, 2}), plain_paint()), 0, {3, 3}),
        green};
    return m;
}

// Wider than high.
Model gradient(const Pose& pose)
{
    Model m = framed(pose, {0, 0, 3});
    m.width = pose.size * 3 / 2;
    m.encoded = false;
    Triangles sheet = square(pose.flaw == Flaw::flat_for_smooth ? 8 : 1);
    paint(sheet, [](const Vertex& v) {
        return glm::vec4(0.15F + 0.75F * v.uv.x, 0.2F + 0.5F * v.uv.y, 0.8F - 0.6F * v.uv.x * v.uv.y, 1);
    });
    m.batches = {solid(sheet, pose.put({0.05F * pose.time(), 0, 0}, 14 * pose.time(), {0, 0.4F, 1}, {1.25F, 0.75F, 1}),
                       plain_paint())};
    return m;
}

}

std::vector<Scene> layered_scenes(int size)
{
    using namespace groups;
    using enum Flaw;
    return {
        model_scene("transparent layers", "Five coloured panes over each other, before a ball.", Home::opengl, size,
                    panes,
                    {placed,
                     {blend_order, premultiplied_twice, alpha_ignored, additive_for_over, depth_written_by_layers,
                      overlapping_seams, cracks, missing_triangle, half_pixel_centre, shifted_one_pixel,
                      red_blue_swapped, rotation_sign, stale_frame, gamma_twice, brightness_5_percent, blank}}),
        model_scene("additive blending", "Glows that add up.", Home::software, size, glows,
                    {any,
                     {over_for_additive, premultiplied_twice, alpha_ignored, missing_triangle, stale_frame,
                      nearest_for_linear, gamma_twice, brightness_5_percent, sixteen_levels, fov_3_percent_wrong,
                      half_texel_off, mirrored, upside_down}}),
        model_scene("sprites", "A spiral of a hundred and fifty soft points.", Home::opengl, size, sprites,
                    {any,
                     placed,
                     {blend_order, premultiplied_twice, alpha_ignored, additive_for_over, depth_written_by_layers,
                      missing_triangle, stale_frame, gamma_twice, brightness_5_percent, sixteen_levels}}),
        model_scene("glass", "A transparent knot over tiles.", Home::opengl, size, glass,
                    {placed,
                     shine,
                     encoded,
                     {back_faces_shown, front_faces_culled, premultiplied_twice, alpha_ignored, additive_for_over,
                      overlapping_seams, cracks, missing_triangle, flat_for_smooth, half_pixel_centre, rotation_sign,
                      stale_frame, affine_uv}},
                    {Way::light_in_world_space}),
        model_scene("gradient", "Colours blended over a sheet; wider than high.", Home::software, size, gradient,
                    {any,
                     placed,
                     {aspect_ignored, flat_for_smooth, sixteen_levels, gamma_twice, brightness_3_percent,
                      brightness_5_percent, green_5_percent, rotation_sign, stale_frame, missing_triangle}}),
    };
}

}
