#include "engine_spoil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "render/picture.hpp"
#include "scene/motion.hpp"
#include "spoil.hpp"

namespace umbral::bench::scenes {
namespace {

namespace sc = umbral::scene;

float distance_of(const sc::Camera& camera) { return glm::length(camera.target - camera.eye); }

void spoil_camera(sc::Camera& camera, Flaw flaw)
{
    spoil_view(camera, flaw);
    if (flaw == Flaw::near_plane_too_far) camera.near = 0.9F * distance_of(camera);
    if (flaw == Flaw::far_plane_too_near) camera.far = 1.1F * distance_of(camera);
    if (flaw == Flaw::aperture_halved) camera.lens_radius /= 2;
}

void dim(sc::Scene& scene, float factor)
{
    scene.ambient *= factor;
    for (sc::Light& light : scene.lights) light.color *= factor;
}

void spoil_light(sc::Scene& scene, Flaw flaw)
{
    if (flaw == Flaw::one_light_missing && !scene.lights.empty()) scene.lights.pop_back();
    if (flaw == Flaw::ambient_missing) scene.ambient = glm::vec3(0);
    if (flaw == Flaw::ambient_twice) scene.ambient *= 2.0F;
    if (flaw == Flaw::light_3_percent) dim(scene, 0.97F);
    if (flaw == Flaw::light_5_percent) dim(scene, 0.95F);
    if (flaw == Flaw::light_as_point)
        for (sc::Light& light : scene.lights) light.radius = light.half_angle_degrees = 0;
    if (flaw == Flaw::light_in_wrong_space)
        for (sc::Light& light : scene.lights) light.where += scene.camera.target - scene.camera.eye;
}

void spoil_material(sc::Material& material, Flaw flaw)
{
    if (flaw == Flaw::specular_missing) material.specular = glm::vec3(0);
    if (flaw == Flaw::diffuse_missing) material.diffuse = glm::vec3(0);
    if (flaw == Flaw::shininess_halved) material.exponent /= 2;
    if (flaw == Flaw::uv_scale_missing) material.texture_scale = glm::vec2(1);
    if (flaw == Flaw::v_flipped) material.texture_scale.y *= -1;
    if (flaw == Flaw::u_mirrored) material.texture_scale.x *= -1;
    if (flaw == Flaw::reflection_missing) material.mirror = glm::vec3(0);
    if (flaw == Flaw::refraction_missing) material.index = 1;
}

void spoil_instance(sc::Instance& instance, Flaw flaw)
{
    if (flaw == Flaw::flat_for_smooth) instance.smooth = false;
    if (flaw == Flaw::transform_order) std::ranges::reverse(instance.transforms);
    for (sc::Transform& step : instance.transforms)
        if (auto* turn = std::get_if<sc::Rotate>(&step); turn != nullptr && flaw == Flaw::rotation_sign)
            turn->degrees *= -1;
}

/// The one in the middle of the list: neither what comes first, which is often a floor, nor always the smallest.
sc::Instance& some_thing(sc::Scene& scene) { return scene.instances[scene.instances.size() / 2]; }

void spoil_thing(sc::Scene& scene, Flaw flaw)
{
    if (scene.instances.empty()) return;
    sc::Instance& thing = some_thing(scene);
    if (flaw == Flaw::thing_moved) thing.transforms.emplace_back(sc::Translate{aside(scene.camera)});
    if (flaw == Flaw::thing_recoloured) {
        sc::Material other = scene.materials[thing.material];
        other.diffuse = 0.8F * other.diffuse + glm::vec3(0.06F, 0, 0);
        scene.materials.push_back(std::move(other));
        thing.material = scene.materials.size() - 1;
    }
    if (flaw == Flaw::thing_missing)
        scene.instances.erase(scene.instances.begin() + static_cast<std::ptrdiff_t>(scene.instances.size() / 2));
}

bool any_material(const sc::Scene& scene, auto&& asks) { return std::ranges::any_of(scene.materials, asks); }

bool has_textures(const sc::Scene& scene)
{
    return any_material(scene, [](const sc::Material& m) { return m.texture.has_value(); });
}

/// Is anything turned that is no ball?
bool turns_something(const sc::Scene& scene)
{
    return std::ranges::any_of(scene.instances, [&](const sc::Instance& one) {
        return !std::holds_alternative<sc::Sphere>(scene.geometries[one.geometry].shape) &&
               std::ranges::any_of(one.transforms,
                                   [](const sc::Transform& step) { return std::holds_alternative<sc::Rotate>(step); });
    });
}

/// How the whole world is moved: turned round the y axis first.
constexpr float turn_degrees = 37;
constexpr glm::vec3 moved_by{3.25F, -1.5F, 2.75F};

glm::vec3 turned(const glm::vec3& v)
{
    const float angle = glm::radians(turn_degrees);
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

void move_world(sc::Scene& scene)
{
    sc::Camera& camera = scene.camera;
    camera.eye = turned(camera.eye) + moved_by;
    camera.target = turned(camera.target) + moved_by;
    camera.up = turned(camera.up);
    for (sc::Light& light : scene.lights) {
        light.where = turned(light.where);
        if (light.positional) light.where += moved_by;
    }
    for (sc::Instance& instance : scene.instances) {
        instance.transforms.emplace_back(sc::Rotate{{0, 1, 0}, turn_degrees});
        instance.transforms.emplace_back(sc::Translate{moved_by});
    }
}

}

void spoil(sc::Scene& scene, Flaw flaw)
{
    // What moves is shown a twelfth of its film later than it should be.
    scene = sc::at_time(std::move(scene), flaw == Flaw::stale_frame ? scene.seconds / 12 : 0);
    if (flaw == Flaw::blank) scene.instances.clear();
    spoil_camera(scene.camera, flaw);
    spoil_light(scene, flaw);
    spoil_thing(scene, flaw);
    for (sc::Material& material : scene.materials) spoil_material(material, flaw);
    for (sc::Instance& instance : scene.instances) spoil_instance(instance, flaw);
    for (sc::Texture& texture : scene.textures) {
        if (flaw == Flaw::clamp_for_repeat) texture.repeat = false;
        if (flaw == Flaw::nearest_for_linear) texture.bilinear = false;
    }
}

bool can_show(const sc::Scene& scene, Flaw flaw)
{
    switch (flaw) {
        case Flaw::stale_frame: return sc::moves(scene);
        case Flaw::rotation_sign: return turns_something(scene);
        case Flaw::one_light_missing: return scene.lights.size() > 1;
        case Flaw::ambient_missing:
        case Flaw::ambient_twice:
            return scene.ambient != glm::vec3(0) &&
                   any_material(scene, [](const sc::Material& m) { return m.ambient != glm::vec3(0); });
        case Flaw::specular_missing:
        case Flaw::shininess_halved:
            return any_material(scene, [](const sc::Material& m) { return m.specular != glm::vec3(0); });
        case Flaw::uv_scale_missing:
        case Flaw::clamp_for_repeat:
            return any_material(scene,
                                [](const sc::Material& m) { return m.texture && m.texture_scale != glm::vec2(1); });
        case Flaw::v_flipped:
        case Flaw::u_mirrored: return has_textures(scene);
        case Flaw::nearest_for_linear:
            return has_textures(scene) && std::ranges::any_of(scene.textures, &sc::Texture::bilinear);
        case Flaw::reflection_missing:
            return any_material(scene, [](const sc::Material& m) { return m.mirror != glm::vec3(0); });
        case Flaw::refraction_missing:
            return any_material(scene,
                                [](const sc::Material& m) { return m.transmit != glm::vec3(0) && m.index != 1; });
        case Flaw::light_as_point:
            return std::ranges::any_of(scene.lights,
                                       [](const sc::Light& l) { return l.radius > 0 || l.half_angle_degrees > 0; });
        case Flaw::aperture_halved: return scene.camera.lens_radius > 0;
        default: return true;
    }
}

void rearrange(sc::Scene& scene, Way way)
{
    if (way == Way::lights_reversed) std::ranges::reverse(scene.lights);
    if (way == Way::triangles_reordered) std::ranges::reverse(scene.instances);
    if (way == Way::world_moved) move_world(scene);
}

Image recoded(Image image, Flaw flaw)
{
    const auto level = [&](std::uint8_t old) {
        const float share = static_cast<float>(old) / 255;
        if (flaw == Flaw::gamma_twice) return render::to_srgb(share);
        if (flaw == Flaw::gamma_missing) return static_cast<std::uint8_t>(std::lround(255 * std::pow(share, 2.2F)));
        if (flaw == Flaw::sixteen_levels) return static_cast<std::uint8_t>(old / 16 * 17);
        return old;
    };
    for (glm::u8vec4& pixel : image.cells) pixel = {level(pixel.r), level(pixel.g), level(pixel.b), pixel.a};
    return image;
}

}
