#pragma once

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/varied.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>

#include "stage.hpp"

/// The scenes of the cases. Places of lights are written in world coordinates where the camera stands in the world.
namespace umbral::lighting {

/// An empty scene with a camera at `eye` that looks at `target`.
inline Scene scene_from(const glm::vec3& eye, const glm::vec3& target, float degrees)
{
    Scene scene;
    scene.view = glm::lookAt(eye, target, {0, 1, 0});
    scene.projection = glm::perspective(glm::radians(degrees), 1.0F, 0.1F, 50.0F);
    return scene;
}

inline void add_lamp(Scene& scene, const glm::vec3& place, const glm::vec3& color)
{
    scene.lights.push_back({scene.view * glm::vec4(place, 1), color});
}
inline void add_sun(Scene& scene, const glm::vec3& towards, const glm::vec3& color)
{
    scene.lights.push_back({scene.view * glm::vec4(towards, 0), color});
}

inline Material plastic(const glm::vec3& color, float specular, float shininess)
{
    return {glm::vec3(0), 0.12F * color, color, glm::vec3(specular), shininess};
}

inline glm::mat4 placed(const glm::vec3& place, const glm::vec3& scale = glm::vec3(1), float angle = 0,
                        const glm::vec3& axis = {0, 1, 0})
{
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1), place), angle, axis), scale);
}

inline Scene still_life()
{
    Scene scene = scene_from({0, 2.3F, 4.8F}, {0, 0.58F, 0}, 35);
    scene.global_ambient = {0.25F, 0.28F, 0.38F};
    add_sun(scene, {-0.7F, 1, 0.55F}, {0.62F, 0.57F, 0.46F});
    add_lamp(scene, {2.4F, 1.3F, 0.6F}, {0.55F, 0.20F, 0.12F});
    add_lamp(scene, {-2.2F, 0.9F, -0.9F}, {0.10F, 0.26F, 0.52F});
    scene.things = {
        {waves(96, 0.02F), placed({0, -0.02F, 0}, glm::vec3(3)), plastic({0.46F, 0.44F, 0.42F}, 0.25F, 40)},
        {trefoil(240, 32, 0.19F), placed({0, 0.83F, -0.25F}, glm::vec3(0.78F), 0.35F),
         plastic({0.86F, 0.58F, 0.16F}, 0.75F, 50)},
        {sphere(64, 32), placed({-0.92F, 0.40F, 0.62F}, glm::vec3(0.40F)), plastic({0.16F, 0.50F, 0.56F}, 0.9F, 110)},
        {sphere(64, 32),
         placed({0.05F, 0.17F, 1.35F}, glm::vec3(0.17F)),
         {{0.42F, 0.24F, 0.05F}, glm::vec3(0.1F), {0.4F, 0.3F, 0.1F}, glm::vec3(0.3F), 12}},
        {sphere(64, 24, 0.25F), placed({0.88F, 0.42F, 0.66F}, glm::vec3(0.43F), 0.3F, {1, 0, -0.6F}),
         plastic({0.70F, 0.20F, 0.24F}, 0.6F, 24)}};
    return scene;
}

inline Scene diffuse_sphere()
{
    Scene scene = scene_from({0, 0, 3.4F}, {0, 0, 0}, 40);
    scene.global_ambient = glm::vec3(0.3F);
    add_sun(scene, {-0.8F, 0.6F, 0.35F}, {0.95F, 0.92F, 0.85F});
    scene.things = {
        {sphere(96, 48), glm::mat4(1), {glm::vec3(0), {0.10F, 0.07F, 0.06F}, {0.88F, 0.50F, 0.34F}, glm::vec3(0), 1}}};
    return scene;
}

/// Spheres whose exponent grows to the right and downwards, from 1 to 128.
inline Scene exponents()
{
    constexpr std::array steps = {1.0F,  2.0F,  3.0F,  4.0F,  6.0F,  8.0F,  11.0F,  16.0F,
                                  22.0F, 30.0F, 40.0F, 52.0F, 68.0F, 86.0F, 106.0F, 128.0F};
    Scene scene = scene_from({0, 0, 11}, {0, 0, 0}, 41);
    add_sun(scene, {-0.9F, 1.1F, 0.9F}, {1.0F, 0.96F, 0.90F});
    add_sun(scene, {1.2F, -0.6F, 0.8F}, {0.18F, 0.32F, 0.55F});
    for (int i = 0; i < 16; ++i) {
        Material material = plastic({0.30F, 0.10F, 0.14F}, 0.58F, steps[static_cast<std::size_t>(i)]);
        scene.things.push_back(
            {sphere(48, 24), placed({2 * (i % 4) - 3, 3 - 2 * (i / 4), 0}, glm::vec3(0.92F)), material});
    }
    return scene;
}

/// A floor of two triangles, so large that what is seen of it must be computed at each pixel.
inline Shape wide_floor(float height)
{
    return surface(1, 1, [&](float u, float v) { return glm::vec3(8 * u - 4, height, 4 - 8 * v); });
}

