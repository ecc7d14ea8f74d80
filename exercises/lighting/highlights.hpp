#pragma once

#include <array>
#include <kit/varied.hpp>
#include <utility>
#include <vector>

#include "random.hpp"

/// Questions about highlights, which Phong's model and Blinn's share.
namespace umbral::lighting {

/// What a highlight depends on.
struct Glance {
    glm::vec3 normal{0, 0, 1};
    glm::vec3 l{0, 0, 1};
    glm::vec3 v{0, 0, 1};
    float e = 1;
};

/// A unit vector whose cosine with the unit vector `axis` is `cosine`.
inline glm::vec3 round_about(Random& random, const glm::vec3& axis, float cosine)
{
    const glm::vec3 aside = normalize(cross(axis, random.unit_vector()));
    return cosine * axis + std::sqrt(std::max(0.0F, 1 - cosine * cosine)) * aside;
}

/// A highlight that is not all dark: the viewer stands up to `spread` / √e off the mirrored direction, in radians. The
/// light is in front of the surface, with a cosine of 0.1 to 0.95.
inline Glance random_glance(Random& random, float lowest_e, float highest_e, float spread = 1.5F)
{
    Glance glance;
    glance.normal = random.unit_vector();
    glance.l = round_about(random, glance.normal, random.uniform(0.1F, 0.95F));
    glance.e = lowest_e * std::pow(highest_e / lowest_e, random.uniform());
    const glm::vec3 r = 2 * dot(glance.normal, glance.l) * glance.normal - glance.l;
    glance.v = round_about(random, normalize(r), std::cos(random.uniform(0, spread) / std::sqrt(glance.e)));
    return glance;
}

/// Light from behind the surface; the viewer stands where the formula would see a highlight all the same.
inline Glance glance_from_behind(Random& random)
{
    Glance glance = random_glance(random, 1, 40, 0.8F);
    glance.l = round_about(random, glance.normal, -random.uniform(0.1F, 0.6F));
    const glm::vec3 r = 2 * dot(glance.normal, glance.l) * glance.normal - glance.l;
    glance.v = round_about(random, normalize(r), 0.97F);
    return glance;
}

/// Values that follow without a calculator: exponents 0, cosines of 0 and below, and light that grazes exactly. Varied,
/// they have other exponents but 0, are turned exactly, and come in another order.
inline std::vector<Glance> glances_by_hand(Variation& vary)
{
    constexpr glm::vec3 up(0, 0, 1);
    constexpr glm::vec3 l(0, 0.6F, 0.8F);
    std::vector<Glance> all;
    for (const float written : {0.0F, 1.0F, 2.0F, 5.0F}) {
        const float e = vary.scaled(written, 1.5F);
        all.push_back({up, up, up, e});
        all.push_back({up, l, {0, -0.6F, 0.8F}, e});
        all.push_back({up, l, up, e});
        all.push_back({up, l, l, e});
        all.push_back({up, l, {1, 0, 0}, e});
        all.push_back({up, l, {0, 0.6F, -0.8F}, e});
        // Viewers behind the surface: neither r·v nor n·h is above 0.
        all.push_back({up, {0, 0.8F, 0.6F}, {0, 0.6F, -0.8F}, e});
        all.push_back({up, {0.8F, 0, 0.6F}, {0.6F, 0, -0.8F}, e});
        all.push_back({up, {1, 0, 0}, {-1, 0, 0}, e});
        all.push_back({up, {1, 0, 0}, up, e});
        all.push_back({up, {0, 0.6F, -0.8F}, {0, -0.6F, 0.8F}, e});
    }
    for (Glance& glance : all) {
        const ExactMap map = vary.exact_map(0);
        for (glm::vec3* const one : {&glance.normal, &glance.l, &glance.v}) *one = map.place(*one);
    }
    return in_random_order(vary, std::move(all));
}

/// The same with one of its three vectors, which `turn` chooses, of another length: 1/16 to 16, or, one time in three,
/// 2^-40 to 2^40.
inline Glance with_another_length(Random& random, Glance glance, int turn)
{
    glm::vec3& one = turn % 3 == 0 ? glance.normal : turn % 3 == 1 ? glance.l : glance.v;
    const float farthest = turn / 3 % 3 == 2 ? 40 : 4;
    one *= std::exp2(random.uniform(-farthest, farthest));
    return glance;
}

/// One glance, the same with light and viewer exchanged, which changes nothing, and another viewer, which does.
struct Exchange {
    Glance straight;
    Glance exchanged;
    Glance another;
};

/// The cosines of light and viewer with the normal lie between `low` and `high`: the viewer is in front of the surface,
/// too, since only then the two can be exchanged.
inline Exchange random_exchange(Random& random, float low, float high)
{
    Exchange made;
    made.straight = random_glance(random, 1, 20, 0.7F);
    const glm::vec3 normal = made.straight.normal;
    made.straight.l = round_about(random, normal, random.uniform(low, high));
    made.straight.v = round_about(random, normal, random.uniform(low, high));
    made.exchanged = made.straight;
    std::swap(made.exchanged.l, made.exchanged.v);
    made.another = made.exchanged;
    made.another.v = round_about(random, normal, random.uniform(low, high));
    return made;
}

/// A question about all the light that a surface sends to the eye.
struct Shine {
    SurfacePoint at;
    Material material;
    std::vector<Light> lights;
    glm::vec3 global_ambient{0};
    glm::vec3 eye{0};
};

/// Sums that a hand can do: a sun, a lamp, both and none on a floor, seen from three places. Varied, all colours are
/// darker.
inline std::vector<Shine> shines_by_hand(Variation& vary, float exponent)
{
    const auto color = [&](const glm::vec3& written) {
        return written * vary.one_of(1.0F, std::array{0.5F, 0.625F, 0.75F, 0.875F});
    };
    const Material material{color({0.125F, 0, 0.25F}), color({0.25F, 0.5F, 0.125F}), color({0.5F, 0.25F, 1}),
                            color({0.5F, 1, 0.25F}), exponent};
    const Light sun{{0, 0.6F, 0.8F, 0}, color({1, 0.5F, 2})};
    const Light lamp{{4, 0, 4, 1}, color({0.5F, 1, 0.25F})};
    const std::vector<Light> sets[] = {{}, {sun}, {lamp}, {sun, lamp}, {lamp, sun}};
    std::vector<Shine> all;
    for (const std::vector<Light>& lights : sets)
        for (const glm::vec3& eye : {glm::vec3(0, -3, 5), {0, 0, 3}, {-4, 0, 4}})
            all.push_back({{{0, 0, 1}, {0, 0, 1}}, material, lights, glm::vec3(0.2F), eye});
    return all;
}

/// Lights in front of the surface, mostly up to three, and before them now and then one behind it; the eye is where it
/// sees one of their highlights. Half of the normals have another length than 1.
inline Shine random_shine(Random& random)
{
    Shine shine{
        {3.0F * random.in_cube(), random.unit_vector()}, random_partial_material(random), {}, random_color(random)};
    const std::uint32_t count = random_light_count(random);
    for (std::uint32_t i = 0; i < count; ++i) shine.lights.push_back(random_light(random, shine.at, 0.1F));
    const Light& light = shine.lights[random.below(count)];
    const glm::vec3 l = normalize(glm::vec3(light.position) - light.position.w * shine.at.position);
    const glm::vec3 r = 2 * dot(shine.at.normal, l) * shine.at.normal - l;
    const glm::vec3 v = round_about(random, normalize(r), random.uniform(0.9F, 1));
    shine.eye = shine.at.position + random.uniform(1, 6) * v;
    if (random.below(3) == 0) {
        const SurfacePoint other_side{shine.at.position, -shine.at.normal};
        shine.lights.insert(shine.lights.begin(), random_light(random, other_side, 0.1F));
    }
    vary_colors(random, shine.lights);
    if (random.below(2) == 0) shine.at.normal *= std::exp2(random.uniform(-4, 4));
    return shine;
}

/// The same under lights that are up to 10,000 times as bright, each by a factor of its own.
inline Shine bright_shine(Random& random)
{
    Shine shine = random_shine(random);
    for (Light& light : shine.lights) light.color *= std::pow(10.0F, random.uniform(0, 4));
    return shine;
}

/// The same where nothing can be seen or lit from: the eye is at the point, or a lamp.
inline Shine shine_without_direction(Random& random, bool at_eye)
{
    Shine shine = random_shine(random);
    if (at_eye)
        shine.eye = shine.at.position;
    else
        shine.lights.front().position = glm::vec4(shine.at.position, 1);
    return shine;
}

/// The same but for one thing, for whoever remembers what was asked before: another eye; a lamp beside it, as cameras
/// have; another normal; and all of it as much as 2^24 times as small or large.
inline std::array<Shine, 4> changed_one_by_one(Random& random, Shine shine)
{
    std::array<Shine, 4> all;
    const glm::vec3 v = normalize(shine.eye - shine.at.position);
    shine.eye = shine.at.position + random.uniform(1, 6) * round_about(random, v, random.uniform(0.8F, 0.95F));
    all[0] = shine;
    shine.lights.back().position = glm::vec4(shine.eye, 1);
    all[1] = shine;
    shine.at.normal = normalize(shine.at.normal + 0.5F * random.unit_vector());
    all[2] = shine;
    const float size = std::ldexp(1.0F, static_cast<int>(random.below(49)) - 24);
    shine.at.position *= size;
    shine.eye *= size;
    for (Light& light : shine.lights) light.position *= glm::vec4(glm::vec3(size), 1);
    all[3] = shine;
    return all;
}

/// A sharp highlight among other light. The lamp is near, and the eye nearer: both have most of their digits.
inline Shine sharp_shine(Random& random, bool is_place)
{
    const Glance glance = random_glance(random, 200, 10'000, 1);
    Shine shine = random_shine(random);
    shine.at.normal = glance.normal;
    shine.material.shininess = glance.e;
    shine.material.specular = random_color(random);
    shine.lights = {light_towards(shine.at, glance.l, is_place, random.uniform(0.5F, 4))};
    shine.eye = shine.at.position + random.uniform(0.5F, 4) * glance.v;
    return shine;
}

}
