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
        {{0, 0, 1}, pi / 2},         {{1, 0, 0}, pi / 2}, {{0, 1, 0}, pi / 2},  {{1, 1, 1}, 2 * pi / 3},
        {{1, 0, 0}, 23 * pi / 180},  {{0, 1, 0}, pi / 3}, {{0, 0, 1}, pi / 4},  {{0, 0, -1}, pi / 2},
        {{0, 0, 1}, -pi / 2},        {{0, 3, 4}, pi},     {{2, 0, 0}, 1},       {{1, -1, 0}, 0.5F},
        {{-0.3F, 0.4F, 1.2F}, 2.5F}, {{0, 0, 7}, 0},      {{-1, 0, 0}, pi / 2}, {{-2.5F, 0, 0}, 0.7F},
        {{0, -1, 0}, pi / 3},        {{0, -0.5F, 0}, 2}};
    for (const AxisAngle& written : turns) {
        const AxisAngle turn{vary.exact_map(0).place(written.axis), vary.scaled(written.angle, 1.1F)};
        out.append("matrix", ask<rotation_matrix>(out, turn));
        for (const glm::vec3& vector : {glm::vec3(1, 0, 0), {0, 2, 0}, {1, 2, 3}})
            out.append("vector", ask<rotate_vector>(out, by_quarters(vary, vector), turn));
    }
}

/// A vector along the axis, to either side, but for a hundredth to a hundred-thousandth of its length at most.
glm::vec3 vector_along(const glm::vec3& axis, bool exactly, Random& random)
{
    const glm::vec3 along = (random.below(2) == 0 ? -4.0F : 4.0F) * axis;
    const float aside = exactly ? 0 : std::pow(10.0F, random.uniform(-5, -2));
    return along + aside * length(along) * random.unit_vector();
}

// A quarter of the vectors lie along the axis, or almost.
void record_random(Random& random, Recorder& out)
{
    int row = 0;
    for (const AxisAngle& turn : random_turns(random, 300)) {
        const glm::vec3 anywhere = 10.0F * random.in_cube();
        const glm::vec3 vector = row % 4 == 3 ? vector_along(turn.axis, row % 16 == 15, random) : anywhere;
        out.append("matrix", ask<rotation_matrix>(out, turn));
        out.append("vector", ask<rotate_vector>(out, vector, turn));
        ++row;
    }
}

// Only the direction of the axis counts. Squares of these lengths are no floats, and the shortest axes have no float of
// all digits in them. Half of the vectors are as long as the axis, if a float of that size has all its digits.
void record_lengths(Random& random, Recorder& out)
{
    for (const float size : {1e-44F, 1e-40F, 1e-37F, 1e-30F, 1e-22F, 1e-5F, 1e5F, 1e22F, 1e30F, 1e37F}) {
        for (int i = 0; i < 20; ++i) {
            const AxisAngle turn{size * random.unit_vector(), random.uniform(-pi, pi)};
            out.append("matrix", ask<rotation_matrix>(out, turn));
            const glm::vec3 vector = (i % 2 == 0 || size < 1e-37F ? 1 : size) * random.unit_vector();
            out.append("vector", ask<rotate_vector>(out, vector, turn));
        }
    }
    // The length of many of these axes is no float, nor is the sum of their components; nor, in half of the turns, the
    // term (1 - cosθ)(s·e) of the formula.
    constexpr float largest = std::numeric_limits<float>::max();
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 alike = glm::vec3(0.75F) + 0.25F * random.in_cube();
        const glm::vec3 axis = i % 2 == 0 ? random.unit_vector() : (i % 4 == 1 ? -alike : alike);
        const AxisAngle turn{largest * axis, i % 8 < 4 ? random.uniform(2.2F, pi) : random.uniform(-pi, pi)};
        out.append("matrix", ask<rotation_matrix>(out, turn));
        const glm::vec3 near_the_axis = normalize(normalize(axis) + 0.6F * random.unit_vector());
        const glm::vec3 direction = i % 8 < 4 ? near_the_axis : random.unit_vector();
        out.append("vector", ask<rotate_vector>(out, 3e38F * direction, turn));
    }
}

// Many times round, to both sides, also by floats that are far apart, and turns that end close to half a turn.
void record_angles(Random& random, Recorder& out)
{
    for (const float angle :
         {pi, -pi, 2 * pi, 7.0F, 100.0F, -1e3F, 1e4F, 1e5F, -1e6F, 1e13F, -3e38F, 3.14F, 3.1415F, 3.1416F}) {
        for (int i = 0; i < 10; ++i) {
            const float off = i < 5 ? 0 : random.uniform(-1e-3F, 1e-3F);
            const AxisAngle turn{random.unit_vector(), angle * (1 + off)};
            out.append("matrix", ask<rotation_matrix>(out, turn));
            out.append("vector", ask<rotate_vector>(out, random.unit_vector(), turn));
        }
    }
}

