#pragma once

#include <kit/varied.hpp>

#include "probes.hpp"

/// Scenes for draw_lit.
namespace umbral::lighting {

inline LitMesh tables_of(const Shape& shape) { return {shape.positions, shape.normals, shape.indices}; }

inline Material shiny(const glm::vec3& color, float specular, float e)
{
    return {glm::vec3(0), 0.15F * color, color, glm::vec3(specular), e};
}

inline glm::mat4 placed(const glm::vec3& place, const glm::vec3& scale = glm::vec3(1), float angle = 0,
                        const glm::vec3& axis = {0, 1, 0})
{
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1), place), angle, axis), scale);
}

inline LitScene seen_from(const glm::vec3& eye, const glm::vec3& target, float degrees)
{
    LitScene scene;
    scene.view = glm::lookAt(eye, target, {0, 1, 0});
    scene.projection = glm::perspective(glm::radians(degrees), 1.0F, 0.5F, 40.0F);
    return scene;
}

inline void add_light(LitScene& scene, const glm::vec4& position, const glm::vec3& color,
                      LightFrame frame = LightFrame::world)
{
    scene.lighting.lights.push_back({{position, color}, frame});
}

/// A chain of eighteen links round a knot, before a wall: the goal picture. The links share one mesh.
inline LitScene wreath()
{
    LitScene scene = seen_from({0.9F, 1.1F, 7.6F}, {0, 0, -0.1F}, 38);
    scene.lighting.global_ambient = {0.06F, 0.08F, 0.14F};
    add_light(scene, {-0.7F, 1, 0.8F, 0}, {0.60F, 0.53F, 0.43F});
    add_light(scene, {2.6F, -1.4F, 1.4F, 1}, {0.42F, 0.08F, 0.20F});
    add_light(scene, {0, 0, -1.0F, 1}, {0.12F, 0.26F, 0.50F});
    add_light(scene, {0.25F, 0.45F, 1, 0}, {0.08F, 0.10F, 0.14F}, LightFrame::camera);
    scene.meshes = {tables_of(torus(80, 28, 0.24F)), tables_of(trefoil(260, 30, 0.17F)),
                    tables_of(surface(56, 56, [](float u, float v) { return glm::vec3(u, v, 0); }))};
    scene.things.push_back({2, placed({-5, -5, -1.7F}, glm::vec3(10)), shiny({0.055F, 0.07F, 0.11F}, 0.04F, 8)});
    constexpr int links = 18;
    for (int i = 0; i < links; ++i) {
        const float angle = turn * static_cast<float>(i) / links;
        glm::mat4 model = glm::rotate(glm::mat4(1), angle, {0, 0, 1});
        model = glm::translate(model, {0, 1.95F, 0});
        model = glm::rotate(model, i % 2 == 0 ? 0.7F : 0.7F - turn / 4, {1, 0, 0});
        model = glm::scale(model, glm::vec3(0.47F, 0.36F, 0.40F));
        const glm::vec3 color = glm::vec3(srgb_decoded(glm::dvec3(rainbow(angle / turn + 0.02F, 0.78F, 0.95F))));
        scene.things.push_back({0, model, shiny(color, 0.8F, 45)});
    }
    scene.things.push_back(
        {1, placed({0, 0, 0.1F}, glm::vec3(1.05F), 0.5F, {0, 0, 1}), shiny({0.70F, 0.38F, 0.06F}, 1.0F, 60)});
    return scene;
}

/// Things that are stretched and pressed: their normals do not move as their points do.
inline LitScene stretched()
{
    LitScene scene = seen_from({0, 0.9F, 4.4F}, {0, 0, 0}, 38);
    scene.lighting.global_ambient = glm::vec3(0.2F);
    add_light(scene, {-0.5F, 0.9F, 0.6F, 0}, {0.72F, 0.69F, 0.62F});
    add_light(scene, {0.9F, -0.3F, 0.6F, 0}, {0.25F, 0.22F, 0.45F});
    scene.meshes = {tables_of(sphere(96, 48)), tables_of(torus(128, 48, 0.33F))};
    scene.things = {{0, placed({-0.72F, 0.42F, 0}, {0.62F, 0.16F, 0.5F}, 0.7F, {0.3F, 0.2F, 1}),
                     shiny({0.75F, 0.42F, 0.22F}, 0.6F, 30)},
                    {1, placed({0.62F, 0.08F, 0}, {0.26F, 0.92F, 0.55F}, -0.35F, {0, 0.4F, 1}),
                     shiny({0.25F, 0.48F, 0.66F}, 0.6F, 40)},
                    {0, placed({-0.45F, -0.62F, 0.4F}, {0.85F, 0.30F, 0.12F}, -0.3F, {1, 1, 0}),
                     shiny({0.48F, 0.58F, 0.24F}, 0.5F, 20)}};
    return scene;
}

