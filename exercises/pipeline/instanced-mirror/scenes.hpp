#pragma once

#include <utility>

#include "stage.hpp"

/// What the cases show.
namespace umbral::pipeline {

/// Turned, stretched, then moved.
inline glm::mat4 placed(glm::vec3 place, glm::vec3 stretch = glm::vec3(1), float angle = 0, glm::vec3 axis = {0, 1, 0})
{
    return glm::rotate(glm::scale(glm::translate(glm::mat4(1), place), stretch), angle, axis);
}

inline shapes::Shape bowl() { return shapes::sphere(48, 32, 0.25F); }

/// Dusk on a lake: a knot and rings stand in the water, bowls swim on it.
inline Scene lake()
{
    Scene scene;
    scene.lake = true;
    scene.eye = {0, 1.25F, 6.6F};
    scene.target = {0, 0.12F, 0};
    scene.light = {5, 7, 6};
    scene.things = {
        {shapes::trefoil(180, 24, 0.19F), placed({0, 0.72F, -0.4F}, glm::vec3(1.05F), 0.35F), ink::orange, ink::red},
        {shapes::torus(80, 20, 0.16F), placed({-2.3F, 0.25F, -1.2F}, glm::vec3(0.85F), 0.7F), ink::blue, ink::white},
        {shapes::torus(80, 20, 0.16F), placed({2.4F, 0.1F, -1.6F}, glm::vec3(1), -0.8F), ink::green, ink::white},
        {bowl(), placed({-1.35F, 0.2F, 1.1F}, glm::vec3(0.42F), 0.25F, {0, 0, 1}), ink::pink, ink::white},
        {bowl(), placed({1.35F, 0.24F, 1.2F}, glm::vec3(0.38F), -0.35F, {1, 0, 1}), ink::red, ink::white},
        {shapes::icosphere(4), placed({0.3F, 0.1F, 2.1F}, glm::vec3(0.2F)), ink::white, ink::blue}};
    return scene;
}

/// The same scene seen from farther to one side, in other light.
inline Scene varied(Variation& vary, Scene scene)
{
    if (!vary) return scene;
    const auto turned = [](const glm::vec3& v, float angle) {
        return glm::vec3(glm::rotate(glm::mat4(1), angle, glm::vec3(0, 1, 0)) * glm::vec4(v, 0));
    };
    constexpr std::array sides{-0.35F, 0.35F};
    scene.eye = scene.target + turned(scene.eye - scene.target, vary.near(vary.one_of(0.0F, sides), 0.1F));
    scene.light = turned(scene.light, vary.near(vary.one_of(0.0F, sides), 0.15F));
    return scene;
}

/// The same scene in another unit of length: it looks the same.
inline Scene in_units(Scene scene, float unit)
{
    scene.unit *= unit;
    scene.eye *= unit;
    scene.target *= unit;
    scene.light *= unit;
    scene.mirror.w *= unit;
    for (Thing& thing : scene.things) thing.model = glm::scale(glm::mat4(1), glm::vec3(unit)) * thing.model;
    return scene;
}

/// The same scene turned about the origin: the mirror faces another way, and it is seen from another side.
inline Scene turned(Scene scene, const glm::mat3& turn)
{
    scene.eye = turn * scene.eye;
    scene.target = turn * scene.target;
    scene.light = turn * scene.light;
    scene.mirror = glm::vec4(turn * glm::vec3(scene.mirror), scene.mirror.w);
    for (Thing& thing : scene.things) thing.model = glm::mat4(turn) * thing.model;
    return scene;
}

/// A mirror that stands aslant behind the things, at some distance from the origin. `handedness` is -1 for models that
/// mirror.
inline Scene wall(Look look, float handedness = 1)
{
    Scene scene;
    scene.look = look;
    const glm::vec3 normal = glm::normalize(glm::vec3(0.5F, 0.1F, 1));
    scene.mirror = glm::vec4(normal, 1.2F);
    scene.eye = {2.2F, 1.2F, 5.5F};
    scene.target = {-0.1F, 0, -0.8F};
    scene.things = {
        {shapes::trefoil(160, 20, 0.2F), placed({0.1F, 0, 0.2F}, 0.7F * glm::vec3(1, 1, handedness), 0.5F), ink::blue,
         ink::red},
        {shapes::icosphere(3), placed({1.1F, -0.5F, 0.4F}, 0.3F * glm::vec3(1, 1, handedness)), ink::orange, ink::red}};
    return scene;
}

/// Things that the water cuts, seen closer and from above. Their triangles are large, and most of them lie on both
/// sides.
inline Scene cut()
{
    Scene scene;
    scene.look = Look::places;
    scene.mirror = {0, 1, 0, -0.3F};
    scene.eye = {0.4F, 2.6F, 4.4F};
    scene.target = {0, 0.2F, 0};
    scene.things = {{shapes::icosphere(1), placed({-0.9F, 0.35F, 0}, glm::vec3(0.7F)), ink::green, ink::orange},
                    {shapes::torus(9, 5, 0.25F), placed({0.9F, 0.4F, -0.1F}, glm::vec3(0.75F), 0.4F, {1, 0, 0}),
                     ink::pink, ink::orange}};
    return scene;
}

/// Bowls whose insides show, each another way.
inline Scene bowls(const glm::vec3& stretch)
{
    Scene scene;
    scene.look = Look::sides;
    scene.eye = {0, 1.7F, 5.2F};
    scene.target = {0, 0.1F, 0};
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<float>(i);
        // A turn about its own axis moves no point of a bowl's surface to another place, but does change the matrix: of
        // the middle one's diagonal one number is negative, though nothing is mirrored.
        const float aside = i == 1 ? 0.8F : 0.0F;
        const glm::mat4 tilt = glm::rotate(glm::mat4(1), 0.5F + 0.9F * k, glm::vec3(1, 0, 0.4F * k));
        scene.things.push_back({bowl(),
                                placed({1.5F * k - 1.5F, 0.85F, 0}, 0.62F * stretch, aside) *
                                    glm::rotate(tilt, -3.2F * aside, glm::vec3(0, 1, 0)),
                                i == 1 ? ink::orange : ink::blue, i == 1 ? ink::white : ink::pink});
    }
    return scene;
}

