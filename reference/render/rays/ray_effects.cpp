#include "render/rays/ray_effects.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/motion.hpp"

namespace umbral::render::rays {
namespace {

/// The first thing of a list for which `asks` holds, by its name, and how many more there are.
template <class Thing, class Asks>
std::string first_of(const std::vector<Thing>& things, const char* kind, const Asks& asks)
{
    const auto first = std::ranges::find_if(things, asks);
    if (first == things.end()) return "";
    const auto more = std::ranges::count_if(things, asks) - 1;
    return fmt::format("{} \"{}\"{}", kind, first->name, more > 0 ? fmt::format(" and {} more", more) : "");
}

RayEffect effect(const char* name, const std::string& who, const char* does, const char* absent)
{
    return {name, !who.empty(), who.empty() ? absent : who + does};
}

}

std::vector<RayEffect> ray_effects(const scene::Scene& scene)
{
    using scene::Light;
    using scene::Material;
    const std::string moving = first_of(scene.instances, "instance", [](const auto& one) { return scene::moves(one); });
    const scene::Camera& camera = scene.camera;
    return {effect("shadows", first_of(scene.lights, "light", [](const Light&) { return true; }), " may be hidden",
                   "there is no light"),
            effect("soft",
                   first_of(scene.lights, "light",
                            [](const Light& light) {
                                return light.positional ? light.radius > 0 : light.half_angle_degrees > 0;
                            }),
                   " has a size", "every light is a point"),
            effect("mirrors",
                   first_of(scene.materials, "material",
                            [](const Material& material) { return material.mirror != glm::vec3(0); }),
                   " reflects as a mirror does", "no material reflects as a mirror does"),
            effect("glass",
                   first_of(scene.materials, "material",
                            [](const Material& material) { return material.transmit != glm::vec3(0); }),
                   " lets light through", "no material lets light through"),
            effect("bump",
                   first_of(scene.materials, "material",
                            [](const Material& material) { return material.bump.has_value(); }),
                   " has a bump map", "no material has a bump map"),
            {"lens", camera.lens_radius > 0,
             camera.lens_radius > 0 ? fmt::format("the camera's lens has a radius of {}", camera.lens_radius)
                                    : "the camera is a pinhole"},
            {"shutter", camera.shutter_seconds > 0 && !moving.empty(),
             camera.shutter_seconds <= 0 ? "the shutter is open for a moment only"
             : moving.empty()
                 ? "nothing moves while the shutter is open"
                 : fmt::format("{} moves in the {} s that the shutter is open", moving, camera.shutter_seconds)},
            {"indirect", scene.bounces > 0,
             scene.bounces > 0 ? fmt::format("light goes on from surface to surface, {} times at most", scene.bounces)
                               : "no light between surfaces is asked for"}};
}

}
