#include <algorithm>
#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../highlights.hpp"
#include "harbour.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record_half(Recorder& out, const glm::vec3& l, const glm::vec3& v)
{
    out.append("half", ask<half_vector>(out, l, v));
}

void record(Recorder& out, const Glance& g, std::string_view name = "highlight")
{
    out.append(name, ask<blinn_highlight>(out, g.normal, g.l, g.v, g.e));
}

void record(Recorder& out, const Shine& s)
{
    out.append("light", ask<blinn_phong_reflection>(out, s.at, s.material, s.lights, s.global_ambient, s.eye));
}

void by_hand(Variation& vary, Recorder& out)
{
    const std::pair<glm::vec3, glm::vec3> pairs[] = {{{0, 0, 1}, {0, 0, 1}},   {{0, 0.6F, 0.8F}, {0, -0.6F, 0.8F}},
                                                     {{1, 0, 0}, {0, 1, 0}},   {{0, 3, 0}, {0, 0, 0.25F}},
                                                     {{2, 1, 2}, {-2, -1, 2}}, {{0, 0.6F, 0.8F}, {0, 0, 1}},
                                                     {{1, 2, 2}, {-1, 2, 2}},  {{8, 0, 0}, {-0.6F, 0.8F, 0}}};
    for (const auto& [l, v] : pairs) {
        const ExactMap map = vary.exact_map(0);
        record_half(out, map.place(l), map.place(v));
    }
    for (const Glance& glance : glances_by_hand(vary)) record(out, glance);

    for (const Shine& shine : shines_by_hand(vary, 4)) record(out, shine);
}

/// One of the lights comes from behind the surface, though its half vector lies in front of it.
Shine lit_from_behind(Random& random)
{
    Shine shine = random_shine(random);
    const glm::vec3 normal = normalize(shine.at.normal);
    shine.lights.back().position = glm::vec4(round_about(random, normal, -random.uniform(0.05F, 0.4F)), 0);
    shine.eye = shine.at.position + random.uniform(1, 6) * round_about(random, normal, 0.95F);
    return shine;
}

using Directions = std::pair<glm::vec3, glm::vec3>;

// Single numbers changed must leave what float can answer within the tolerances: no small difference of large numbers,
// and no power below 1 of a cosine next to 0, which rises steeply there.

glm::vec3 unit_or_null(const glm::vec3& v) { return v == glm::vec3(0) ? v : normalize(v); }

bool is_allowed(const Directions& d)
{
    const bool has_null = d.first == glm::vec3(0) || d.second == glm::vec3(0);
    return has_null || length(normalize(d.first) + normalize(d.second)) > 0.44F;
}

bool is_allowed(const Glance& g)
{
    const glm::vec3 n = unit_or_null(g.normal);
    const glm::vec3 l = unit_or_null(g.l);
    const glm::vec3 v = unit_or_null(g.v);
    const bool is_steep = g.e > 0 && g.e < 1 && std::abs(dot(n, l + v)) < 0.02F;
    return g.e >= 0 && !is_steep && is_allowed(Directions(g.l, g.v));
}

bool is_allowed(const Shine& s)
{
    const glm::vec3 v = s.eye - s.at.position;
    return length(v) > 0.25F && std::ranges::all_of(s.lights, [&](const Light& light) {
               if (light.position.w != 0 && light.position.w != 1) return false;
               const glm::vec3 l = glm::vec3(light.position) - light.position.w * s.at.position;
               return length(l) > 0.25F && is_allowed(Glance{s.at.normal, l, v, s.material.shininess});
           });
}

/// Lists of lights that random ones are not: none, the same light twice, one that is the last of the list before.
void record_other_lists(Random& random, Recorder& out, Shine shine)
{
    shine.lights.push_back(shine.lights[random.below(static_cast<std::uint32_t>(shine.lights.size()))]);
    record(out, shine);
    shine.lights = {shine.lights.back()};
    record(out, shine);
    shine.lights.clear();
    record(out, shine);
}

void at_random(Random& random, Recorder& out)
{
    const auto allowed = [](const auto& question) { return is_allowed(question); };
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 l = random.unit_vector();
        const glm::vec3 v = round_about(random, l, random.uniform(-0.9F, 1));
        record_half(out, l, v);
        record(out, random_glance(random, 1, 40));
        Shine shine = i % 5 == 1 ? lit_from_behind(random) : random_shine(random);
        record(out, shine);
        if (i % 5 != 0) continue;
        record_other_lists(random, out, shine);
        for (const Shine& changed : changed_one_by_one(random, shine)) record(out, changed);
        for (const auto& [one, other] : numbers_changed(random, Directions(l, v), 3, allowed))
            record_half(out, one, other);
        for (const Glance& changed : numbers_changed(random, random_glance(random, 1, 40, 0.8F), 6, allowed))
            record(out, changed);
        // A broad highlight, which fractions of 1 for its exponent are.
        if (i % 10 == 0) shine.material.shininess = random.uniform(0.1F, 0.9F);
        for (const Shine& changed : numbers_changed(random, shine, 8, allowed))
            if (is_allowed(changed)) record(out, changed);
    }
}

