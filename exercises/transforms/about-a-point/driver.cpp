#include <cmath>
#include <kit/magnitude.hpp>
#include <limits>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "changed.hpp"
#include "kaleidoscope.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr float pi = std::numbers::pi_v<float>;

void record_known(Variation& vary, Recorder& out)
{
    // Directions are turned by quarters of a turn, which round nothing.
    const auto along = [&](const glm::vec3& direction) { return vary.exact_map(0).place(direction) + 0.0F; };  // no -0
    const auto factor = [&](float written) { return vary.scaled(written, 1.2F); };
    for (const glm::vec3& written : {glm::vec3(0, 0, 0), {1, 0, 0}, {1, 2, 3}}) {
        const glm::vec3 centre = by_quarters(vary, written);
        out.append("rotation", ask<rotation_about_point>(out, centre, {along({0, 0, 1}), vary.near(pi / 2, 0.2F)}));
        out.append("rotation", ask<rotation_about_point>(out, centre, {along({0, 2, 0}), vary.near(pi / 4, 0.2F)}));
        out.append("scaling", ask<scaling_about_point>(out, centre, factor(1) * glm::vec3(2, 2, 2)));
        out.append("scaling", ask<scaling_about_point>(out, centre, factor(1) * glm::vec3(1, -1, 0.5F)));
        out.append("scaling", ask<scaling_about_point>(out, centre, factor(1) * glm::vec3(2, 0, -3)));
        out.append("along", ask<scaling_along>(out, centre, along({0, 0, 2}), factor(3)));
        out.append("along", ask<scaling_along>(out, centre, along({1, 1, 0}), factor(0.5F)));
        out.append("along", ask<scaling_along>(out, centre, along({0, 3, 4}), factor(0)));
        out.append("along", ask<scaling_along>(out, centre, along({1, 0, 1}), factor(-1)));
        out.append("along", ask<scaling_along>(out, centre, along({0, 2, 0}), factor(-2)));
        out.append("point", ask<reflection_in_point>(out, centre));
        out.append("line", ask<reflection_in_line>(out, centre, along({0, 3, 0})));
        out.append("line", ask<reflection_in_line>(out, centre, along({1, 1, 0})));
        out.append("plane", ask<reflection_in_plane>(out, centre, along({0, 0, 2})));
        out.append("plane", ask<reflection_in_plane>(out, centre, along({1, 0, 1})));
        out.append("placed", ask<placed_along>(out, centre, along({0, 0, 5})));
        out.append("placed", ask<placed_along>(out, centre, along({3, 0, 0})));
        out.append("placed", ask<placed_along>(out, centre, along({0, 3, 4})));
    }
    const auto record_alignment = [&](const glm::vec3& from, const glm::vec3& to) {
        const ExactMap map = vary.exact_map(0);
        out.append("alignment", ask<alignment>(out, map.place(from) + 0.0F, map.place(to) + 0.0F));
    };
    record_alignment({1, 0, 0}, {0, 1, 0});
    record_alignment({0, 0, 2}, {0, 3, 0});
    record_alignment({1, 2, 3}, {2, 4, 6});
    record_alignment({1, 0, 0}, {1, 1, 0});
    record_alignment({1, 2, 2}, {2, 1, -2});
}

/// From -size to size; one time in four 0, and now and then 1 or -1.
float random_factor(float size, Random& random)
{
    const std::uint32_t kind = random.below(12);
    if (kind < 3) return 0;
    if (kind < 5) return kind == 3 ? 1.0F : -1.0F;
    return random.uniform(-size, size);
}

/// Ten to the power of a number between these.
float power_of_ten(float low, float high, Random& random) { return std::pow(10.0F, random.uniform(low, high)); }

