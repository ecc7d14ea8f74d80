#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../highlights.hpp"
#include "rack.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record(Recorder& out, const Glance& g, std::string_view name = "highlight")
{
    out.append(name, ask<phong_highlight>(out, g.normal, g.l, g.v, g.e));
}

void record(Recorder& out, const Shine& s)
{
    out.append("light", ask<phong_reflection>(out, s.at, s.material, s.lights, s.global_ambient, s.eye));
}

void by_hand(Variation& vary, Recorder& out)
{
    const std::pair<glm::vec3, glm::vec3> mirrors[] = {
        {{0, 0, 1}, {0, 0, 1}}, {{0, 0.6F, 0.8F}, {0, 0, 1}}, {{1, 2, 3}, {0, 1, 0}},  {{1, 0, 0}, {0, 0, 1}},
        {{1, 0, 0}, {1, 1, 0}}, {{3, 4, 0}, {0, 0, 7}},       {{2, -1, 5}, {1, 2, 2}}, {{0, 3, -4}, {0, 0, 1}}};
    for (const auto& [l, normal] : mirrors) {
        const ExactMap map = vary.exact_map(0);
        out.append("mirrored", ask<mirrored_direction>(out, map.place(l), map.place(normal)));
    }
    for (const Glance& glance : glances_by_hand(vary)) record(out, glance);
    // Exponents below 1: of the cosines 0.8 and 0.28 they make larger numbers.
    for (const float written : {0.5F, 0.25F})
        for (const float place : {0.0F, 0.6F}) {
            const ExactMap map = vary.exact_map(0);
            const glm::vec3 v = place == 0 ? glm::vec3(0, 0, 1) : glm::vec3(0, 0.6F, 0.8F);
            record(out, {map.place({0, 0, 1}), map.place({0, 0.6F, 0.8F}), map.place(v), vary.scaled(written, 1.5F)});
        }

    for (const Shine& shine : shines_by_hand(vary, 2)) record(out, shine);
}

void at_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 l = random.uniform(0.5F, 3) * random.unit_vector();
        const Glance glance = i % 4 == 1   ? wide_glance(random)
                              : i % 8 == 3 ? flat_glance(random)
                                           : random_glance(random, 1, 40);
        // Coordinates that are 0 stand beside others here, too.
        out.append("mirrored", i % 8 == 3 ? ask<mirrored_direction>(out, glance.l, glance.normal)
                                          : ask<mirrored_direction>(out, l, random.unit_vector()));
        record(out, glance);
        if (i % 5 == 0) record(out, {glance.normal, glance.l, glance.v, 0.5F * glance.e});
        const Shine shine = random_shine(random);
        record(out, shine);
        if (i % 5 != 0) continue;
        for (const Shine& changed : changed_one_by_one(random, shine)) record(out, changed);
    }
}

// Pairs of light from behind and from the front.
void behind(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool from_behind : {first, !first})
            record(out, from_behind ? glance_from_behind(random) : random_glance(random, 1, 40, 0.8F));
    }
}

// The three vectors have any length, one after the other.
void lengths(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const Glance glance = with_another_length(random, random_glance(random, 1, 40), i);
        record(out, glance);
        out.append("mirrored", ask<mirrored_direction>(out, glance.l, glance.normal));
        // A mirror's normal says more by its length than a highlight's does: here it is short or long in every row.
        const float doublings = (i % 3 == 0 ? 1.0F : -1.0F) * random.uniform(20, 40);
        const glm::vec3 normal = std::exp2(doublings) * random.unit_vector();
        out.append("mirrored", ask<mirrored_direction>(out, glance.l, normal));
    }
}

// Materials, lights and exponents of all kinds, each kind in an eighth of the rows or more; one eye sees several
// points.
void scenes(Random& random, Recorder& out)
{
    std::vector<std::uint32_t> kinds;
    for (std::uint32_t i = 0; i < 48; ++i) kinds.push_back(i);
    for (const std::uint32_t kind : in_random_order(random, kinds))
        for (const Shine& shine : scene_of_any_kind(random, kind)) record(out, shine);
}

// Pairs of a question with a null vector and the same one without.
void degenerate(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        const Glance usual = random_glance(random, 1, 40, 0.8F);
        Glance null = usual;
        (i % 3 == 0 ? null.normal : i % 3 == 1 ? null.l : null.v) = glm::vec3(0);
        if (i % 4 == 0) null.e = 0;
        const bool first = random.below(2) == 0;
        for (const bool is_null : {first, !first}) {
            const Glance& asked = is_null ? null : usual;
            record(out, asked);
            out.append("mirrored", ask<mirrored_direction>(out, usual.l, is_null ? glm::vec3(0) : usual.normal));
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
        const Exchange exchange = random_exchange(random, 0.8F, 0.95F);
        record(out, exchange.straight, "straight");
        record(out, exchange.exchanged, "exchanged");
        record(out, exchange.another, "another");
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

// Light in the surface's plane, but for the last digits of its floats: they decide whether it is in front.
void terminator(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        Glance glance = random_glance(random, 1, 1);
        glance.l = random.uniform(0.5F, 2) * round_about(random, glance.normal, 0);
        glance.v = -glance.l;
        record(out, glance);
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { behind(c.random, out); }},
    {"lengths", [](Case& c, Recorder& out) { lengths(c.random, out); }},
    {"scenes", [](Case& c, Recorder& out) { scenes(c.random, out); }},
    {"degenerate", [](Case& c, Recorder& out) { degenerate(c.random, out); }},
    {"bright", [](Case& c, Recorder& out) { bright(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.random, out); }},
    {"sharp", [](Case& c, Recorder& out) { sharp(c.random, out); }},
    {"terminator", [](Case& c, Recorder& out) { terminator(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("rack", rack(320, 208, c.vary)); }},
};

}