/// Small lamps close above ripples in a wide floor: every pixel sees them in another direction.
inline Scene near_lamps()
{
    Scene scene = scene_from({0, 1.7F, 1.9F}, {0, 0, 0.05F}, 42);
    scene.global_ambient = glm::vec3(0.25F);
    add_lamp(scene, {-0.45F, 0.16F, 0.35F}, {0.85F, 0.38F, 0.16F});
    add_lamp(scene, {0.5F, 0.2F, 0.1F}, {0.16F, 0.45F, 0.80F});
    add_lamp(scene, {-0.05F, 0.14F, -0.5F}, {0.35F, 0.70F, 0.25F});
    scene.things = {
        {waves(160, 0.06F), placed({0, 0, -0.4F}, glm::vec3(0.7F)), plastic({0.62F, 0.60F, 0.58F}, 0.5F, 30)},
        {wide_floor(-0.01F), glm::mat4(1), plastic({0.50F, 0.52F, 0.56F}, 0.6F, 16)}};
    return scene;
}

/// Eighty triangles, so large that the normals between their corners matter.
inline Scene coarse_sphere(bool flat)
{
    Scene scene = scene_from({0, 0, 3.4F}, {0, 0, 0}, 40);
    scene.flat = flat;
    scene.global_ambient = glm::vec3(0.3F);
    add_lamp(scene, {-1.7F, 2.0F, 2.6F}, {0.72F, 0.70F, 0.66F});
    add_lamp(scene, {2.0F, 0.5F, 1.6F}, {0.22F, 0.30F, 0.50F});
    scene.things = {{icosphere(1), placed({0, 0, 0}, glm::vec3(1), 0.4F, {0.3F, 1, 0.2F}),
                     plastic({0.26F, 0.52F, 0.36F}, 0.8F, 40)}};
    return scene;
}

/// Things that are stretched and pressed: their normals do not move as their points do.
inline Scene scaled_things()
{
    Scene scene = scene_from({0, 0.9F, 4.4F}, {0, 0, 0}, 38);
    scene.global_ambient = glm::vec3(0.3F);
    add_sun(scene, {-0.5F, 0.9F, 0.6F}, {0.72F, 0.69F, 0.62F});
    add_sun(scene, {0.9F, -0.3F, 0.6F}, {0.25F, 0.22F, 0.45F});
    scene.things = {{sphere(96, 48), placed({-0.72F, 0.42F, 0}, {0.62F, 0.16F, 0.5F}, 0.7F, {0.3F, 0.2F, 1}),
                     plastic({0.75F, 0.42F, 0.22F}, 0.6F, 30)},
                    {torus(128, 48, 0.33F), placed({0.62F, 0.08F, 0}, {0.26F, 0.92F, 0.55F}, -0.35F, {0, 0.4F, 1}),
                     plastic({0.25F, 0.48F, 0.66F}, 0.6F, 40)},
                    {sphere(96, 48), placed({-0.45F, -0.62F, 0.4F}, {0.85F, 0.30F, 0.12F}, -0.3F, {1, 1, 0}),
                     plastic({0.48F, 0.58F, 0.24F}, 0.5F, 20)},
                    {icosphere(0), placed({0.62F, -0.62F, 0.9F}, {0.5F, 0.16F, 0.4F}, 0.4F, {0.5F, 0.3F, 1}),
                     plastic({0.62F, 0.30F, 0.56F}, 0.5F, 20)}};
    return scene;
}

/// Bowls of few facets, seen from outside and from inside.
inline Scene bowls(bool flat)
{
    Scene scene = scene_from({0, 1.6F, 3.3F}, {0.02F, -0.08F, 0}, 38);
    scene.flat = flat;
    scene.global_ambient = glm::vec3(0.3F);
    add_lamp(scene, {-1.6F, 2.4F, 1.9F}, {0.70F, 0.67F, 0.60F});
    add_lamp(scene, {0.9F, 0.9F, 0.9F}, {0.20F, 0.26F, 0.42F});
    const Shape bowl = sphere(16, 6, 0.1F);
    scene.things = {{bowl, placed({-0.56F, -0.05F, 0.2F}, glm::vec3(0.60F), 0.5F, {1, 0, -0.3F}),
                     plastic({0.72F, 0.34F, 0.26F}, 0.6F, 24)},
                    {bowl, placed({0.66F, 0.05F, -0.1F}, glm::vec3(0.58F), -1.1F, {1, 0.2F, 0.4F}),
                     plastic({0.30F, 0.50F, 0.60F}, 0.6F, 24)}};
    return scene;
}

/// All eight lights, directions and places mixed, round a white knot.
inline Scene eight_lights()
{
    Scene scene = scene_from({0, 0, 4.2F}, {0, 0, 0}, 38);
    scene.global_ambient = glm::vec3(0.2F);
    constexpr std::array<glm::vec3, 8> colors = {
        glm::vec3(0.42F, 0.06F, 0.06F), {0.40F, 0.24F, 0.03F}, {0.30F, 0.34F, 0.04F}, {0.05F, 0.36F, 0.08F},
        {0.04F, 0.32F, 0.32F},          {0.05F, 0.12F, 0.44F}, {0.24F, 0.06F, 0.40F}, {0.40F, 0.05F, 0.26F}};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const float angle = turn * static_cast<float>(i) / 8;
        const glm::vec3 place(2.2F * std::cos(angle), 2.2F * std::sin(angle), i % 4 < 2 ? 0.9F : -0.2F);
        if (i % 2 == 0)
            add_sun(scene, place, colors[i]);
        else
            add_lamp(scene, place, colors[i]);
    }
    scene.things = {
        {trefoil(300, 40, 0.22F), placed({0, 0, 0}, glm::vec3(1.0F)), plastic(glm::vec3(0.70F), 0.55F, 45)}};
    return scene;
}

