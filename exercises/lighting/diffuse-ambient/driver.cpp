#include <algorithm>
#include <array>
#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../random.hpp"
#include "orrery.hpp"

namespace umbral {
namespace {

using namespace lighting;

// One question about the light at a place.
struct Question {
    SurfacePoint at;
    Material material;
    std::vector<Light> lights;
    glm::vec3 global_ambient{0};
};

void record(Recorder& out, const Question& q, std::string_view name = "light")
{
    out.append(name, ask<matt_reflection>(out, q.at, q.material, q.lights, q.global_ambient));
}

// Numbers that a hand can work out. Varied, directions are turned exactly, and colours are darker.
void by_hand(Variation& vary, Recorder& out)
{
    const std::pair<Light, glm::vec3> pairs[] = {{{{0, 0, 5, 1}}, {0, 0, 1}},  {{{4, 5, 2, 1}}, {1, 1, 2}},
                                                 {{{3, 0, 4, 0}}, {7, -2, 1}}, {{{0, -2, 0, 0}}, {5, 5, 5}},
                                                 {{{0, 0, 0, 1}}, {2, 2, 1}},  {{{-1, 4, 9, 1}}, {1, 7, 3}},
                                                 {{{2, 6, 3, 0}}, {1, 1, 1}}};
    for (const auto& [light, point] : pairs) {
        const ExactMap map = vary.exact_map(0);
        const Light turned{map.place(light.position), light.color};
        out.append("towards", ask<direction_to_light>(out, turned, map.place(point)));
    }

    const SurfacePoint up{{0, 0, 1}, {0, 0, 1}};
    const auto color = [&](const glm::vec3& written) {
        return written * vary.one_of(1.0F, std::array{0.5F, 0.625F, 0.75F, 0.875F});
    };
    const Light sun{{0, 0.6F, 0.8F, 0}, color({1, 0.5F, 2})};
    const Light lamp{{4, 0, 4, 1}, color({0.5F, 1, 0.25F})};
    const Material painted{color({0.125F, 0, 0.25F}), color({0.25F, 0.5F, 0.125F}), color({0.5F, 0.25F, 1})};
    const Material matt{{}, {}, color({1, 0.5F, 0.25F})};
    const Light below{{0, 0, -1, 0}, {1, 1, 1}};
    const std::vector<Light> sets[] = {{}, {sun}, {lamp}, {sun, lamp}, {below}, {below, lamp}};
    for (const std::vector<Light>& lights : sets) {
        record(out, {up, painted, lights, glm::vec3(0.2F)});
        record(out, {up, matt, lights, glm::vec3(0.2F)});
    }
}

Question random_question(Random& random, std::uint32_t count)
{
    const SurfacePoint at{3.0F * random.in_cube(), random.unit_vector()};
    Question q{at, random_partial_material(random), {}, random_color(random)};
    for (std::uint32_t i = 0; i < count; ++i) q.lights.push_back(random_light(random, q.at, 0.05F));
    vary_colors(random, q.lights);
    // Two lights may be one lamp.
    if (count > 1 && random.below(8) == 0) q.lights.back().position = q.lights.front().position;
    return q;
}

// How many lights there are has no limit. All together are as bright as one or two.
void many_lights(Random& random, Recorder& out)
{
    for (const std::uint32_t least : {33U, 17U, 65U, 256U, 1000U, 13U, 129U, 0xFFFFU + 1}) {
        const std::uint32_t count = least + random.below(least / 4);
        Question q = random_question(random, std::min(count, 100U));
        // Of more than a hundred many are alike.
        for (std::uint32_t i = 100; i < count; ++i) q.lights.push_back(q.lights[i % 100]);
        for (Light& light : q.lights) light.color *= 4.0F / static_cast<float>(count);
        for (const std::size_t last : {std::size_t{0}, q.lights.size() - 1})
            q.lights[last] = random_light(random, q.at, 0.5F);
        record(out, q);
    }
}

// Lights are not so near that the rounding of places turns them.
bool is_allowed(const Question& q)
{
    return std::ranges::all_of(q.lights, [&](const Light& light) {
        const float w = light.position.w;
        return (w == 0 || w == 1) && length(glm::vec3(light.position) - w * q.at.position) > 0.4F;
    });
}

// One number changed alone, of which many become 0; then lists with the same light twice, with it alone, with none.
void record_changed(Random& random, Recorder& out, Question q)
{
    for (const Question& changed : numbers_changed(random, q, 8, [](const Question& one) { return is_allowed(one); }))
        record(out, changed);
    const Light light = q.lights[random.below(static_cast<std::uint32_t>(q.lights.size()))];
    for (const auto& [towards, point] :
         numbers_changed(random, std::pair(light, q.at.position), 4, [](const auto& one) {
             return is_allowed({{one.second, {}}, {}, {one.first}});
         }))
        out.append("towards", ask<direction_to_light>(out, towards, point));
    q.lights.push_back(light);
    record(out, q);
    q.lights = {light};
    record(out, q);
    q.lights.clear();
    record(out, q);
}

// Lights on the side of the normal, so that each of them counts; but a lamp that is taken for a sun, or a sun for a
// lamp.
void at_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        Question q = random_question(random, random_light_count(random));
        record(out, q);
        out.append("towards", ask<direction_to_light>(out, q.lights.front(), q.at.position));
        if (i % 5 != 0) continue;
        // Then the same but for one thing or two, for whoever remembers what was asked before.
        q.at.normal = random.unit_vector();
        record(out, q);
        q.lights.resize(i % 10 == 0 ? 1 : q.lights.size());
        record(out, q);
        float& w = q.lights.front().position.w;
        if (i % 2 == 0)
            q.at.position[i / 10 % 3] += i % 4 == 0 ? 0.125F : 2;
        else
            w = 1 - w;
        record(out, q);
        out.append("towards", ask<direction_to_light>(out, q.lights.front(), q.at.position));
        if (i % 2 == 0)
            q.material = random_partial_material(random);
        else
            q.lights.front().color = random_color(random);
        q.global_ambient = random_color(random);
        record(out, q);
        record_changed(random, out, q);
    }
}

