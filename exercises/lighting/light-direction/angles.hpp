#pragma once

#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/lighting/light_direction.hpp>
#include <umbral/record/ask.hpp>

/// Angles and directions that are asked for each other, and those for which float has too few digits.
namespace umbral::lighting {

inline glm::vec2 pair_of(const LightAngles& angles) { return {angles.longitude_degrees, angles.latitude_degrees}; }

inline void record_direction(Recorder& out, const LightAngles& angles)
{
    out.append("direction", ask<light_direction>(out, angles));
}

inline void record_angles(Recorder& out, const glm::vec3& direction)
{
    out.columns("angles", "longitude, latitude");
    out.append("angles", pair_of(ask<light_angles>(out, direction)));
}

/// Next to the poles: y / |d| is 1 there but for the last digits.
inline void record_poles(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const double off = std::pow(10.0, i % 3 == 0 ? random.uniform(-44, -6) : random.uniform(-6, -1));
        const double alpha = glm::radians(random.uniform(1, 359));
        record_angles(out, glm::vec3(off * std::sin(alpha), i % 2 == 0 ? 1 : -1, off * std::cos(alpha)));
    }
    // Squares of these lengths are no floats.
    for (const float size : {1e-38F, 1e-30F, 1e-23F, 1e20F, 1e30F, 1e38F})
        for (int i = 0; i < 5; ++i) record_angles(out, size * random.unit_vector());
    // Next to the horizon.
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 direction = random.unit_vector();
        record_angles(out, direction * glm::vec3(1, std::pow(10.0F, random.uniform(-38, -3)), 1));
    }
    // Next to the longitude 0: above it, and two or three floats below 360.
    for (int i = 0; i < 30; ++i) {
        const double above = std::pow(10.0, i % 4 == 0 ? random.uniform(-38, -7) : random.uniform(-7, -4.5F));
        const double alpha = glm::radians(i % 2 == 0 ? above : -double{random.uniform(6.5e-5F, 9.5e-5F)});
        record_angles(out, glm::vec3(std::sin(alpha), random.uniform(-1, 1), std::cos(alpha)));
    }
}

/// Many turns: the angle in radians has no digits left in float.
inline void many_turns(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const float turns = std::pow(10.0F, random.uniform(3.5F, 7)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        record_direction(out, {turns, random.uniform(-89, 89)});
    }
    // Of either angle so many that neither double nor any whole number counts them.
    for (int i = 0; i < 30; ++i) {
        const float turns = std::pow(10.0F, random.uniform(7, 38)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        const float other = random.uniform(-89, 89);
        record_direction(out, i % 3 == 0 ? LightAngles{other, turns} : LightAngles{turns, other});
    }
}

}
