#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "baubles.hpp"
#include "lit_sphere.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record_seen(Recorder& out, const LitSphere& q)
{
    out.append("brightest seen", ask<brightest_seen>(out, q.sphere, q.light, q.eye));
}

void record_specular(Recorder& out, const LitSphere& q, std::string_view name = "specular")
{
    out.append(name, ask<brightest_specular>(out, q.sphere, q.light, q.eye));
}

void record(Recorder& out, const LitSphere& q)
{
    out.append("diffuse", ask<brightest_diffuse>(out, q.sphere, q.light));
    record_seen(out, q);
    record_specular(out, q);
}

void record_is_seen(Recorder& out, const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    out.append("is seen", ask<is_seen>(out, sphere, point, eye));
}

/// A sphere's own turned exactly, its places and its light. Unless inputs are to vary, as it is.
LitSphere turned(Variation& vary, LitSphere q)
{
    const ExactMap map = vary.exact_map(0);
    for (glm::vec3* const place : {&q.sphere.centre, &q.eye}) *place = map.place(*place);
    q.light.position = map.place(q.light.position);
    return q;
}

// Light and eye at equal angles and different distances from a point that a hand works out: (0, 1, 0), (3, 4, 0), …
// The half vector of the directions from the centre leads elsewhere.
std::vector<LitSphere> uneven_by_hand()
{
    return {{{{0, 0, 0}, 1}, {{3, 5, 0, 1}}, {-6, 9, 0}},
            {{{0, 0, 0}, 5}, {{2, 11, 0, 1}}, {17, 6, 0}},
            {{{1, 2, 3}, 2}, {{4, 2, 9, 1}}, {-0.5F, 2, 7}},
            {{{0, 0, 0}, 1}, {{3, 4, 0, 0}}, {-6, 9, 0}},
            {{{0, 0, 0}, 1}, {{1, 0, 1, 0}}, {4, 0, -3}},
            {{{0, 0, 0}, 1}, {{0, 12, -6, 1}}, {0, -24, -11}},
            {{{2, 0, 0}, 0.5F}, {{2, 2.5F, 1.5F, 1}}, {2, 4.5F, -3}},
            {{{0, 0, 0}, 1}, {{3.6F, 4.8F, 5, 1}}, {6.6F, 8.8F, -10}}};
}

// Problem 3.9; the same with other sizes, equally far places, directions, and all on one line. Varied, each question is
// turned exactly, and they come in another order.
void by_hand(Variation& vary, Recorder& out)
{
    const Light lamp{{0, 2, 0, 1}};
    const std::vector<LitSphere> questions = {{{{0, 0, 0}, 1}, lamp, {2, 0, 0}},
                                              {{{0, 0, 0}, 1}, lamp, {0, 0, -2}},
                                              {{{1, 2, 3}, 2}, {{1, 6, 3, 1}}, {5, 2, 3}},
                                              {{{0, 0, 0}, 1}, {{0, 0, 4, 0}}, {0, 0, 9}},
                                              {{{0, 0, 0}, 1}, {{0, 5, 0, 1}}, {0, 3, 0}},
                                              {{{0, 0, 0}, 1}, {{0, 5, 0, 1}}, {0, -3, 0}},
                                              {{{0, 0, 0}, 1}, {{-1, 0, 0, 0}}, {4, 0, 0}},
                                              {{{0, 0, 0}, 5}, {{15, 20, 0, 1}}, {-15, 20, 0}},
                                              {{{2, 0, 0}, 0.5F}, {{0, 0, 3, 0}}, {2, 0.8F, 0.6F}},
                                              {{{0, 0, 0}, 1}, {{1, 2, 0, 1}}, {-1, 2, 0}},
                                              // In one direction, whose unit vector has a length that is rounded up.
                                              {{{0, 0, 0}, 1}, {{-6, 8, -7, 1}}, {-18, 24, -21}},
                                              {{{0, 0, 0}, 1}, {{-1, 2, -8, 1}}, {-3, 6, -24}},
                                              {{{0, 0, 0}, 1}, {{12, -18, 3, 1}}, {4, -6, 1}},
                                              {{{0, 0, 0}, 1}, {{7, 3, -5, 1}}, {14, 6, -10}}};
    for (const LitSphere& q : in_random_order(vary, questions)) record(out, turned(vary, q));
    for (const LitSphere& q : in_random_order(vary, uneven_by_hand())) record_specular(out, turned(vary, q));
    struct Sight {
        Sphere sphere;
        glm::vec3 point{0};
        glm::vec3 eye{0};
    };
    std::vector<Sight> sights;
    for (const glm::vec3& point : {glm::vec3(0, 1, 0), {1, 0, 0}, {-1, 0, 0}, {0.6F, 0.8F, 0}, {0.28F, 0.96F, 0}})
        sights.push_back({{}, point, {2, 0, 0}});
    for (const glm::vec3& point : {glm::vec3(6, 6, 4), {2, 7, 7}, {5, 3, 8}, {2, 6, 0}})
        sights.push_back({{{2, 3, 4}, 5}, point, {12, 9, 3}});
    for (const Sight& sight : in_random_order(vary, std::move(sights))) {
        const ExactMap map = vary.exact_map(0);
        record_is_seen(out, {map.place(sight.sphere.centre), sight.sphere.radius}, map.place(sight.point),
                       map.place(sight.eye));
    }
}

