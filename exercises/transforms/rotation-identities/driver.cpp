#include <cmath>
#include <kit/magnitude.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "globe.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr WorldAxis axes[] = {WorldAxis::x, WorldAxis::y, WorldAxis::z};

ElementaryTurn random_turn(Random& random)
{
    const WorldAxis axis = axes[random.below(3)];
    return {axis, random.uniform(-180, 180)};
}

/// A vector of any size, where only its direction and the share of its length that is lost count: the same to the last
/// bit in any unit, which is taken away again from what is recorded.
struct Sized {
    glm::vec3 vector;
    float unit;
};

Sized any_size(const glm::vec3& vector, Random& random)
{
    const float unit = random_unit(random, -90, 90);
    return {unit * vector, unit};
}

// The course's Rot_x[23°], Rot_y[60°], Rot_z[45°], and turns that a hand can do.
void record_known(Variation& vary, Recorder& out)
{
    for (const WorldAxis axis : axes) {
        for (const float written : {0.0F, 90.0F, -90.0F, 180.0F, 23.0F, 60.0F, 45.0F, 30.0F, 0.01F}) {
            // Quarter turns are exact.
            const float degrees = std::fmod(written, 90.0F) == 0 ? written : vary.scaled(written, 1.3F);
            out.append("matrix", ask<elementary_matrix>(out, {axis, degrees}));
            for (const glm::vec3& v : {glm::vec3(1, 2, 3), {0, 0, 4}})
                out.append("vector", ask<elementary_rotation>(out, by_quarters(vary, v), {axis, degrees}));
        }
    }
}

/// From 10^`lowest` to 10^`highest`, of either sign.
float some_degrees(Random& random, float lowest, float highest)
{
    return std::pow(10.0F, random.uniform(lowest, highest)) * (random.below(2) == 0 ? 1.0F : -1.0F);
}

// Every fourth turn is nearly the one before, about whichever axis, and every fourth is made about each axis in turn;
// every eighth vector is null.
void record_random(Random& random, Recorder& out)
{
    float degrees = 0;
    for (int i = 0; i < 200; ++i) {
        ElementaryTurn turn = random_turn(random);
        if (i % 4 == 3) turn.degrees = degrees + some_degrees(random, -4, -1.5F);
        degrees = turn.degrees;
        out.append("matrix", ask<elementary_matrix>(out, turn));
        const Sized sized = any_size((i % 8 == 1 ? 0.0F : 8.0F) * random.in_cube(), random);
        out.append("vector", ask<elementary_rotation>(out, sized.vector, turn) / sized.unit);
        if (i % 4 != 0) continue;
        for (const WorldAxis axis : in_random_order(random, std::vector(std::begin(axes), std::end(axes)))) {
            const ElementaryTurn same{axis, turn.degrees};
            out.append("matrix", ask<elementary_matrix>(out, same));
            out.append("vector", ask<elementary_rotation>(out, sized.vector, same) / sized.unit);
        }
    }
}

// Both sides of problems 2.12 to 2.14, as the student's vectors have them.
void record_identities(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const ElementaryTurn turn = random_turn(random);
        const glm::vec3 a = 3.0F * random.in_cube();
        const glm::vec3 b = 3.0F * random.in_cube();
        const glm::dvec3 turned_a(ask<elementary_rotation>(out, a, turn));
        out.append("length", length(turned_a));
        const glm::dvec3 turned_b(ask<elementary_rotation>(out, b, turn));
        out.append("dot", dot(turned_a, turned_b));
        out.append("cross of the turned", glm::vec3(cross(turned_a, turned_b)));
        out.append("turned cross", ask<elementary_rotation>(out, glm::vec3(cross(glm::dvec3(a), glm::dvec3(b))), turn));
    }
}

// Up to sixteen million degrees, which a float holds exactly.
void record_quarter_turns(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const int most = i < 30 ? 8 : i < 60 ? 4000 : 180'000;
        const int quarters = static_cast<int>(random.below(2 * static_cast<std::uint32_t>(most))) - most;
        const ElementaryTurn turn{axes[random.below(3)], static_cast<float>(90 * quarters)};
        out.append("matrix", ask<elementary_matrix>(out, turn));
        out.append("vector", ask<elementary_rotation>(out, 8.0F * random.in_cube(), turn));
    }
}