/// A scene that is written down, varied: the world is turned about its vertical axis, its lights by another angle, each
/// of them is dimmer, and things change the channels of their colours. As written unless inputs are to vary.
inline Scene varied(Variation& vary, Scene scene)
{
    if (!vary) return scene;
    const glm::vec3 up(0, 1, 0);
    const glm::mat4 lights_turned = scene.view * glm::mat4(vary.turn(up, 0.6F)) * inverse(scene.view);
    for (Light& light : scene.lights)
        light = {lights_turned * light.position, light.color * vary.near(glm::vec3(0.85F), 0.15F)};
    scene.view = scene.view * glm::mat4(vary.turn(up, 0.4F));
    const int red = vary.one_of(0, std::array{1, 2});
    for (Thing& thing : scene.things)
        for (glm::vec3* color : {&thing.material.emission, &thing.material.ambient, &thing.material.diffuse})
            *color = from_channel(*color, red);
    return scene;
}

inline glm::vec3 random_color(Random& random, float low, float high)
{
    const float red = random.uniform(low, high);
    const float green = random.uniform(low, high);
    return {red, green, random.uniform(low, high)};
}

inline Material random_material(Random& random)
{
    Material material;
    material.emission = random_color(random, 0, 0.08F);
    material.ambient = random_color(random, 0.02F, 0.25F);
    material.diffuse = random_color(random, 0.15F, 0.8F);
    material.specular = random_color(random, 0.2F, 0.7F);
    material.shininess = std::exp2(random.uniform(-2, 7));
    return material;
}

/// One to eight lights round the origin of `view`'s world, their sum about as bright whatever their number.
inline std::vector<Light> random_lights(Random& random, const glm::mat4& view)
{
    const std::uint32_t count = 1 + random.below(maximum_lights);
    std::vector<Light> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 place = random.uniform(1.6F, 3) * random.unit_vector();
        // Directions of any length.
        const glm::vec4 homogeneous =
            random.below(2) == 0 ? glm::vec4(std::exp2(random.uniform(-6, 6)) * place, 0) : glm::vec4(place, 1);
        lights.push_back({view * homogeneous,
                          random_color(random, 0.3F, 1) * (1.3F / std::sqrt(static_cast<float>(count)) * 0.55F)});
    }
    return lights;
}

/// Turns the y axis into `direction`, and then places.
inline glm::mat4 open_towards(const glm::vec3& direction, const glm::vec3& place, const glm::vec3& scale)
{
    const glm::vec3 up(0, 1, 0);
    return placed(place, scale, std::acos(dot(up, normalize(direction))), cross(up, direction));
}

/// Four things of all kinds, most of them stretched, under random lights: the fourth is a bowl that shows its inside.
/// They lie over a floor of two triangles, so large that what is seen of it must be computed at each pixel.
inline Scene random_scene(Random& random, bool flat)
{
    const float angle = random.uniform(0, turn);
    Scene scene =
        scene_from({4.1F * std::sin(angle), random.uniform(0.5F, 1.6F), 4.1F * std::cos(angle)}, {0, 0, 0}, 40);
    scene.flat = flat;
    scene.unused_light = glaring;
    scene.global_ambient = random_color(random, 0.1F, 0.5F);
    scene.lights = random_lights(random, scene.view);
    const std::array shapes = {flat ? icosphere(1) : sphere(96, 48), torus(flat ? 16 : 128, flat ? 10 : 48, 0.33F),
                               icosphere(0), sphere(20, 8, 0)};
    const glm::vec3 eye(inverse(scene.view)[3]);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const float corner = angle + turn * (static_cast<float>(i) + random.uniform(0.3F, 0.7F)) / 4;
        const glm::vec3 place(0.85F * std::sin(corner), random.uniform(-0.35F, 0.35F), 0.85F * std::cos(corner));
        glm::vec3 scale(random.uniform(0.54F, 0.66F));
        if (i < 3)
            scale *= glm::vec3(random.uniform(0.6F, 1.1F), random.uniform(0.3F, 0.6F), random.uniform(0.8F, 1.2F));
        const glm::mat4 model = i == 3
                                    ? open_towards(normalize(eye - place) + 0.7F * random.unit_vector(), place, scale)
                                    : placed(place, scale, random.uniform(0, turn), random.unit_vector());
        scene.things.push_back({shapes[i], model, random_material(random)});
    }
    Material floor = random_material(random);
    floor.shininess = random.uniform(4, 24);
    scene.things.push_back({wide_floor(-1), glm::mat4(1), floor});
    return scene;
}

}