/// A point that is seen and one that is not, in random order.
void record_points(Random& random, Recorder& out, const Sphere& sphere, const glm::vec3& eye)
{
    const bool first = random.below(2) == 0;
    for (const bool seen : {first, !first}) {
        const float horizon = sphere.radius / length(eye - sphere.centre);
        const float cosine = seen ? random.uniform(horizon + 0.02F, 1) : random.uniform(-1, horizon - 0.02F);
        const glm::vec3 n = round_about(random, normalize(eye - sphere.centre), cosine);
        record_is_seen(out, sphere, sphere.centre + sphere.radius * n, eye);
    }
}

/// As random questions are: places outside and not far off, and no doubt whether there is an answer.
bool is_allowed(const LitSphere& q)
{
    const float radius = q.sphere.radius;
    const float w = q.light.position.w;
    const glm::vec3 to_light = glm::vec3(q.light.position) - w * q.sphere.centre;
    const glm::vec3 to_eye = q.eye - q.sphere.centre;
    const auto fits = [&](const glm::vec3& v) { return length(v) > 1.3F * radius && length(v) < 12 * radius; };
    if (radius < 0.3F || radius > 2 || length(q.sphere.centre) > 5.2F || q.light.color == glm::vec3(0)) return false;
    if ((w != 0 && w != 1) || !fits(to_eye) || !(w == 1 ? fits(to_light) : length(to_light) > 0.1F)) return false;
    const float cosine_lit = w == 1 ? radius / length(to_light) : 0;
    const float limit = std::acos(cosine_lit) + std::acos(radius / length(to_eye));
    const float cosine = dot(normalize(to_light), normalize(to_eye));
    const float share = std::acos(glm::clamp(cosine, -1.0F, 1.0F)) / limit;
    return share < 0.9F || share > 1.1F;
}

void at_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        LitSphere q = random_lit_sphere(random, random.uniform(0.05F, 0.9F));
        record(out, q);
        record_points(random, out, q.sphere, q.eye);
        if (i % 5 != 0) continue;
        q.light.color = 2.0F * random_color(random);
        for (const LitSphere& changed :
             numbers_changed(random, q, 8, [](const LitSphere& one) { return is_allowed(one); })) {
            record(out, changed);
            record_points(random, out, changed.sphere, changed.eye);
        }
        // The eye where the lamp is.
        q.light.position = glm::vec4(q.eye, 1);
        record(out, q);
    }
}

// Pairs: light and eye see a part of the sphere in common, or, a few degrees further apart, they do not.
void record_blocked(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool blocked : {first, !first}) {
            const float share = blocked ? random.uniform(1.05F, 1.3F) : random.uniform(0.6F, 0.95F);
            const LitSphere q = random_lit_sphere(random, share);
            record_seen(out, q);
            record_specular(out, q);
        }
    }
}

