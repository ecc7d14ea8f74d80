#pragma once

#include <cmath>

#include "scene/scene.hpp"
#include "scene/scene_json.hpp"

/// Small scenes that several tests draw. Each is called by what is special about it.
namespace umbral::render::test {

inline scene::Scene first_light() { return scene::read_scene(UMBRAL_SOURCE_DIR "/reference/scenes/first-light.json"); }

/// A camera 4 in front of the origin, one light far away, one red material, and the unit sphere, which nothing shows
/// yet.
inline scene::Scene bare()
{
    scene::Scene scene;
    scene.camera = {
        .eye = {0, 0, 4}, .target = {0, 0, 0}, .up = {0, 1, 0}, .fovy_degrees = 40, .near = 0.5F, .far = 50};
    scene.lights = {{.name = "sun", .positional = false, .where = {1, 2, 3}, .color = glm::vec3(1)}};
    scene.materials = {{.name = "red", .ambient = {0.1F, 0.02F, 0.02F}, .diffuse = {0.8F, 0.2F, 0.1F}}};
    scene.geometries = {{"ball", scene::Sphere{24, 48}}};
    return scene;
}

inline scene::Instance instance(const std::string& name, std::size_t geometry,
                                std::vector<scene::Transform> transforms = {})
{
    scene::Instance one;
    one.name = name;
    one.geometry = geometry;
    one.transforms = std::move(transforms);
    return one;
}

/// No effect at all: flat, dull, one-sided, one light far away.
inline scene::Scene plain()
{
    scene::Scene scene = bare();
    scene.instances = {instance("ball", 0)};
    scene.instances[0].smooth = false;
    return scene;
}

/// A floor that begins behind the camera and ends beyond the far plane.
inline scene::Scene through_the_near_plane()
{
    scene::Scene scene = plain();
    scene.geometries.push_back({"floor", scene::Plane{5, 3}});
    scene.instances.push_back(
        instance("floor", 1, {scene::Scale{{30, 1, 60}}, scene::Rotate{{0, 0, 1}, 7}, scene::Translate{{0, -1, 0}}}));
    scene.instances[1].sides = scene::Sides::both;
    scene.materials[0].specular = glm::vec3(0.5F);
    scene.materials[0].exponent = 12;
    scene.lights.push_back({.name = "lamp", .positional = true, .where = {1, 1, 2}, .color = {0.2F, 0.3F, 0.6F}});
    return scene;
}

inline scene::Scene behind_the_camera()
{
    scene::Scene scene = bare();
    scene.instances = {instance("behind", 0, {scene::Translate{{0, 0, 9}}}),
                       instance("around", 0, {scene::Scale{glm::vec3(20)}})};
    return scene;
}

/// A camera in a ring of large triangles, which leads past it on both sides, over its head and under its feet: most
/// triangles have corners before and behind the camera's plane, and some lie in it.
inline scene::Scene around_the_camera()
{
    scene::Scene scene = bare();
    scene.camera.eye = {0.2F, 0.1F, 0.3F};
    scene.camera.fovy_degrees = 80;
    scene.camera.near = 0.05F;
    scene::Triangles mesh;
    for (unsigned i = 0; i < 12; ++i) {
        const float angle = 6.2831853F / 12 * static_cast<float>(i);
        const glm::vec3 around(2 * std::cos(angle), 1.5F * std::sin(angle), 0);
        mesh.positions.push_back(around + glm::vec3(0.3F, 0, 5));
        mesh.positions.push_back(around * 0.7F - glm::vec3(0, 0.2F, 6));
        mesh.triangles.emplace_back(2 * i, 2 * i + 1, (2 * i + 2) % 24);
        mesh.triangles.emplace_back((2 * i + 2) % 24, 2 * i + 1, (2 * i + 3) % 24);
    }
    // One with a corner in the camera's plane, one with an edge in it, one wholly in it.
    const auto corner = static_cast<unsigned>(mesh.positions.size());
    mesh.positions.insert(
        mesh.positions.end(),
        {{-0.5F, -0.5F, 0.3F}, {0.9F, -0.5F, 0.3F}, {0.2F, 0.9F, 0.3F}, {-0.4F, -0.8F, -2}, {0.1F, -0.9F, -3}});
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{corner, corner + 3, corner + 4}, {corner, corner + 1, corner + 3}, {corner, corner + 1, corner + 2}});
    scene.geometries.push_back({"ring", mesh});
    scene.instances = {instance("ring", 1),
                       instance("inside", 0, {scene::Scale{glm::vec3(3)}, scene::Translate{{1, 0.5F, 0.3F}}})};
    for (scene::Instance& one : scene.instances) one.sides = scene::Sides::both;
    scene.instances[0].smooth = false;
    return scene;
}

/// Triangles without area, in a point, twice over, and one good one.
inline scene::Scene degenerate()
{
    scene::Scene scene = bare();
    scene::Triangles mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, -1, 0}, {1, 1, 1e-20F}};
    mesh.triangles = {{0, 0, 0}, {0, 1, 1}, {0, 3, 1}, {0, 1, 2}, {0, 1, 2}, {4, 4, 2}};
    scene.geometries.push_back({"odd", mesh});
    scene.instances = {instance("odd", 1), instance("odd and flat", 1, {scene::Translate{{0.3F, 0.1F, -1}}})};
    scene.instances[1].smooth = false;
    return scene;
}

/// Seen from behind, mirrored, and both.
inline scene::Scene mirrored()
{
    scene::Scene scene = bare();
    scene.geometries.push_back({"wave", scene::Wave{12, 12, 0.2F, {1, 1}}});
    const scene::Rotate upright{{1, 0, 0}, 75};
    scene.instances = {
        instance("ball", 0, {scene::Scale{{-0.7F, 0.7F, 0.7F}}, scene::Translate{{-1, 0.5F, 0}}}),
        instance("back", 1,
                 {scene::Rotate{{1, 0, 0}, -70}, scene::Scale{glm::vec3(0.5F)}, scene::Translate{{1, 0.6F, 0}}}),
        instance("mirrored", 1, {upright, scene::Scale{{0.5F, -0.5F, 0.5F}}, scene::Translate{{0.8F, -0.7F, 0}}}),
        instance("hidden", 1,
                 {scene::Rotate{{1, 0, 0}, -70}, scene::Scale{glm::vec3(0.4F)}, scene::Translate{{-1, -0.8F, 0}}})};
    scene.instances[1].sides = scene.instances[2].sides = scene::Sides::both;
    return scene;
}

}
