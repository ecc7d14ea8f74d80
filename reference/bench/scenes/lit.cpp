// Meshes under lights.

#include <cmath>

#include "scenes.hpp"
#include "shapes.hpp"
#include "staging.hpp"

namespace umbral::bench::scenes {
namespace {

// A torus that takes 2 % of the picture.
Model small_mesh(const Pose& pose)
{
    Model m = framed(pose, {0, 3, 9}, {1.6F, -0.8F, 0});
    m.background = {0.10F, 0.12F, 0.20F, 1};
    m.lights = {sun({1, 2, 2}, glm::vec3(0.9F))};
    m.batches = {solid(torus(0.35F, 48, 24),
                       pose.put({0, 0.6F, 0}, 20 + 15 * pose.time(), {1, 0.3F, 0}, glm::vec3(0.62F)),
                       glossy({0.9F, 0.45F, 0.15F}))};
    return m;
}

Model one_light(const Pose& pose)
{
    Model m = framed(pose, {0, 1.6F, 4.2F}, {0, -0.1F, 0});
    m.lights = {lamp({2.4F, 2.6F, 2.6F}, glm::vec3(0.95F))};
    m.batches = {solid(vase(64), pose.put({0, 0, 0}, 30 * pose.time()), glossy({0.25F, 0.45F, 0.8F}, 0.7F, 40)),
                 solid(ground(8), pose.put({0, -1, 0}, 25 * pose.time(), {0, 1, 0}, {2, 1, 2}),
                       glossy({0.6F, 0.55F, 0.45F}, 0.1F, 10))};
    // Open at the top: its inside is seen, too.
    m.batches[0].cull = Cull::none;
    return m;
}

// Nonuniform scales, so that normals need the inverse transpose.
Model three_lights(const Pose& pose)
{
    Model m = framed(pose, {0.5F, 2.8F, 6.6F}, {0.15F, 0.1F, 0});
    m.ambient = glm::vec3(0.08F);
    m.lights = {sun({1, 1.5F, 1}, {0.75F, 0.7F, 0.6F}), lamp({-3, 1.5F, 1.5F}, {0.2F, 0.35F, 0.75F}),
                lamp({0.5F, 2.5F, -2.5F}, {0.75F, 0.2F, 0.15F})};
    m.batches = {
        solid(ball(48, 24), pose.put({-1.15F, 0.1F, 0.3F}, 35 * pose.time(), {0, 0, 1}, {1.1F, 0.4F, 0.7F}),
              glossy({0.85F, 0.85F, 0.8F}, 0.5F, 30)),
        solid(torus(0.4F, 64, 32), pose.put({1.2F, 0, 0.4F}, 50 * pose.time(), {1, 0, 0.4F}, {0.85F, 1.6F, 0.6F}),
              glossy({0.4F, 0.8F, 0.4F}, 0.5F, 20)),
        solid(vase(48), pose.put({0, 0.4F, -1.4F}, 20 * pose.time(), {0, 0, 1}, {0.7F, 1.1F, 0.7F}),
              glossy({0.9F, 0.75F, 0.3F}, 0.6F, 50))};
    m.batches[2].cull = Cull::none;
    return m;
}

Model five_spots(const Pose& pose)
{
    Model m = framed(pose, {0, 4.2F, 5.6F}, {0, -0.3F, 0});
    m.background = {0.02F, 0.02F, 0.03F, 1};
    m.ambient = glm::vec3(0.05F);
    const glm::vec3 colors[] = {{1, 0.3F, 0.2F}, {0.3F, 1, 0.3F}, {0.3F, 0.4F, 1}, {1, 0.9F, 0.3F}, {0.9F, 0.3F, 1}};
    for (int i = 0; i < 5; ++i) {
        const float a = 6.2831853F * static_cast<float>(i) / 5 + 0.25F * pose.time();
        Light spot = lamp({2.0F * std::cos(a), 2.4F, 2.0F * std::sin(a)}, 1.9F * colors[i]);
        spot.falloff = {0.4F, 0.3F, 0.2F};
        spot.aim = glm::normalize(glm::vec3(-0.55F * std::cos(a), -1, -0.55F * std::sin(a)));
        spot.cone = 0.88F;
        spot.focus = 8;
        m.lights.push_back(spot);
    }
    m.batches = {
        solid(ground(24), pose.put({0, -1, 0}, 0, {0, 1, 0}, {3.4F, 1, 3.4F}), glossy(glm::vec3(0.7F), 0.3F, 20)),
        solid(ball(48, 24), pose.put({0.1F, -0.3F, 0.1F}, 0, {0, 1, 0}, glm::vec3(0.7F)),
              glossy(glm::vec3(0.8F), 0.6F, 40)),
        solid(box(glm::vec3(0.35F)), pose.put({-1.5F, -0.6F, 0.9F}, 30 * pose.time()),
              glossy(glm::vec3(0.8F), 0.3F, 20)),
        solid(box({0.3F, 0.6F, 0.3F}), pose.put({1.5F, -0.4F, -0.9F}, 15 * pose.time()),
              glossy(glm::vec3(0.8F), 0.3F, 20))};
    return m;
}

Model flat_shading(const Pose& pose)
{
    Model m = framed(pose, {0, 0.7F, 3.4F});
    m.background = {0.85F, 0.86F, 0.88F, 1};
    m.encoded = false;
    m.lights = {sun({1, 1.2F, 1.5F}, {0.8F, 0.8F, 0.8F}), sun({-1, 0.2F, 0.3F}, {0.25F, 0.15F, 0.1F})};
    m.batches = {
        solid(gem(1), pose.put({0, 0, 0}, 25 * pose.time(), {0.3F, 1, 0.1F}), glossy({0.35F, 0.7F, 0.65F}, 0.25F, 12))};
    return m;
}

Model toon(const Pose& pose)
{
    Model m = framed(pose, {0, 2.2F, 3.0F});
    m.background = {0.95F, 0.90F, 0.78F, 1};
    m.encoded = false;
    m.ambient = glm::vec3(0.2F);
    m.lights = {sun({0.8F, 1.5F, 1}, glm::vec3(0.8F))};
    Material paper = glossy({0.95F, 0.35F, 0.25F}, 0, 1);
    paper.style = Style::toon;
    m.batches = {solid(knot(0.2F, 200, 24), pose.put({0, 0, 0}, 15 * pose.time(), {0.2F, 1, 0}), paper)};
    return m;
}

// Nearly all values are below 40.
Model dark(const Pose& pose)
{
    Model m = framed(pose, {0, 1.4F, 4.4F});
    m.background = {0.012F, 0.012F, 0.02F, 1};
    m.encoded = false;
    m.ambient = glm::vec3(0.035F);
    m.lights = {lamp({1.8F, 2, 2.2F}, {0.14F, 0.13F, 0.11F}), lamp({-2.5F, 0.5F, 0}, {0.03F, 0.04F, 0.09F})};
    m.batches = {
        solid(ball(48, 24), pose.put({-0.6F, 0, 0}, 20 * pose.time(), {0, 1, 0}, {0.9F, 0.9F, 0.9F}),
              glossy({0.9F, 0.8F, 0.7F}, 0.9F, 24)),
        solid(knot(0.16F, 160, 20), pose.put({0.9F, -0.1F, 0.2F}, 40 * pose.time(), {1, 0, 0}, glm::vec3(0.9F)),
              glossy({0.6F, 0.8F, 0.9F}, 0.9F, 16))};
    return m;
}

// Much of it is near white, and some beyond.
Model bright(const Pose& pose)
{
    Model m = framed(pose, {0, 1.8F, 4.4F});
    m.background = {0.97F, 0.97F, 0.95F, 1};
    m.ambient = glm::vec3(0.45F);
    m.lights = {sun({1, 1.5F, 1}, glm::vec3(0.75F)), lamp({-2, 2, 2}, {0.4F, 0.4F, 0.45F})};
    m.batches = {solid(torus(0.42F, 64, 32), pose.put({0, 0.1F, 0}, 35 * pose.time(), {1, 0, 0.3F}, glm::vec3(1.05F)),
                       glossy({0.9F, 0.82F, 0.7F}, 0.4F, 20)),
                 solid(ball(48, 24), pose.put({0, 0.1F, 0}, 0, {0, 1, 0}, glm::vec3(0.42F)),
                       glossy({0.75F, 0.85F, 0.95F}, 0.5F, 30))};
    return m;
}

Model reflection(const Pose& pose)
{
    Model m = framed(pose, {2.2F, 1.6F, 3.6F});
    m.background = {0.35F, 0.45F, 0.65F, 1};
    Material mirror;
    mirror.style = Style::mirror;
    mirror.color = {0.95F, 0.95F, 0.95F, 1};
    m.batches = {
        solid(ball(64, 32), pose.put({0, 0.2F, 0}), mirror),
        solid(torus(0.16F, 96, 24), pose.put({0, 0, 0}, 18 * pose.time(), {1, 0, 0.4F}, glm::vec3(1.35F)), mirror)};
    return m;
}

Model hills(const Pose& pose)
{
    Model m = framed(pose, {0, 3.0F, 4.4F}, {0, -0.4F, 0});
    m.background = {0.55F, 0.70F, 0.88F, 1};
    m.ambient = {0.14F, 0.16F, 0.22F};
    m.lights = {sun({-1.5F, 1.1F, 0.4F}, {1.0F, 0.92F, 0.75F})};
    const auto height = [](glm::vec2 p) {
        return 0.35F * std::sin(2.3F * p.x + 1) * std::cos(1.9F * p.y) + 0.18F * std::sin(5.1F * p.x - 3.7F * p.y) +
               0.07F * std::cos(11 * p.x + 7 * p.y);
    };
    Triangles land = surface(72, 72, [&](glm::vec2 uv) {
        const glm::vec2 p(4 * uv.x - 2, 2 - 4 * uv.y);
        return glm::vec3(p.x, height(p), p.y);
    });
    paint(land, [](const Vertex& v) {
        const float snow = glm::smoothstep(0.25F, 0.42F, v.position.y);
        const float rock = glm::smoothstep(-0.05F, 0.2F, v.position.y);
        return glm::vec4(glm::mix(glm::mix(glm::vec3(0.16F, 0.42F, 0.12F), glm::vec3(0.45F, 0.36F, 0.26F), rock),
                                  glm::vec3(0.95F), snow),
                         1);
    });
    m.batches = {solid(std::move(land), pose.put({0, 0, 0}, 20 * pose.time()), glossy(glm::vec3(1), 0.0F, 1))};
    return m;
}

}

std::vector<Scene> lit_scenes(int size)
{
    using namespace groups;
    using enum Flaw;
    constexpr Way world = Way::light_in_world_space;
    constexpr Way reversed = Way::lights_reversed;
    return {
        model_scene("small mesh", "A lit torus on 2 % of the picture.", Home::opengl, size, small_mesh,
                    {any, placed, meshes, light, shine, {rotation_sign, stale_frame, flat_for_smooth, gamma_twice}},
                    {world}),
        model_scene("one light", "A vase on a floor under one lamp, with Blinn's highlights.", Home::opengl, size,
                    one_light,
                    {placed,
                     light,
                     shine,
                     encoded,
                     {missing_triangle, cracks, depth_inverted, depth_test_off, ambient_twice, light_not_normalised,
                      sixteen_levels, near_plane_too_far, far_plane_too_near}},
                    {world}),
        model_scene("three lights", "Stretched solids under a sun and two coloured lamps.", Home::software, size,
                    three_lights,
                    {shine,
                     {one_light_missing, diffuse_missing, light_in_wrong_space, abs_cosine, brightness_5_percent,
                      normals_by_model, normal_matrix_transposed, negative_light, specular_behind, transform_order,
                      rotation_sign, depth_inverted, depth_test_off, front_faces_culled, sample_at_corner,
                      normals_not_renormalised}},
                    {world, reversed}),
        model_scene("five spots", "Five coloured spot lights that fade with distance.", Home::opengl, 2 * size,
                    five_spots,
                    {meshes,
                     {one_light_missing, light_in_wrong_space, attenuation_missing, spot_cone_missing, clamped_early,
                      wrapped_around, negative_light, stale_frame, shifted_one_pixel, brightness_3_percent,
                      phong_for_blinn, ambient_twice}},
                    {world, reversed}),
        model_scene(
            "flat shading", "A solid of eighty flat triangles on a bright background.", Home::software, size,
            flat_shading,
            {any,
             placed,
             meshes,
             light,
             {shininess_halved, one_light_missing, gamma_twice, rotation_sign, sixteen_levels, green_5_percent}},
            {world, reversed}),
        model_scene("toon bands", "A knot in four bands of one colour.", Home::opengl, size, toon,
                    {any,
                     placed,
                     meshes,
                     {one_band_too_few, bands_rounded, ambient_missing, flat_for_smooth, light_in_wrong_space,
                      rotation_sign, stale_frame, brightness_5_percent, depth_test_off, depth_inverted}},
                    {world}),
        model_scene(
            "dark scene", "Two solids in the dark: most values are below 40.", Home::software, size, dark,
            {placed,
             meshes,
             shine,
             {ambient_missing, ambient_twice, abs_cosine, diffuse_missing, one_light_missing, light_in_wrong_space,
              gamma_twice, rotation_sign, stale_frame, sixteen_levels, half_pixel_centre, shifted_one_pixel}},
            {world, reversed}),
        model_scene("bright scene", "A ring and a ball in bright light: much is near white.", Home::opengl, size,
                    bright,
                    {placed,
                     meshes,
                     light,
                     shine,
                     {clamped_early, wrapped_around, gamma_missing, stale_frame, sample_at_corner, one_light_missing}},
                    {world, reversed}),
        model_scene("reflection", "Mirrors under a sky and over tiles.", Home::software, size, reflection,
                    {any,
                     placed,
                     meshes,
                     encoded,
                     {reflection_reversed, reflection_in_eye_space, flat_for_smooth, rotation_sign, stale_frame,
                      brightness_5_percent, mirrored}}),
        model_scene("hills", "A height field in low sun.", Home::software, size, hills,
                    {any,
                     placed,
                     meshes,
                     light,
                     {gamma_missing, flat_for_smooth, rotation_sign, green_5_percent, depth_inverted, upside_down}},
                    {world}),
    };
}

}
