#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "scenes.hpp"

/// Level floors, upright walls and light in planes of the axes: numbers as people write them, of which no random
/// direction ever has one.
namespace umbral::raytracing {

/// The corners of a rectangle as two triangles.
inline void add_rectangle(ShadowCasters& casters, const glm::vec3& corner, const glm::vec3& one, const glm::vec3& other)
{
    casters.triangles.push_back({corner, corner + one, corner + one + other});
    casters.triangles.push_back({corner, corner + one + other, corner + other});
}

/// A pair: a point of a level floor, or the uppermost one of a ball, and a light behind an upright wall, whose plane
/// holds the normal; the other light is in the same direction before the wall, or over it, or the wall is on the other
/// side. Any axis is up, and all but the light is exact.
inline void add_room_pair(std::vector<LightQuestion>& questions, int kind, Random& random)
{
    const float size = std::ldexp(1.0F, static_cast<int>(random.below(25)) - 10);
    const auto eighths = [&](int low, int high) {
        return 0.125F *
               static_cast<float>(low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low))));
    };
    // Turned by quarters of a turn: y up before, any axis behind.
    Variation any(VariedSeed::with_mark(random.bits()));
    const ExactMap turn = any.exact_map(0);
    const auto place = [&](const glm::vec3& p) { return size * turn.place(p); };

    const float x = eighths(-32, 32);
    const glm::vec3 p(x, eighths(-8, 8), eighths(-32, 32));
    LightQuestion lit;
    lit.point = {place(p), turn.place(glm::vec3(0, 1, 0)), size * std::exp2(random.uniform(-22, -18))};
    if (kind % 4 == 3)
        lit.casters.balls.push_back({place(p - glm::vec3(0, 2, 0)), 2 * size});
    else
        add_rectangle(lit.casters, place({-8, p.y, -8}), place({16, 0, 0}), place({0, 0, 16}));
    LightQuestion dark = lit;

    // The wall, which starts below the light's way and ends above it.
    const float side = random.below(2) == 0 ? 1 : -1;
    const glm::vec3 foot(p.x + side * eighths(2, 24), p.y, p.z - 4);
    const float height = eighths(4, 32);
    const auto add_wall = [&](ShadowCasters& casters, const glm::vec3& at) {
        add_rectangle(casters, place(at), place({0, height, 0}), place({0, 0, 8}));
    };
    add_wall(dark.casters, foot);
    const float across = kind % 2 == 0 ? 0.0F : 3 * random.uniform(-1, 1);
    const glm::vec3 through(foot.x - p.x, height * random.uniform(0.2F, 0.8F), across);
    const bool is_sun = random.below(2) == 0;
    const auto light = [&](const glm::vec3& way) {
        return is_sun ? glm::vec4(turn.place(way), 0) : glm::vec4(place(p + way), 1);
    };
    dark.light = light(random.uniform(1.2F, 3) * through);
    lit.light = dark.light;
    const std::uint32_t why = random.below(3);
    if (why == 0) {
        add_wall(lit.casters, glm::vec3(2 * p.x - foot.x, foot.y, foot.z));
    } else {
        add_wall(lit.casters, foot);
        if (why == 1 && !is_sun)
            lit.light = light(random.uniform(0.3F, 0.9F) * through);
        else
            lit.light = light(random.uniform(1.2F, 3) * glm::vec3(through.x, height * random.uniform(1.2F, 2), across));
    }
    add_pair(questions, lit, dark, random);
}

inline std::vector<LightQuestion> room_pairs(Random& random)
{
    std::vector<LightQuestion> questions;
    for (int i = 0; i < 60; ++i) add_room_pair(questions, i, random);
    return questions;
}

}