void record_random(Random& random, Recorder& out)
{
    AxisAngle turn{};
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 centre = 8.0F * random.in_cube();
        const glm::vec3 direction = random.uniform(0.5F, 4) * random.unit_vector();
        // Every fourth turn has nearly the axis of the one before; others go round up to 100,000 times.
        AxisAngle next = random_turn(random);
        if (i % 4 == 3) next.axis = turn.axis + 0.01F * random.in_cube();
        if (i % 2 == 0) next.angle *= power_of_ten(0.5F, 5.3F, random);
        turn = next;
        out.append("rotation", ask<rotation_about_point>(out, centre, turn));
        glm::vec3 factors;
        for (int k = 0; k < 3; ++k) factors[k] = random_factor(5, random);
        out.append("scaling", ask<scaling_about_point>(out, centre, factors));
        out.append("along", ask<scaling_along>(out, centre, direction, random_factor(4, random)));
        out.append("point", ask<reflection_in_point>(out, centre));
        out.append("line", ask<reflection_in_line>(out, centre, direction));
        out.append("plane", ask<reflection_in_plane>(out, centre, direction));
        out.append("placed", ask<placed_along>(out, centre, direction));
        // From 0.2 to 2.9 radians apart.
        const glm::vec3 from = random.unit_vector();
        const glm::vec3 aside = normalize(cross(from, random.unit_vector()));
        const float angle = random.uniform(0.2F, 2.9F);
        const float size = random.uniform(0.5F, 4);
        out.append("alignment", ask<alignment>(out, direction.x > 0 ? 3.0F * from : from,
                                               size * (std::cos(angle) * from + std::sin(angle) * aside)));
        if (i % 5 == 0) record_changed(random, out);
    }
}

// Pairs of a question about a null direction and one about another, in random order.
void record_null(Random& random, Recorder& out)
{
    const glm::vec3 null(0);
    for (int i = 0; i < 42; ++i) {
        const glm::vec3 centre = 3.0F * random.in_cube();
        const glm::vec3 given = random.unit_vector();
        const glm::vec3 other = random.unit_vector();
        const float factor = random.uniform(-3, 0);
        const bool first = random.below(2) == 1;
        for (const bool is_null : {first, !first}) {
            const glm::vec3 direction = is_null ? null : given;
            if (i % 7 == 0) out.append("matrix", ask<reflection_in_line>(out, centre, direction));
            if (i % 7 == 1) out.append("matrix", ask<reflection_in_plane>(out, centre, direction));
            if (i % 7 == 2) out.append("matrix", ask<alignment>(out, direction, other));
            if (i % 7 == 3) out.append("matrix", ask<alignment>(out, other, direction));
            if (i % 7 == 4) out.append("matrix", ask<placed_along>(out, centre, direction));
            if (i % 7 == 5) out.append("matrix", ask<scaling_along>(out, centre, direction, factor));
            if (i % 7 == 6) out.append("matrix", ask<rotation_about_point>(out, centre, {direction, 1 - factor}));
        }
    }
}

// Turns with a number that is not finite, which turn nothing, in pairs with others, in random order.
void record_not_finite(Random& random, Recorder& out)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 centre = 3.0F * random.in_cube();
        const AxisAngle given = random_turn(random);
        AxisAngle bad = given;
        const float number = i / 4 % 3 == 0 ? std::numeric_limits<float>::quiet_NaN()
                             : i % 2 == 0   ? infinity
                                            : -infinity;
        if (i % 4 == 3)
            bad.angle = number;
        else
            bad.axis[i % 4] = number;
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first})
            out.append("rotation", ask<rotation_about_point>(out, centre, is_bad ? bad : given));
    }
}

// Small changes about centres that are far away, and mirrors that hang far away from the point that is given of them
// and near the origin: the translation is the difference of nearly equal points.
void record_far(Random& random, Recorder& out)
{
    for (const float far : {1e3F, 3e4F, 1e6F}) {
        for (const float change : {1e-2F, 1e-4F, 3e-6F, 1e-6F}) {
            for (int i = 0; i < 8; ++i) {
                const glm::vec3 centre = far * random.unit_vector();
                const glm::vec3 axis = clear_axis(false, random);
                const float angle = (i % 2 == 0 ? 10 : 0.1F) * change * random.uniform(0.5F, 1);
                const float more = change * random.uniform(0.5F, 1) * (random.below(2) == 0 ? 1.0F : -1.0F);
                out.append("rotation", ask<rotation_about_point>(out, centre, {axis, angle}));
                out.append("scaling", ask<scaling_about_point>(out, centre, 1.0F + change * random.in_cube()));
                out.append("along", ask<scaling_along>(out, centre, axis, 1.0F + more));
                const glm::vec3 near = random.in_cube();
                out.append("mirrors", ask<reflection_in_line>(out, near + far * axis, axis));
                const glm::vec3 inside = far * normalize(cross(axis, random.unit_vector()));
                out.append("mirrors", ask<reflection_in_plane>(out, near + inside, axis));
            }
        }
    }
}