// One light in front and one behind, in random order.
void behind(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        Question q = random_question(random, 2);
        SurfacePoint other_side = q.at;
        other_side.normal = -other_side.normal;
        q.lights[random.below(2)] = random_light(random, other_side, 0.05F);
        record(out, q);
    }
}

// Off by a hundredth down to a hundred-thousandth.
float nearly_one(Random& random)
{
    return 1 + (random.below(2) == 0 ? -1.0F : 1.0F) * std::pow(10.0F, random.uniform(-5, -2));
}

// Normals that are not unit, and lights from near to far: neither changes the light.
void lengths(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        Question q = random_question(random, 1);
        if (i % 2 == 0) {
            q.at.normal *= i % 4 == 0 ? nearly_one(random) : std::exp2(random.uniform(-4, 4));
        } else {
            const glm::vec3 direction = q.at.normal + 0.5F * random.unit_vector();
            q.lights[0] = light_towards(q.at, direction, i % 4 == 1, std::exp2(random.uniform(-5, 5)));
        }
        record(out, q);
        out.append("towards", ask<direction_to_light>(out, q.lights[0], q.at.position));
    }
}

// A light at the point, a direction or a normal that is null; in pairs with the same thing in order.
void degenerate(Random& random, Recorder& out)
{
    for (int i = 0; i < 18; ++i) {
        const Question usual = random_question(random, 2);
        Question q = usual;
        if (i % 3 == 0) q.lights[0].position = glm::vec4(q.at.position, 1);
        if (i % 3 == 1) q.lights[0].position = glm::vec4(0);
        if (i % 3 == 2) q.at.normal = glm::vec3(0);
        const bool first = random.below(2) == 0;
        for (const bool strange : {first, !first}) {
            const Question& asked = strange ? q : usual;
            record(out, asked);
            const Light& light = strange && i % 3 == 2 ? Light{glm::vec4(0, 0, 0, 0)} : asked.lights[0];
            out.append("towards", ask<direction_to_light>(out, light, asked.at.position));
        }
    }
}

// Radiance has no upper bound, and no lower one above 0.
void bright(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        Question q = random_question(random, 2);
        const float exponent = i % 2 == 0 ? random.uniform(-8, 8) : random.uniform(-30, 36);
        const float scale = std::pow(10.0F, exponent);
        for (Light& light : q.lights) light.color *= scale * std::pow(10.0F, random.uniform(0, 1));
        q.material.emission *= i % 3 == 0 ? 0 : scale;
        q.global_ambient *= i % 3 == 0 ? 0 : scale;
        record(out, q);
    }
}