/// The plane's numbers may be multiplied by anything positive.
inline Scene with_normal(float length)
{
    Scene scene = wall(Look::places);
    scene.mirror *= length;
    return scene;
}

/// Without their images.
inline Scene stretched()
{
    Scene scene;
    scene.instances = 1;
    scene.mirror = {0, 1, 0, 1};
    scene.eye = {0, 0.9F, 4};
    scene.target = {0, -0.1F, 0};
    scene.things = {{shapes::icosphere(4), placed({-1.1F, 0, 0}, {0.9F, 0.25F, 0.7F}), ink::orange, ink::blue},
                    {shapes::torus(64, 20, 0.3F), placed({1.1F, 0, 0}, {0.35F, 0.7F, 1.2F}, 0.6F, {1, 1, 0}),
                     ink::green, ink::blue}};
    return scene;
}

/// Signs for the normals of two mirrors: what one does not have, the other has.
inline std::pair<glm::vec3, glm::vec3> opposite_signs(Random& random)
{
    glm::vec3 signs(1);
    for (int axis = 0; axis < 3; ++axis) signs[axis] = random.below(2) == 0 ? 1.0F : -1.0F;
    return {signs, -signs};
}

/// A mirror whose normal has these signs, and things about it: in front of it, cut by it, and mirrored themselves. The
/// unit of length and the normal's own length may be of any size.
inline Scene random_scene(Random& random, Look look, const glm::vec3& signs)
{
    Scene scene;
    scene.look = look;
    const float aside = random.uniform(0.05F, 0.6F);
    const float up = random.uniform(0.4F, 1);
    const glm::vec3 normal = glm::normalize(signs * glm::vec3(aside, up, random.uniform(0.3F, 1)));
    scene.mirror = std::pow(10.0F, random.uniform(-4, 4)) * glm::vec4(normal, random.uniform(0.3F, 0.8F));
    scene.eye = {random.uniform(-1.5F, 1.5F), random.uniform(1, 2), 6};
    scene.target = {0, -0.3F, 0};
    scene.light = {random.uniform(-5, 5), 5, random.uniform(2, 6)};
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t kind = random.below(3);
        const float x = random.uniform(0.3F, 0.65F);
        const float y = random.uniform(0.3F, 0.65F);
        const float z = random.uniform(0.3F, 0.65F) * (i % 2 == 0 ? 1.0F : -1.0F);
        const float turn = random.uniform(0, 6.28F);
        const glm::vec3 axis = random.unit_vector();
        const glm::vec3 place(1.1F * static_cast<float>(i % 2) - 0.55F + random.uniform(-0.2F, 0.2F),
                              0.9F * static_cast<float>(i / 2) - 0.45F, random.uniform(-0.4F, 0.4F));
        constexpr glm::vec3 colors[] = {ink::blue, ink::orange, ink::green, ink::pink};
        scene.things.push_back({kind == 0   ? bowl()
                                : kind == 1 ? shapes::torus(64, 20, 0.3F)
                                            : shapes::icosphere(3),
                                placed(place, {x, y, z}, turn, axis), colors[i], ink::white});
    }
    return in_units(scene, std::pow(10.0F, random.uniform(-5, 5)));
}

}