/// Turns that turn nothing: one number that is not finite, at each place, and axes of no length.
std::vector<AxisAngle> idle_turns(Random& random)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<AxisAngle> turns;
    for (const float bad : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
        for (int place = 0; place < 3; ++place) {
            AxisAngle turn = random_turn(random);
            turn.axis[place] = bad;
            if (random.below(2) == 0) turn.axis[(place + 1) % 3] = 0;
            turns.push_back(turn);
        }
        turns.push_back({random_turn(random).axis, bad});
    }
    for (const float angle : {1.0F, 0.0F, -3.0F, infinity}) turns.push_back({glm::vec3(0), angle});
    return turns;
}

// Pairs of a turn that turns nothing and one that does, so that neither answer to all of them is worth anything. Every
// fourth vector is the zero vector, which stays what it is in any turn.
void record_nothing(Random& random, Recorder& out)
{
    int pair = 0;
    for (const AxisAngle& turn : idle_turns(random)) {
        const AxisAngle other = random_turn(random);
        const float length = ++pair % 4 == 0 ? 0 : 1;
        const bool swapped = random.below(2) == 1;
        for (const AxisAngle& asked : {swapped ? other : turn, swapped ? turn : other}) {
            const glm::vec3 vector = length * random.in_cube();
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

/// The turns, and all of them back, the last one first: by the angle the other way, or about the opposite axis.
std::vector<AxisAngle> there_and_back(std::vector<AxisAngle> turns, Random& random)
{
    for (std::size_t i = turns.size(); i-- > 0;) {
        const auto [axis, angle] = turns[i];
        turns.push_back(random.below(2) == 0 ? AxisAngle{axis, -angle} : AxisAngle{-axis, angle});
    }
    return turns;
}

/// Turns of which two at a time are about one line, seen from the same side or from the other one.
std::vector<AxisAngle> turns_in_twos(std::size_t pairs, Random& random)
{
    std::vector<AxisAngle> turns;
    for (const AxisAngle& turn : random_turns(random, pairs)) {
        const float length = std::ldexp(1.0F, static_cast<int>(random.below(5)) - 2);
        turns.push_back(turn);
        turns.push_back({(random.below(3) == 0 ? length : -length) * turn.axis, random.uniform(-3.1F, 3.1F)});
    }
    return turns;
}

/// `count` turns about one axis, each faster than the one before by next to nothing, up to twice as fast.
std::vector<AxisAngle> turns_that_speed_up(const glm::vec3& axis, float angle, std::size_t count)
{
    std::vector<AxisAngle> turns;
    turns.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        turns.push_back({axis, angle * (1 + static_cast<float>(i) / static_cast<float>(count))});
    return turns;
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
        if (i % 2 == 1) turns.back().axis *= std::exp2(random.uniform(-146, 126));
        if (i % 3 == 1) turns.front().angle *= 1e5F;
        out.append("matrix", ask<compose_rotations>(out, turns));
    }
    for (std::size_t i = 0; i < 20; ++i) {
        std::vector<AxisAngle> turns = turns_in_twos(1 + i % 4, random);
        // Between two turns about one line, one about the same axis that turns nothing.
        if (i % 2 == 1)
            turns.insert(turns.begin() + 1, {turns[0].axis, i % 4 == 1 ? std::numeric_limits<float>::quiet_NaN()
                                                                       : std::numeric_limits<float>::infinity()});
        out.append("matrix", ask<compose_rotations>(out, turns));
        out.append("matrix", ask<compose_rotations>(out, there_and_back(random_turns(random, 2 + i % 3), random)));
    }
}

// The course's chain: 10 000 small turns make one radian, 3.6 million make 57 times round. None of these numbers of
// turns is even, or the same again.
void record_long_chains(Random& random, Recorder& out)
{
    const auto about = [&](std::size_t count) {
        return count - 1 - 2 * random.below(static_cast<unsigned>(count / 20));
    };
    const std::vector<AxisAngle> steady(3'600'000, {{1, -2, 2}, 1e-4F});
    for (const std::size_t count : {std::size_t{1000}, std::size_t{10'000}, std::size_t{100'000}, steady.size()})
        out.append("matrix", ask<compose_rotations>(out, std::span(steady).first(about(count))));
    // Each of these is less than half a unit in the last place of a float 1.
    const std::vector<AxisAngle> creeping(200'000, {{-3, 1, 2}, 2e-8F});
    for (const std::size_t count : {std::size_t{20'000}, creeping.size()})
        out.append("matrix", ask<compose_rotations>(out, std::span(creeping).first(about(count))));
    for (const float angle : {1e-3F, 0.1F})
        out.append("matrix",
                   ask<compose_rotations>(out, wandering_turns(random.unit_vector(), angle, about(200'000), random)));
    for (const float angle : {1e-5F, 1e-4F}) {
        const glm::vec3 axis = random.unit_vector();
        out.append("matrix", ask<compose_rotations>(out, turns_that_speed_up(axis, angle, about(200'000))));
    }
    for (const float angle : {0.01F, 3.0F}) {
        const glm::vec3 axis = random.unit_vector();
        const std::vector<AxisAngle> turns = wandering_turns(axis, angle, about(2000), random);
        out.append("matrix", ask<compose_rotations>(out, there_and_back(turns, random)));
    }
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
