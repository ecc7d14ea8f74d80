#pragma once

#include <umbral/core/random.hpp>
#include <vector>

#include "support.hpp"

/// Random lights and materials, for the drivers of lighting whose answers are numbers.
namespace umbral::lighting {

/// Each channel in [0.1, 0.9].
inline glm::vec3 random_color(Random& random) { return 0.5F + 0.4F * random.in_cube(); }

/// No two of its colours are alike.
inline Material random_material(Random& random)
{
    const glm::vec3 emission = 0.5F * random_color(random);
    const glm::vec3 ambient = random_color(random);
    const glm::vec3 diffuse = random_color(random);
    return {emission, ambient, diffuse, random_color(random), random.uniform(1, 40)};
}

/// The same, but of six one sends out nothing, or reflects nothing of one kind.
inline Material random_partial_material(Random& random)
{
    Material material = random_material(random);
    glm::vec3* const parts[] = {&material.emission, &material.ambient, &material.diffuse, &material.specular};
    if (random.below(6) == 0) *parts[random.below(4)] = glm::vec3(0);
    return material;
}

/// One to three; but of twelve numbers one is 9 to 12, more than OpenGL's fixed function has lights.
inline std::uint32_t random_light_count(Random& random)
{
    return random.below(12) == 0 ? 9 + random.below(4) : 1 + random.below(3);
}

/// Lights become dimmer where there are many; of eight one has a single channel, and of sixteen one is out.
inline void vary_colors(Random& random, std::vector<Light>& lights)
{
    for (Light& light : lights) {
        if (lights.size() > 4) light.color *= 0.25F;
        const std::uint32_t channel = random.below(3);
        const std::uint32_t kind = random.below(16);
        if (kind == 2) light.color = glm::vec3(0);
        if (kind > 1) continue;
        const float kept = light.color[static_cast<int>(channel)];
        light.color = glm::vec3(0);
        light.color[static_cast<int>(channel)] = kept;
    }
}

/// A white light that stands in that direction from a point, as far as `size` says: a place, or a direction.
inline Light light_towards(const SurfacePoint& at, const glm::vec3& direction, bool is_place, float size)
{
    const glm::vec3 way = size * normalize(direction);
    return {is_place ? glm::vec4(at.position + way, 1) : glm::vec4(way, 0), glm::vec3(1)};
}

/// A light of any colour whose direction and the normal enclose an angle with a cosine of `least` to 1: a place 0.5 to
/// 4 away, or a direction of that length.
inline Light random_light(Random& random, const SurfacePoint& at, float least)
{
    const glm::vec3 n = normalize(at.normal);
    const glm::vec3 aside = normalize(cross(n, random.unit_vector()));
    const float cosine = random.uniform(least, 1);
    const glm::vec3 direction = cosine * n + std::sqrt(1 - cosine * cosine) * aside;
    const bool is_place = random.below(2) == 0;
    Light light = light_towards(at, direction, is_place, random.uniform(0.5F, 4));
    light.color = 2.0F * random_color(random);
    return light;
}

}