/// A shell and its mirror image: one mesh, whose inside is seen, too.
inline LitScene mirrored()
{
    LitScene scene = seen_from({0, 1.5F, 3.6F}, {0, -0.05F, 0}, 38);
    scene.lighting.global_ambient = glm::vec3(0.2F);
    add_light(scene, {-1.6F, 2.4F, 1.9F, 1}, {0.70F, 0.67F, 0.60F});
    add_light(scene, {0.6F, 0.2F, 1, 0}, {0.20F, 0.26F, 0.42F}, LightFrame::camera);
    scene.meshes = {tables_of(sphere(60, 30, 0.1F))};
    const glm::mat4 bowl = placed({0.68F, 0, 0}, {0.62F, 0.5F, 0.55F}, 0.6F, {1, 0, -0.5F});
    scene.things = {{0, bowl, shiny({0.72F, 0.34F, 0.26F}, 0.6F, 24)},
                    {0, glm::scale(glm::mat4(1), {-1, 1, 1}) * bowl, shiny({0.30F, 0.50F, 0.60F}, 0.6F, 24)}};
    return scene;
}

/// Few triangles of one colour each, seen from outside and from inside.
inline LitScene facets()
{
    LitScene scene = seen_from({0, 1.6F, 3.3F}, {0.02F, -0.08F, 0}, 38);
    scene.lighting.flat_shading = true;
    scene.lighting.global_ambient = glm::vec3(0.2F);
    add_light(scene, {-1.6F, 2.4F, 1.9F, 1}, {0.70F, 0.67F, 0.60F});
    add_light(scene, {0.9F, 0.9F, 0.9F, 1}, {0.20F, 0.26F, 0.42F});
    scene.meshes = {tables_of(sphere(16, 6, 0.1F)), tables_of(icosphere(1))};
    scene.things = {{0, placed({-0.56F, -0.05F, 0.2F}, glm::vec3(0.60F), 0.5F, {1, 0, -0.3F}),
                     shiny({0.72F, 0.34F, 0.26F}, 0.6F, 24)},
                    {1, placed({0.66F, 0.05F, -0.1F}, glm::vec3(0.58F), -1.1F, {1, 0.2F, 0.4F}),
                     shiny({0.30F, 0.50F, 0.60F}, 0.6F, 24)}};
    return scene;
}

/// Balls in a parallel projection: every one has its highlight at the same place.
inline LitScene parallel()
{
    LitScene scene = seen_from({0, 0, 6}, {0, 0, 0}, 40);
    scene.projection = glm::ortho(-2.1F, 2.1F, -2.1F, 2.1F, 1.0F, 12.0F);
    scene.lighting.local_viewer = false;
    scene.lighting.global_ambient = glm::vec3(0.15F);
    add_light(scene, {-0.9F, 1.1F, 0.9F, 0}, {0.9F, 0.86F, 0.80F});
    add_light(scene, {1.2F, -0.6F, 0.8F, 0}, {0.18F, 0.32F, 0.55F}, LightFrame::camera);
    scene.meshes = {tables_of(sphere(64, 32))};
    for (int i = 0; i < 9; ++i)
        scene.things.push_back({0,
                                placed({1.35F * static_cast<float>(i % 3 - 1), 1.35F * static_cast<float>(1 - i / 3),
                                        0.5F * static_cast<float>(i % 2)},
                                       glm::vec3(0.6F)),
                                shiny({0.30F, 0.10F, 0.14F}, 0.5F, 4 * std::exp2(static_cast<float>(i) / 2))});
    return scene;
}