// By quarter turns, or none, and ten thousandths to hundredths of a degree, two of them after one another (by matrices
// down to a hundred thousandth, of which a float at 90 degrees is a multiple); and many times round, up to the largest
// floats, by vectors and by matrices.
void record_many_turns(Random& random, Recorder& out)
{
    float quarters = 0;
    for (int i = 0; i < 40; ++i) {
        if (i % 2 == 0) quarters = static_cast<float>(90 * (static_cast<int>(random.below(9)) - 4));
        const ElementaryTurn turn{axes[random.below(3)], quarters + some_degrees(random, -4, -2)};
        out.append("vector", ask<elementary_rotation>(out, random.unit_vector(), turn));
        out.append("matrix", ask<elementary_matrix>(out, {turn.axis, quarters + some_degrees(random, -5, -2)}));
    }
    for (int i = 0; i < 120; ++i) {
        const float degrees = i % 2 == 0 ? some_degrees(random, 2.5F, 9) : some_degrees(random, 9, 38.5F);
        const ElementaryTurn turn{axes[random.below(3)], degrees};
        out.append("vector", ask<elementary_rotation>(out, random.unit_vector(), turn));
        out.append("matrix", ask<elementary_matrix>(out, turn));
    }
}

/// Of every kind an eighth: no turn at all, one, a null vector, turns about one axis of large and of small angles,
/// turns by quarters among others, there and back with other turns between, turns by 0 among others; the rest of two to
/// eight turns.
std::vector<ElementaryTurn> some_chain(std::size_t kind, Random& random)
{
    std::vector<ElementaryTurn> turns;
    const std::size_t count = kind == 0 ? 0 : kind == 1 ? 1 : 2 + random.below(7);
    const WorldAxis axis = axes[random.below(3)];
    for (std::size_t k = 0; k < count; ++k) {
        ElementaryTurn turn = random_turn(random);
        if (kind == 3) turn = {axis, k % 2 == 0 ? some_degrees(random, 4, 7) : turn.degrees};
        if (kind == 4 && k % 2 == 0) turn.degrees = static_cast<float>(90 * (static_cast<int>(random.below(9)) - 4));
        // Never the last one: it would change nothing there, for whoever ends with it.
        if (kind == 6 && random.below(2) == 0 && k + 1 < count) turn.degrees = 0;
        turns.push_back(turn);
    }
    if (kind == 6) turns.front().degrees = 0;
    if (kind == 5) {
        turns.resize(2);
        // Not about the axis of what stands between: they would cancel.
        turns.front().axis = axes[(static_cast<std::size_t>(turns[1].axis) + 1) % 3];
        turns.push_back({turns.front().axis, -turns.front().degrees});
    }
    return turns;
}

void record_chains(Random& random, Recorder& out)
{
    const ElementaryTurn quarters[] = {{WorldAxis::x, 90}, {WorldAxis::y, 90}};
    out.append("vector", ask<after_turns>(out, {1, 2, 3}, quarters));
    for (std::size_t i = 0; i < 64; ++i) {
        const std::vector<ElementaryTurn> turns = some_chain(i % 8, random);
        const Sized sized = any_size((i % 8 == 2 ? 0.0F : 1.0F) * random.unit_vector(), random);
        out.append("vector", ask<after_turns>(out, sized.vector, turns) / sized.unit);
    }
}

// By a degree, by a thousandth and by a hundred thousandth of one, about the axes in turn; and wild ones.
void record_long_chains(Random& random, Recorder& out)
{
    constexpr std::size_t longest = 600'000;
    for (const float degrees : {1.0F, 1e-3F, 1e-5F, 0.0F}) {
        std::vector<ElementaryTurn> turns(longest);
        for (std::size_t i = 0; i < longest; ++i) turns[i] = {axes[i % 3], degrees};
        if (degrees == 0)
            for (ElementaryTurn& turn : turns) turn = random_turn(random);
        for (const std::size_t count : {std::size_t{6'000}, std::size_t{60'000}, longest}) {
            const glm::vec3 a = random.uniform(0.5F, 1) * random.unit_vector();
            const glm::vec3 b = random.uniform(0.5F, 1) * random.unit_vector();
            const glm::vec3 turned_a = ask<after_turns>(out, a, std::span(turns).first(count));
            out.append("vector", turned_a);
            out.append("length", length(glm::dvec3(turned_a)));
            const glm::vec3 turned_b = ask<after_turns>(out, b, std::span(turns).first(count));
            out.append("vector", turned_b);
            out.append("dot", dot(glm::dvec3(turned_a), glm::dvec3(turned_b)));
        }
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"identities", [](Case& c, Recorder& out) { record_identities(c.random, out); }},
    {"quarter turns", [](Case& c, Recorder& out) { record_quarter_turns(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { record_many_turns(c.random, out); }},
    {"chains", [](Case& c, Recorder& out) { record_chains(c.random, out); }},
    {"long chains", [](Case& c, Recorder& out) { record_long_chains(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("globe", draw_globe(c.vary, out)); }},
};

}
