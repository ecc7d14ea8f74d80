#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "colored_lights.hpp"
#include "rooms.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record(Recorder& out, const std::vector<LightQuestion>& questions, std::string_view name = "lit")
{
    // All casters stand in the same place of memory, so that whoever knows them by that is found out.
    ShadowCasters casters;
    for (const LightQuestion& question : questions) {
        casters = question.casters;
        out.append(name, ask<sees_light>(out, question.point, question.light, casters));
    }
}

// Answers that need no computing; behind each point with light comes one without.
std::vector<LightQuestion> by_hand()
{
    const ShadedPoint ground{{0, 0, 0}, {0, 1, 0}, 1e-6F};
    const ShadedPoint wall{{-2, 1, 3}, {1, 0, 0}, 1e-6F};
    const ShadowBall above{{0, 3, 0}, 1};
    const ShadowBall high{{0, 8, 0}, 1};
    const ShadowBall beside{{3, 3, 0}, 1};
    const ShadowBall below{{0, -3, 0}, 1};
    const ShadowBall before_wall{{2, 1, 3}, 0.25F};
    const ShadowBall behind_wall{{-4, 1, 3}, 1};
    const ShadowBall far_off{{100, 1, 3}, 1};
    const ShadowTriangle roof{{-2, 2, -2}, {2, 2, -2}, {0, 2, 3}};
    const glm::vec4 lamp(0, 5, 0, 1);
    const glm::vec4 sun(0, 5, 0, 0);
    return {
        {ground, lamp, {}},
        {ground, {0, -5, 0, 1}, {}},
        {ground, sun, {}},
        {ground, -sun, {}},
        {ground, lamp, {{beside}, {}}},
        {ground, lamp, {{above}, {}}},
        {ground, lamp, {{high}, {}}},
        {ground, sun, {{high}, {}}},
        {ground, lamp, {{below}, {}}},
        {ground, sun, {{beside, below, above}, {}}},
        {ground, {6, 6, 0, 1}, {{above}, {roof}}},
        {ground, {6, 6, 0, 1}, {{beside}, {}}},
        {ground, {8, 0.5F, 0, 0}, {{above, beside}, {roof}}},
        {ground, {0.5F, 8, 0, 0}, {{beside}, {roof}}},
        {wall, {5, 1, 3, 1}, {{above, high}, {roof}}},
        {wall, {5, 1, 3, 1}, {{before_wall}, {}}},
        {wall, {0.25F, 0, 0, 0}, {{behind_wall}, {}}},
        {wall, {0.25F, 0, 0, 0}, {{far_off}, {}}},
    };
}

// Light from above and below the surface; there is nothing in the way but the surface itself, and every second pair
// lacks even that.
std::vector<LightQuestion> turned_away(Random& random)
{
    std::vector<LightQuestion> questions;
    for (int i = 0; i < 100; ++i) {
        const SurfaceSite site = random_site(random, 5.0F * random.in_cube(), std::exp2(random.uniform(-1, 1)));
        const ShadowCasters none;
        const double sine = 0.05 + 0.9 * random.uniform_double();
        double reach = 0;
        const auto towards = [&](double side) {
            return random_light(site, direction_above(site, side, random), i % 4 < 2, reach, random);
        };
        const LightQuestion lit{site.rounded, towards(sine), i % 2 == 0 ? site.own : none};
        const LightQuestion dark{site.rounded, towards(-sine), lit.casters};
        add_pair(questions, lit, dark, random);
    }
    return questions;
}

// Light that nearly runs along the surface.
std::vector<LightQuestion> grazing(Random& random)
{
    std::vector<LightQuestion> questions;
    for (int i = 0; i < 120; ++i) {
        const double size = std::exp2(random.uniform(-2, 2));
        const SurfaceSite site = random_site(random, static_cast<float>(3 * size) * random.unit_vector(), size);
        // More than half of them within a sixth of a degree, down to what the interface promises.
        const double digits = i % 5 < 3 ? random.uniform(-2.95F, -2.5F) : random.uniform(-2.5F, -1.3F);
        add_light_pair(questions, site, std::pow(10.0, digits), i, random);
    }
    return questions;
}

void record_scales(Random& random, Recorder& out)
{
    for (const double size : {1e-4, 1e-3, 1e-2}) record(out, light_pairs(random, size, 4 * size, 40), "tiny scenes");
    for (const double size : {1e2, 1e4, 1e6}) record(out, light_pairs(random, size, 4 * size, 40), "huge scenes");
    for (const double away : {1e3, 1e5, 1e7})
        record(out, light_pairs(random, 1e-3 * away, away, 40), "far from the origin");
}

void record_contact(Random& random, Recorder& out)
{
    record(out, contact_pairs(random, 1e-4, 1e-4, 30));
    for (const double size : {1.0, 1e4}) record(out, contact_pairs(random, size, 4 * size, 30));
    record(out, contact_pairs(random, 1e3, 1e6, 30));
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int width = 288;
    constexpr int height = 192;
    const Camera camera = varied(vary, {{0.6F, 5.4F, 7.2F}, {0, 0.72F, 0.1F}, 0.36F});
    const ShadowCasters casters = spiral_of_balls();
    out.image("colours", ray_traced(width, height, camera, [&](const Ray& ray) { return lamp_light(ray, casters); }));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, in_pairs(c.random, by_hand())); }},
    {"rooms", [](Case& c, Recorder& out) { record(out, room_pairs(c.random)); }},
    {"random", [](Case& c, Recorder& out) { record(out, light_pairs(c.random, 1, 4, 300)); }},
    {"turned away", [](Case& c, Recorder& out) { record(out, turned_away(c.random)); }},
    {"grazing", [](Case& c, Recorder& out) { record(out, grazing(c.random)); }},
    {"scales", [](Case& c, Recorder& out) { record_scales(c.random, out); }},
    {"contact", [](Case& c, Recorder& out) { record_contact(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