// Directions of light of any length: the place of the sphere does not matter to them.
void record_directions(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        LitSphere q = random_lit_sphere(random, random.uniform(0.1F, 0.9F), 0);
        q.light.position *= std::pow(10.0F, random.uniform(-3, 3));
        record(out, q);
    }
}

// Points of the horizon, and the same ones with the eye a little higher or lower; whole numbers, so that n·v is exact,
// or such numbers over a power of two.
void record_horizon(Random& random, Recorder& out)
{
    const glm::vec3 triples[] = {{3, 4, 0}, {0, 4, -3}, {-4, 0, 3}, {0, 5, 0}, {-3, 0, -4}, {5, 0, 0}};
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 n = triples[i % 6];
        const glm::vec3 centre(random.below(9), random.below(9), random.below(9));
        const glm::vec3 tangent = n.y == 0 ? glm::vec3(0, 1, 0) : glm::vec3(n.y, -n.x, 0);
        const glm::vec3 eye = centre + n + (2.0F + static_cast<float>(random.below(5))) * tangent;
        const float unit = std::exp2(-static_cast<float>(i % 3 == 0 ? random.below(16) : 0U));
        const bool first = random.below(2) == 0;
        for (const bool seen : {first, !first}) {
            const glm::vec3 from = seen ? eye + n / 64.0F : i % 2 == 0 ? eye : eye - n / 64.0F;
            record_is_seen(out, {unit * centre, 5 * unit}, unit * (centre + n), unit * from);
        }
    }
}

// Light and eye exchange their places; and the eye moves elsewhere.
void record_laws(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const LitSphere q = random_lit_sphere(random, random.uniform(0.3F, 0.8F), 1);
        record_specular(out, q, "straight");
        LitSphere exchanged = q;
        exchanged.light.position = glm::vec4(q.eye, 1);
        exchanged.eye = glm::vec3(q.light.position);
        record_specular(out, exchanged, "exchanged");
        exchanged.eye = q.sphere.centre + 3 * q.sphere.radius * normalize(q.eye - q.sphere.centre + random.in_cube());
        record_specular(out, exchanged, "another");
    }
}

// Light or eye, or both, just above the surface: small steps along it turn l and v far.
void record_close(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const float near = 1 + std::pow(10.0F, random.uniform(-2.9F, -1));
        const float other = i % 3 == 0 ? random.uniform(2, 5) : 1 + std::pow(10.0F, random.uniform(-2.9F, -1));
        const LitSphere q =
            lit_sphere(random, {}, random.uniform(0.1F, 0.9F), i % 2 == 0 ? near : other, i % 2 == 0 ? other : near);
        record_seen(out, q);
        record_specular(out, q);
    }
}

// A great way off, one of them or both.
void record_far(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        const float far = std::pow(10.0F, random.uniform(2, 6));
        const float other = i % 3 == 0 ? random.uniform(1.5F, 5) : std::pow(10.0F, random.uniform(2, 6));
        const LitSphere q =
            lit_sphere(random, {}, random.uniform(0.1F, 0.98F), i % 2 == 0 ? far : other, i % 2 == 0 ? other : far);
        record(out, q);
    }
}

// The way from the eye to the light all but touches the sphere, on this side or the other.
void record_edge(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool blocked : {first, !first}) {
            const float off = std::pow(10.0F, random.uniform(-5.5F, -3));
            const float light_radii = i % 4 == 0 ? 0 : random.uniform(1.05F, 6);
            const LitSphere q =
                lit_sphere(random, {}, blocked ? 1 + off : 1 - off, light_radii, random.uniform(1.05F, 6));
            record_seen(out, q);
            record_specular(out, q);
        }
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"blocked", [](Case& c, Recorder& out) { record_blocked(c.random, out); }},
    {"directions", [](Case& c, Recorder& out) { record_directions(c.random, out); }},
    {"horizon", [](Case& c, Recorder& out) { record_horizon(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.random, out); }},
    {"close", [](Case& c, Recorder& out) { record_close(c.random, out); }},
    {"far", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"edge", [](Case& c, Recorder& out) { record_edge(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("baubles", baubles(400, 260, c.vary)); }},
};

}