/// A scene that is written down, varied: the world is turned about its vertical axis, its lights by another angle, each
/// of them is dimmer, and things change the channels of their colours. As written unless inputs are to vary.
inline LitScene varied(Variation& vary, LitScene scene)
{
    if (!vary) return scene;
    const glm::vec3 up(0, 1, 0);
    scene.view = scene.view * glm::mat4(vary.turn(up, 0.4F));
    const glm::mat4 lights_turned(vary.turn(up, 0.6F));
    for (auto& [light, frame] : scene.lighting.lights)
        light = {lights_turned * light.position, light.color * vary.near(glm::vec3(0.85F), 0.15F)};
    const int red = vary.one_of(0, std::array{1, 2});
    for (LitThing& thing : scene.things)
        for (glm::vec3* color : {&thing.material.ambient, &thing.material.diffuse}) *color = from_channel(*color, red);
    return scene;
}

/// How much larger than 1 the ball is that random scenes place.
inline constexpr float unit_of_balls = 4096;

/// The mesh behind more vertices than 16 bits count: they are the mesh's own again, but with other normals, and no
/// triangle has them.
inline LitMesh behind_others(const LitMesh& mesh)
{
    constexpr std::size_t before = 65'536;
    LitMesh result;
    for (std::size_t i = 0; i < before; ++i) {
        result.positions.push_back(mesh.positions[i % mesh.positions.size()]);
        result.normals.push_back(-mesh.normals[7 * i % mesh.normals.size()]);
    }
    result.positions.insert(result.positions.end(), mesh.positions.begin(), mesh.positions.end());
    result.normals.insert(result.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const std::uint32_t index : mesh.indices) result.indices.push_back(index + before);
    return result;
}

/// Anything anywhere; empty tables, too.
inline LitScene random_scene(Random& random, bool flat)
{
    LitScene scene = seen_from(5.0F * normalize(random.unit_vector() + glm::vec3(0.01F)), {0, 0, 0}, 40);
    const SurfacePoint middle{glm::vec3(scene.view * glm::vec4(0, 0, 0, 1)), {0, 0, 1}};
    scene.lighting = {random_lights(random, middle, scene.view, 3), 0.3F * random_color(random), coin(random), flat};
    for (PlacedLight& placed : scene.lighting.lights) placed.light.color *= 0.6F;
    scene.meshes = {tables_of(sphere(40, 20)), {}, tables_of(trefoil(120, 16, 0.2F)), tables_of(sphere(24, 10, 0.2F))};
    for (glm::vec3& normal : scene.meshes[2].normals) normal *= random.uniform(0.2F, 5);
    // One mesh in another unit: what it is placed by is as much smaller.
    for (glm::vec3& position : scene.meshes[0].positions) position *= unit_of_balls;
    for (std::size_t i = 0; i < 7; ++i) {
        glm::vec3 size(random.uniform(0.3F, 0.8F), random.uniform(0.3F, 0.8F),
                       random.uniform(0.3F, 0.8F) * (coin(random) ? 1.0F : -1.0F));
        if (i % 4 == 0) size /= unit_of_balls;
        Material material = random_material(random);
        material.emission *= 0.3F;
        material.ambient *= 0.3F;
        const glm::vec3 place = 1.1F * random.in_cube();
        scene.things.push_back({i % 4, placed(place, size, random.uniform(0, turn), random.unit_vector()), material});
    }
    return scene;
}

/// The scene before a wall of balls, each of another material, turned another way, and every second one mirrored.
inline LitScene crowded(Random& random, LitScene scene)
{
    scene.meshes.push_back(tables_of(icosphere(1)));
    for (glm::vec3& position : scene.meshes.back().positions) position *= unit_of_balls;
    constexpr int columns = 17;
    for (int i = 0; i < columns * columns; ++i) {
        const glm::vec3 place(0.32F * static_cast<float>(i % columns - columns / 2),
                              0.32F * static_cast<float>(i / columns - columns / 2), -7.5F);
        const glm::vec3 size = glm::vec3(i % 2 == 0 ? 1 : -1, 1, 1) * 0.15F / unit_of_balls;
        const glm::mat4 model = placed(place, size, random.uniform(0, turn), random.unit_vector());
        Material material = random_material(random);
        material.emission *= 0.3F;
        scene.things.insert(scene.things.begin(), {scene.meshes.size() - 1, inverse(scene.view) * model, material});
    }
    return scene;
}

}
