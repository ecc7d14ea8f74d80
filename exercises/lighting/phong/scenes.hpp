#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <kit/channels.hpp>
#include <vector>

#include "../highlights.hpp"

/// Scenes as programs have them: one eye sees many points, one after the other, of things and lights of every kind.
namespace umbral::lighting {

/// 0, below 1, and up to 40, a third of each. Not far below 1: next to a cosine of 0 such powers are too steep for
/// float.
inline float exponent_of_any_kind(Random& random, std::uint32_t kind)
{
    return kind % 3 == 0 ? 0.0F : kind % 3 == 1 ? random.uniform(0.5F, 0.95F) : random.uniform(1, 40);
}

/// An exponent below 1; the viewer stands at a cosine of 0.1 to 0.95 with the mirrored direction.
inline Glance wide_glance(Random& random)
{
    Glance glance = random_glance(random, 1, 1);
    glance.e = random.uniform(0.05F, 0.95F);
    const glm::vec3 r = 2 * dot(glance.normal, glance.l) * glance.normal - glance.l;
    glance.v = round_about(random, normalize(r), random.uniform(0.1F, 0.95F));
    return glance;
}

/// All vectors in a plane of two axes, as in a picture on paper: one coordinate is 0.
inline Glance flat_glance(Random& random)
{
    Glance glance;
    glance.e = random.uniform(1, 10);
    const float turn = random.uniform(0, 6.2831853F);
    const float side = random.below(2) == 0 ? 1.0F : -1.0F;
    const float off = side * random.uniform(0.1F, 1.4F);
    const auto axis = static_cast<int>(random.below(3));
    const auto in_plane = [&](float angle) {
        glm::vec3 v(0);
        v[(axis + 1) % 3] = std::cos(turn + angle);
        v[(axis + 2) % 3] = std::sin(turn + angle);
        return v;
    };
    glance.normal = in_plane(0);
    glance.l = in_plane(off);
    glance.v = in_plane(random.uniform(0.2F, 0.6F) - off);
    return glance;
}

/// A point that the eye sees in the highlight of the first light: the normal is nearly half way between them.
inline SurfacePoint shining_point(Random& random, const Shine& scene)
{
    SurfacePoint at{1.5F * random.in_cube()};
    const glm::vec3 v = normalize(scene.eye - at.position);
    glm::vec3 l = round_about(random, v, 0.5F);
    if (!scene.lights.empty()) {
        const Light& light = scene.lights.front();
        l = normalize(glm::vec3(light.position) - light.position.w * at.position);
    }
    at.normal = normalize(normalize(l + v) + 0.2F * random.unit_vector());
    return at;
}

/// None, one or two, up to forty; a half of the others has two at one place, of different colours or the same.
inline std::vector<Light> lights_of_any_kind(Random& random, std::uint32_t kind)
{
    if (kind % 6 == 0) return {};
    std::vector<Light> lights;
    const std::uint32_t count = kind % 6 == 1 ? 20 + random.below(21) : 1 + random.below(2);
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool is_place = random.below(2) == 0;
        lights.push_back({glm::vec4((is_place ? 6.0F : 1.0F) * random.unit_vector(), is_place ? 1 : 0),
                          (count > 4 ? 0.1F : 1.5F) * random_color(random)});
        if (random.below(3) == 0) lights.back().color = some_channels(random, lights.back().color);
    }
    if (kind % 2 == 1) return lights;
    lights.push_back(lights.front());
    if (kind % 4 == 0) lights.back().color = random_color(random);
    return lights;
}

/// Points one after the other that differ in nothing else; then the last one of another material, and in another
/// ambient light.
inline std::vector<Shine> scene_of_any_kind(Random& random, std::uint32_t kind)
{
    Shine scene{{}, random_material(random), lights_of_any_kind(random, kind), random_color(random)};
    scene.eye = random.uniform(4, 8) * random.unit_vector();
    scene.material.shininess = exponent_of_any_kind(random, random.below(3));
    if (random.below(2) == 0) scene.material.specular = some_channels(random, scene.material.specular);
    std::vector<Shine> questions;
    for (int i = 0; i < 3; ++i) {
        scene.at = shining_point(random, scene);
        questions.push_back(scene);
    }
    const Material other = random_material(random);
    if (random.below(2) == 0) scene.material.shininess = exponent_of_any_kind(random, random.below(3));
    scene.material.diffuse = some_channels(random, other.diffuse);
    scene.material.specular = random.below(2) == 0 ? other.specular : some_channels(random, other.specular);
    questions.push_back(scene);
    scene.global_ambient = some_channels(random, random_color(random));
    questions.push_back(scene);
    return questions;
}

}