// Light that grazes the surface: the cosine is the small difference of large products. Nothing else is there.
void grazing(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        Question q = random_question(random, 0);
        q.at.position *= 30.0F;
        q.material = {{}, {}, random_color(random)};
        const glm::vec3 n = normalize(q.at.normal);
        const glm::vec3 aside = normalize(cross(n, random.unit_vector()));
        const float cosine = std::pow(10.0F, random.uniform(-6.5F, -2));
        q.lights = {light_towards(q.at, aside + cosine * n, i % 2 == 0, random.uniform(20, 200))};
        record(out, q);
    }
}

// Squares of these lengths are no floats; some lengths are no normalised ones.
void tiny_and_huge(Random& random, Recorder& out)
{
    for (const float size : {2e-44F, 1e-42F, 1e-39F, 1e-37F, 1e-30F, 1e-22F, 1e22F, 1e30F, 1e37F})
        for (int i = 0; i < 8; ++i) {
            Question q = random_question(random, 0);
            const glm::vec3 direction = q.at.normal + 0.5F * random.unit_vector();
            q.at.position = size * random.in_cube();
            if (i % 3 != 1) q.at.normal *= size;
            q.lights = {light_towards(q.at, direction, i % 2 == 0, size)};
            record(out, q);
            out.append("towards", ask<direction_to_light>(out, q.lights[0], q.at.position));
        }
    // Nearly 1, as lengths are that were made so elsewhere.
    for (int i = 0; i < 16; ++i) {
        Question q = random_question(random, 1);
        q.at.normal *= nearly_one(random);
        const glm::vec3 direction = q.at.normal + 0.5F * random.unit_vector();
        q.lights = {light_towards(q.at, direction, i % 2 == 0, nearly_one(random))};
        record(out, q);
        out.append("towards", ask<direction_to_light>(out, q.lights[0], q.at.position));
    }
    // Floats whose length is none; some are that far to both sides of the origin.
    for (int i = 0; i < 16; ++i) {
        Question q = random_question(random, 0);
        glm::vec3 corner(0);
        for (int k = 0; k < 3; ++k) corner[k] = random.uniform(2e38F, 3.3e38F) * (random.below(2) == 0 ? 1.0F : -1.0F);
        q.at.normal = normalize(corner / 1e38F) + 0.5F * random.unit_vector();
        q.lights = {{glm::vec4(corner, static_cast<float>(i % 2)), glm::vec3(1)}};
        if (i % 4 == 1) q.at.position = -0.75F * corner;
        record(out, q);
        out.append("towards", ask<direction_to_light>(out, q.lights[0], q.at.position));
    }
}

// Twice the light; and all of it turned, first the surface alone and then the lights with it.
void record_laws(Random& random, Recorder& out)
{
    for (int i = 0; i < 30; ++i) {
        Question q = random_question(random, 2);
        q.material.emission = glm::vec3(0);
        record(out, q, "once");
        Question twice = q;
        twice.global_ambient *= 2.0F;
        for (Light& light : twice.lights) light.color *= 2.0F;
        record(out, twice, "twice");
        const float angle = random.uniform(0.5F, 2.5F);
        const glm::mat4 turn = glm::rotate(glm::mat4(1), angle, random.unit_vector());
        Question turned = q;
        turned.at = {glm::vec3(turn * glm::vec4(q.at.position, 1)), glm::mat3(turn) * q.at.normal};
        record(out, turned, "turned alone");
        for (Light& light : turned.lights) light.position = turn * light.position;
        record(out, turned, "turned together");
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"many lights", [](Case& c, Recorder& out) { many_lights(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { behind(c.random, out); }},
    {"lengths", [](Case& c, Recorder& out) { lengths(c.random, out); }},
    {"degenerate", [](Case& c, Recorder& out) { degenerate(c.random, out); }},
    {"bright", [](Case& c, Recorder& out) { bright(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.random, out); }},
    {"grazing", [](Case& c, Recorder& out) { grazing(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { tiny_and_huge(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("orrery", orrery(400, 260, c.vary)); }},
};

}