// Pairs of a highlight and of none: the light behind the surface, though the half vector lies in front of it; or the
// light in front, and the viewer so far behind that the half vector is, too.
void behind(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool from_behind : {first, !first}) {
            Glance glance = random_glance(random, 1, 40, 0.8F);
            if (from_behind) {
                const float side = i % 2 == 0 ? 1.0F : -1.0F;
                glance.l = round_about(random, glance.normal, -side * random.uniform(0.05F, 0.4F));
                glance.v = round_about(random, glance.normal, side * 0.95F);
            }
            record(out, glance);
        }
    }
}

// The three vectors have any length, one after the other.
void lengths(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const Glance glance = with_another_length(random, random_glance(random, 1, 40), i);
        record(out, glance);
        if (i % 3 != 0) record_half(out, glance.l, glance.v);
    }
}

// Pairs of a question without a half vector, or with a null normal, and a usual one. Opposite vectors need not be
// equally long.
void degenerate(Random& random, Recorder& out)
{
    for (int i = 0; i < 32; ++i) {
        const Glance usual = random_glance(random, 1, 40, 0.8F);
        Glance none = usual;
        if (i % 4 == 0) none.normal = glm::vec3(0);
        if (i % 4 == 1) none.l = glm::vec3(0);
        if (i % 4 == 2) none.v = glm::vec3(0);
        if (i % 4 == 3) none.v = -none.l * (i % 8 == 3 ? 1.0F : 4.0F);
        if (i % 4 == 0 || i % 8 > 4) none.e = 0;
        const bool first = random.below(2) == 0;
        for (const bool is_none : {first, !first}) {
            const Glance& asked = is_none ? none : usual;
            record(out, asked);
            record_half(out, asked.l, is_none && i % 4 == 0 ? -asked.l : asked.v);
        }
        record(out, shine_without_direction(random, i % 2 == 0));
    }
}

void bright(Random& random, Recorder& out)
{
    for (int i = 0; i < 30; ++i) record(out, bright_shine(random));
}

void record_laws(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const Exchange exchange = random_exchange(random, 0.6F, 0.9F);
        record(out, exchange.straight, "straight");
        record(out, exchange.exchanged, "exchanged");
        record(out, exchange.another, "another");
    }
}

// Light and viewer opposite each other but for a small angle: hardly a digit of their sum is left in float.
void nearly_opposite(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const glm::vec3 l = random.unit_vector();
        const float angle = std::pow(10.0F, random.uniform(-6.5F, -2));
        const glm::vec3 v = angle * normalize(cross(l, random.unit_vector())) - l;
        record_half(out, random.uniform(0.5F, 4) * l, v);
    }
}

// Squares of these lengths are no floats.
void tiny_and_huge(Random& random, Recorder& out)
{
    for (const float size : {1e-38F, 1e-30F, 1e-22F, 1e22F, 1e30F, 3e38F}) {
        const glm::vec3 both = size * random.unit_vector();
        record_half(out, both, both);
        for (int i = 0; i < 6; ++i) {
            const glm::vec3 l = random.unit_vector();
            const glm::vec3 v = round_about(random, l, random.uniform(-0.8F, 0.9F));
            record_half(out, i % 2 == 0 ? size * l : l, i % 3 == 0 ? v : size * v);
        }
    }
}

// Highlights of a few degrees: the power makes much of what was rounded before.
void sharp(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        Glance glance = random_glance(random, 200, 10'000);
        // Some are so short that float holds none of their products.
        const float size = i % 4 == 0 ? 1e-30F : 1.0F;
        glance.normal *= size;
        glance.l *= size * random.uniform(0.5F, 4);
        glance.v *= random.uniform(0.5F, 4);
        record(out, glance);
    }
    for (int i = 0; i < 60; ++i) record(out, sharp_shine(random, i % 2 == 0));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { behind(c.random, out); }},
    {"lengths", [](Case& c, Recorder& out) { lengths(c.random, out); }},
    {"degenerate", [](Case& c, Recorder& out) { degenerate(c.random, out); }},
    {"bright", [](Case& c, Recorder& out) { bright(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.random, out); }},
    {"nearly opposite", [](Case& c, Recorder& out) { nearly_opposite(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { tiny_and_huge(c.random, out); }},
    {"sharp", [](Case& c, Recorder& out) { sharp(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("harbour", harbour(320, 208, c.vary)); }},
};

}