/// Of three whole numbers two or all have the same size: 0, or not.
glm::vec3 vector_of_equals(Random& random)
{
    const auto number = [&] { return static_cast<float>(1 + random.below(30)); };
    const auto sign = [&] { return random.below(2) == 0 ? 1.0F : -1.0F; };
    const float small = random.below(3) == 0 ? 0 : number();
    const float large = small + (small > 0 && random.below(3) == 0 ? 0 : number());
    glm::vec3 v(small * sign(), small * sign(), small * sign());
    v[static_cast<int>(random.below(3))] = large * sign();
    return v;
}

/// A vector of whole numbers, the smallest of which is clear, so that multiples of it are exact.
glm::vec3 whole_vector(Random& random)
{
    glm::vec3 v;
    for (int i = 0; i < 3; ++i)
        v[i] =
            static_cast<float>(10 * i + 1 + static_cast<int>(random.below(5))) * (random.below(2) == 0 ? 1.0F : -1.0F);
    const auto turns = static_cast<int>(random.below(3));
    return {v[turns], v[(turns + 1) % 3], v[(turns + 2) % 3]};
}

// Opposite vectors of any lengths in pairs with equal ones, in random order; and vectors that are nearly either, down
// to 1e-6.
void record_opposite(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 from =
            random_unit(random, -40, 40) * (i % 2 == 0 ? vector_of_equals(random) : whole_vector(random)) + 0.0F;
        const auto factor = static_cast<float>(1 + random.below(7));
        const bool first = random.below(2) == 1;
        for (const bool opposite : {first, !first})
            out.append("opposite", ask<alignment>(out, from, (opposite ? -factor : factor) * from + 0.0F));  // no -0
    }
    for (const float angle : {1e-1F, 1e-3F, 1e-4F, 1e-5F, 3e-6F, 1e-6F}) {
        for (int i = 0; i < 16; ++i) {
            const glm::vec3 from = clear_axis(false, random);
            const glm::vec3 aside = length(from) * normalize(cross(from, random.unit_vector()));
            const glm::vec3 to = from + angle * aside;
            out.append("nearly", ask<alignment>(out, from, i % 3 == 0 ? to : -to));
        }
    }
}

// Directions that are nearly up or down; what is left beside the y is too small for a float's square.
void record_steep(Random& random, Recorder& out)
{
    for (const float aside : {0.0F, 0.0F, 1e-2F, 1e-5F, 1e-10F, 1e-20F, 1e-25F, 1e-35F, 1e-42F}) {
        for (int i = 0; i < 10; ++i) {
            const float angle = random.uniform(-pi, pi);
            const float up = i % 2 == 0 ? 1.0F : -2.0F;
            out.append("placed", ask<placed_along>(
                                     out, random.in_cube(),
                                     {aside * std::cos(angle) + 0.0F, up, aside * std::sin(angle) + 0.0F}));  // no -0
        }
    }
}

void record_sizes(Random& random, Recorder& out)
{
    for (int i = 0; i < 48; ++i) {
        const float size = i % 2 == 0 ? power_of_ten(-42, -24, random) : power_of_ten(20, 37, random);
        const glm::vec3 direction = size * random.unit_vector();
        const glm::vec3 centre = random.in_cube();
        const glm::vec3 other = clear_axis(true, random);
        out.append("matrix", ask<reflection_in_line>(out, centre, direction));
        out.append("matrix", ask<reflection_in_plane>(out, centre, direction));
        out.append("matrix", ask<scaling_along>(out, centre, direction, random.uniform(-2, 0.5F)));
        out.append("matrix", ask<placed_along>(out, centre, direction));
        out.append("matrix", i % 4 < 2 ? ask<alignment>(out, other, direction) : ask<alignment>(out, direction, other));
        out.append("matrix", ask<rotation_about_point>(out, centre, {direction, random.uniform(0.5F, 3)}));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"null directions", [](Case& c, Recorder& out) { record_null(c.random, out); }},
    {"not finite", [](Case& c, Recorder& out) { record_not_finite(c.random, out); }},
    {"far centres", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"opposite", [](Case& c, Recorder& out) { record_opposite(c.random, out); }},
    {"steep", [](Case& c, Recorder& out) { record_steep(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("kaleidoscope", draw_kaleidoscope(c.vary, out)); }},
};

}
