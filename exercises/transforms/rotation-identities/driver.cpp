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

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const ElementaryTurn turn = random_turn(random);
        out.append("matrix", ask<elementary_matrix>(out, turn));
        const Sized sized = any_size(8.0F * random.in_cube(), random);
        out.append("vector", ask<elementary_rotation>(out, sized.vector, turn) / sized.unit);
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

// By quarter turns, or none, and ten thousandths to hundredths of a degree; and many times round.
void record_many_turns(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        const auto quarters = static_cast<float>(90 * (static_cast<int>(random.below(9)) - 4));
        const float beside = std::pow(10.0F, random.uniform(-4, -2)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        const ElementaryTurn turn{axes[random.below(3)], quarters + beside};
        out.append("vector", ask<elementary_rotation>(out, random.unit_vector(), turn));
    }
    for (const float degrees : {1e3F, 1e4F, 1e5F, 1e6F, 1e7F, 1e9F, 1e15F, 1e30F}) {
        for (int i = 0; i < 15; ++i) {
            const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
            const ElementaryTurn turn{axes[random.below(3)], sign * degrees * random.uniform(0.3F, 1)};
            out.append("vector", ask<elementary_rotation>(out, random.unit_vector(), turn));
        }
    }
}

void record_chains(Random& random, Recorder& out)
{
    out.append("vector", ask<after_turns>(out, {1, 2, 3}, {}));
    const ElementaryTurn quarters[] = {{WorldAxis::x, 90}, {WorldAxis::y, 90}};
    out.append("vector", ask<after_turns>(out, {1, 2, 3}, quarters));
    for (std::size_t i = 0; i < 60; ++i) {
        std::vector<ElementaryTurn> turns;
        for (std::size_t k = 0; k < 2 + i % 7; ++k) turns.push_back(random_turn(random));
        const Sized sized = any_size(random.unit_vector(), random);
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
