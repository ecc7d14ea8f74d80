#pragma once

#include "scenes.hpp"

/// Single points at which the model is evaluated.
namespace umbral::lighting {

/// Of eight points, one is each of these; half of them are left as they are.
inline void make_special(Random& random, Probe& probe, std::size_t kind)
{
    Material& material = probe.material;
    const glm::vec3 n = probe.normal;
    const auto one_light = [&](const glm::vec3& direction, const glm::vec3& color) {
        probe.lights = {{glm::vec4(direction, 0), color}};
    };
    // No light at all.
    if (kind == 0) probe.lights.clear();
    // One that comes in nearly along the surface, and whose highlight is wide.
    if (kind == 1) {
        material.shininess = random.uniform(0.25F, 2);
        one_light(random.uniform(0.001F, 0.009F) * n + normalize(cross(n, random.unit_vector())), glm::vec3(0.8F));
    }
    // Within a sharp highlight.
    if (kind == 2) {
        material.shininess = random.uniform(115, 128);
        const glm::vec3 h = normalize(n + 0.12F * random.unit_vector());
        one_light(glm::reflect(normalize(probe.position), h), random_color(random, 0.4F, 0.7F));
    }
    // More light than 1, on what reflects little.
    if (kind == 3) {
        for (glm::vec3* const part : {&material.ambient, &material.diffuse, &material.specular}) *part *= 0.2F;
        one_light(n + 0.5F * random.unit_vector(), random_color(random, 1.5F, 3));
    }
}

/// Something black in one channel: of the surface, or of the light.
inline void take_a_channel(Random& random, Probe& probe)
{
    Material& material = probe.material;
    glm::vec3* const colors[] = {&material.emission, &material.ambient,     &material.diffuse,
                                 &material.specular, &probe.global_ambient, nullptr};
    glm::vec3* const color = colors[random.below(6)];
    const auto channel = static_cast<int>(random.below(3));
    if (color != nullptr) (*color)[channel] = 0;
    for (Light& light : probe.lights)
        if (color == nullptr) light.color[channel] = 0;
}

/// Single points with everything at random: what the formula gives, without a mesh.
inline std::vector<Probe> random_points(Random& random)
{
    std::vector<Probe> probes;
    while (probes.size() < 256) {
        Probe probe{3.0F * random.in_cube() + glm::vec3(0, 0, -6),
                    random.unit_vector(),
                    random_material(random),
                    {},
                    random_color(random, 0, 0.5F)};
        if (dot(probe.normal, normalize(-probe.position)) < 0.1F) continue;
        probe.lights = random_lights(random, placed(probe.position));
        make_special(random, probe, probes.size() % 8);
        if (probes.size() % 4 == 1) take_a_channel(random, probe);
        probe.view = placed(4.0F * random.in_cube(), glm::vec3(1), random.uniform(0, turn), random.unit_vector());
        probe.model =
            placed(4.0F * random.in_cube(), {random.uniform(0.5F, 2), random.uniform(0.5F, 2), random.uniform(0.5F, 2)},
                   random.uniform(0, turn), random.unit_vector());
        probes.push_back(probe);
    }
    return probes;
}

/// Points straight ahead of the viewer (v = (0, 0, 1)) where a term vanishes, is undefined or changes its formula.
/// Varied, they and their lights have other colours.
inline std::vector<Probe> edges(Variation vary = {})
{
    std::vector<Probe> probes;
    const auto add = [&](const glm::vec3& normal, float shininess, const std::vector<glm::vec4>& places) {
        for (const glm::vec3& written : {glm::vec3(0.5F, 0.3F, 0.2F), glm::vec3(0.2F, 0.4F, 0.5F)}) {
            const glm::vec3 tint = vary.near(written, 0.15F);
            Probe probe{{0, 0, -4},
                        normal,
                        {0.1F * tint, 0.3F * tint, tint, glm::vec3(0.75F) - tint, shininess},
                        {},
                        glm::vec3(0.5F)};
            for (const glm::vec4& place : places) probe.lights.push_back({place, 0.7F * (glm::vec3(1.1F) - tint)});
            probes.push_back(probe);
        }
    };
    const glm::vec3 ahead(0, 0, 1);
    const glm::vec3 away(0.6F, 0, -0.8F);  // n·v < 0: an interpolated normal on a silhouette
    const float half = std::sqrt(0.5F);
    // Exponent 0, with the cosine positive, zero and negative: x^0 = 1.
    add(ahead, 0, {{0.6F, 0, 0.8F, 0}});
    add({half, 0, -half}, 0, {{1, 0, 0, 0}});
    add(away, 0, {{1, 0, 0, 0}});
    // Exponents below 1, and one that is no whole number.
    for (const float shininess : {0.125F, 0.5F, 2.5F}) add(ahead, shininess, {{0.96F, 0, 0.28F, 0}});
    // A negative cosine under other exponents: no highlight, and no power of a negative number.
    for (const float shininess : {1.0F, 2.0F, 2.5F, 5.0F, 128.0F}) add(away, shininess, {{1, 0, 0, 0}});
    add(away, 5, {{4, 0, -4, 1}});
    // The light exactly opposite to the viewer: l + v = 0 in any arithmetic, since both have the length 4 before they
    // are normalised.
    add(away, 8, {{0, 0, -4, 0}});
    add(away, 8, {{0, 0, -8, 1}});
    for (const glm::vec4& opposite : {glm::vec4(0, 0, -4, 0), {0, 0, -1, 0}, {0, 0, -16, 1}}) add(away, 0, {opposite});
    add(away, 2, {{0.02F, 0, -1, 0}});
    // Grazing exactly, and from behind where n·h is still positive: neither diffuse nor specular.
    add(ahead, 4, {{1, 0, 0, 0}});
    add(ahead, 4, {{0, 3, -4, 1}});
    add(ahead, 4, {{0.6F, 0, -0.8F, 0}});
    // Directions have any length, and light_count may be 0 or 8.
    add(ahead, 4, {{0, 30, 40, 0}});
    add(ahead, 4, {{0.003F, 0, 0.004F, 0}});
    for (const float shininess : {0.0F, 4.0F, 90.0F}) add(ahead, shininess, {});
    add(ahead, 128, {{0, 0.2F, 1, 0}});
    add(ahead, 128, std::vector(8, glm::vec4(0, 0.2F, 1, 0)));
    return probes;
}

}
