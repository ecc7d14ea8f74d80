#include <cmath>
#include <limits>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "stage.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr float pi = std::numbers::pi_v<float>;

// Turns whose results a student can work out by hand; Rot_x[23°], Rot_y[60°] and Rot_z[45°] are the course's examples.
void record_known(Variation& vary, Recorder& out)
{
    const AxisAngle turns[] = {
        {{0, 0, 1}, pi / 2},         {{1, 0, 0}, pi / 2}, {{0, 1, 0}, pi / 2}, {{1, 1, 1}, 2 * pi / 3},
        {{1, 0, 0}, 23 * pi / 180},  {{0, 1, 0}, pi / 3}, {{0, 0, 1}, pi / 4}, {{0, 0, -1}, pi / 2},
        {{0, 0, 1}, -pi / 2},        {{0, 3, 4}, pi},     {{2, 0, 0}, 1},      {{1, -1, 0}, 0.5F},
        {{-0.3F, 0.4F, 1.2F}, 2.5F}, {{0, 0, 7}, 0}};
    for (const AxisAngle& written : turns) {
        const AxisAngle turn{vary.exact_map(0).place(written.axis), vary.scaled(written.angle, 1.1F)};
        out.append("matrix", ask<rotation_matrix>(out, turn));
        for (const glm::vec3& vector : {glm::vec3(1, 0, 0), {0, 2, 0}, {1, 2, 3}})
            out.append("vector", ask<rotate_vector>(out, by_quarters(vary, vector), turn));
    }
}

void record_random(Random& random, Recorder& out)
{
    for (const AxisAngle& turn : random_turns(random, 300)) {
        const glm::vec3 vector = 10.0F * random.in_cube();
        out.append("matrix", ask<rotation_matrix>(out, turn));
        out.append("vector", ask<rotate_vector>(out, vector, turn));
    }
}

// Only the direction of the axis counts. Squares of these lengths are no floats. Half of the vectors are as long as the
// axis.
void record_lengths(Random& random, Recorder& out)
{
    for (const float size : {1e-37F, 1e-30F, 1e-22F, 1e-5F, 1e5F, 1e22F, 1e30F, 1e37F}) {
        for (int i = 0; i < 20; ++i) {
            const AxisAngle turn{size * random.unit_vector(), random.uniform(-pi, pi)};
            out.append("matrix", ask<rotation_matrix>(out, turn));
            const glm::vec3 vector = (i % 2 == 0 ? 1 : size) * random.unit_vector();
            out.append("vector", ask<rotate_vector>(out, vector, turn));
        }
    }
}

// Many times round, to both sides, and turns that end close to half a turn.
void record_angles(Random& random, Recorder& out)
{
    for (const float angle : {pi, -pi, 2 * pi, 7.0F, 100.0F, -1e3F, 1e4F, 1e5F, -1e6F, 3.14F, 3.1415F, 3.1416F}) {
        for (int i = 0; i < 10; ++i) {
            const float off = i < 5 ? 0 : random.uniform(-1e-3F, 1e-3F);
            out.append("matrix", ask<rotation_matrix>(out, {random.unit_vector(), angle * (1 + off)}));
        }
    }
}

// Pairs of a turn that turns nothing and one that does, so that neither answer to all of them is worth anything.
void record_nothing(Random& random, Recorder& out)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const AxisAngle idle[] = {{{0, 0, 0}, 1},
                              {{0, 0, 0}, 0},
                              {{0, 0, 0}, -3},
                              {{1, 0, 0}, not_a_number},
                              {{0, 1, 0}, infinity},
                              {{0, 1, 0}, -infinity},
                              {{infinity, 0, 0}, 1},
                              {{0, not_a_number, 1}, 0.5F},
                              {{0, 1, not_a_number}, 0.5F},
                              {{infinity, 1, infinity}, 2}};
    for (const AxisAngle& turn : idle) {
        const AxisAngle other = random_turn(random);
        const bool swapped = random.below(2) == 1;
        for (const AxisAngle& asked : {swapped ? other : turn, swapped ? turn : other}) {
            const glm::vec3 vector = random.in_cube();
            out.append("matrix", ask<rotation_matrix>(out, asked));
            out.append("vector", ask<rotate_vector>(out, vector, asked));
        }
    }
}

// Matrices that are the identity in every entry that a picture would show: each entry counts to its own last digits.
void record_tiny(Random& random, Recorder& out)
{
    for (const float angle : {1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F, 1e-7F, 1e-8F, 1e-12F}) {
        for (int i = 0; i < 40; ++i) {
            const bool flat = i % 2 == 0;
            out.append("entries",
                       ask<rotation_matrix>(out, {clear_axis(flat, random), angle * random.uniform(0.5F, 1)}));
        }
    }
}

void record_chains(Random& random, Recorder& out)
{
    out.append("matrix", ask<compose_rotations>(out, {}));
    const AxisAngle quarter_turns[] = {{{1, 0, 0}, pi / 2}, {{0, 1, 0}, pi / 2}};
    out.append("matrix", ask<compose_rotations>(out, quarter_turns));
    for (std::size_t i = 0; i < 60; ++i) {
        std::vector<AxisAngle> turns = random_turns(random, 2 + i % 7);
        if (i % 5 == 0) turns[1].axis = glm::vec3(0);
        if (i % 5 == 1) turns[0].angle = std::numeric_limits<float>::infinity();
        if (i % 5 == 2) turns[1].axis.y = std::numeric_limits<float>::quiet_NaN();
        if (i % 5 == 3) turns[i % 2].angle = 0;
        if (i % 2 == 1) turns.back().axis *= std::exp2(random.uniform(-100, 100));
        if (i % 3 == 1) turns.front().angle *= 1e5F;
        out.append("matrix", ask<compose_rotations>(out, turns));
    }
}

// The course's chain: 10 000 small turns make one radian, 3.6 million make 57 times round.
void record_long_chains(Random& random, Recorder& out)
{
    const std::vector<AxisAngle> steady(3'600'000, {{1, -2, 2}, 1e-4F});
    for (const std::size_t count : {std::size_t{1000}, std::size_t{10'000}, std::size_t{100'000}, steady.size()})
        out.append("matrix", ask<compose_rotations>(out, std::span(steady).first(count)));
    // Each of these is less than half a unit in the last place of a float 1.
    const std::vector<AxisAngle> creeping(200'000, {{-3, 1, 2}, 2e-8F});
    for (const std::size_t count : {std::size_t{20'000}, creeping.size()})
        out.append("matrix", ask<compose_rotations>(out, std::span(creeping).first(count)));
    for (const float angle : {1e-3F, 0.1F})
        out.append("matrix",
                   ask<compose_rotations>(out, wandering_turns(random.unit_vector(), angle, 200'000, random)));
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"long and short axes", [](Case& c, Recorder& out) { record_lengths(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { record_angles(c.random, out); }},
    {"nothing to turn", [](Case& c, Recorder& out) { record_nothing(c.random, out); }},
    {"tiny angles", [](Case& c, Recorder& out) { record_tiny(c.random, out); }},
    {"chains", [](Case& c, Recorder& out) { record_chains(c.random, out); }},
    {"long chains", [](Case& c, Recorder& out) { record_long_chains(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_flower(c.vary, out)); }},
};

}
