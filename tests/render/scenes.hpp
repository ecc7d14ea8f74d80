#pragma once

#include <umbral/scene/scene.hpp>
#include <umbral/scene/scene_json.hpp>

/// Small scenes that several tests draw. Each is called by what is special about it.
namespace umbral::render::test {

inline scene::Scene first_light() { return scene::read_scene(UMBRAL_SOURCE_DIR "/reference/scenes/first-light.json"); }

/// A camera 4 in front of the origin, one light far away, one red material, and the unit sphere, which nothing shows yet.
inline scene::Scene bare()
{
    scene::Scene scene;
    scene.camera = {.eye = {0, 0, 4}, .target = {0, 0, 0}, .up = {0, 1, 0}, .fovy_degrees = 40, .near = 0.5F, .far = 50};
    scene.lights = {{.name = "sun", .positional = false, .where = {1, 2, 3}, .color = glm::vec3(1)}};
    scene.materials = {{.name = "red", .ambient = {0.1F, 0.02F, 0.02F}, .diffuse = {0.8F, 0.2F, 0.1F}}};
    scene.geometries = {{"ball", scene::Sphere{24, 48}}};
    return scene;
}

inline scene::Instance instance(const std::string& name, std::size_t geometry, std::vector<scene::Transform> transforms = {})
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
    scene.instances.push_back(instance("floor", 1, {scene::Scale{{30, 1, 60}}, scene::Rotate{{0, 0, 1}, 7}, scene::Translate{{0, -1, 0}}}));
    scene.instances[1].sides = scene::Sides::both;
    scene.materials[0].specular = glm::vec3(0.5F);
    scene.materials[0].exponent = 12;
    scene.lights.push_back({.name = "lamp", .positional = true, .where = {1, 1, 2}, .color = {0.2F, 0.3F, 0.6F}});
    return scene;
}

inline scene::Scene behind_the_camera()
{
    scene::Scene scene = bare();
    scene.instances = {instance("behind", 0, {scene::Translate{{0, 0, 9}}}), instance("around", 0, {scene::Scale{glm::vec3(20)}})};
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
    scene.instances = {instance("ball", 0, {scene::Scale{{-0.7F, 0.7F, 0.7F}}, scene::Translate{{-1, 0.5F, 0}}}),
                       instance("back", 1, {scene::Rotate{{1, 0, 0}, -70}, scene::Scale{glm::vec3(0.5F)}, scene::Translate{{1, 0.6F, 0}}}),
                       instance("mirrored", 1, {upright, scene::Scale{{0.5F, -0.5F, 0.5F}}, scene::Translate{{0.8F, -0.7F, 0}}}),
                       instance("hidden", 1, {scene::Rotate{{1, 0, 0}, -70}, scene::Scale{glm::vec3(0.4F)}, scene::Translate{{-1, -0.8F, 0}}})};
    scene.instances[1].sides = scene.instances[2].sides = scene::Sides::both;
    return scene;
}

}
