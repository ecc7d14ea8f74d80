#include <cmath>
#include <kit/numbers_changed.hpp>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "rosette.hpp"

namespace umbral {
namespace {

using namespace transforms;

struct Couple {
    glm::vec3 a;
    glm::vec3 b;
};

void record(const Couple& couple, Recorder& out)
{
    const auto& [a, b] = couple;
    out.append("dot", ask<dot_product>(out, a, b));
    out.append("cross", ask<cross_product>(out, a, b));
    out.append("length", ask<length_of>(out, a));
    out.append("unit", ask<normalised>(out, a));
    out.append("angle", ask<angle_between>(out, a, b));
    out.append("parallel", ask<parallel_part>(out, a, b));
    out.append("perpendicular", ask<perpendicular_part>(out, a, b));
}

// Vectors whose answers a student can work out by hand.
void record_known(Variation& vary, Recorder& out)
{
    const Couple couples[] = {{{1, 0, 0}, {0, 1, 0}},  {{0, 1, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}},
                              {{1, 2, 2}, {3, 0, 4}},  {{3, 4, 0}, {2, 0, 0}}, {{2, 3, 6}, {0, 0, -5}},
                              {{1, 1, 0}, {-1, 0, 0}}, {{1, 2, 3}, {2, 4, 6}}, {{1, -2, 2}, {-2, 4, -4}},
                              {{0, 0, 4}, {0, 0, -2}}, {{0, -4, 3}, {0, 6, 8}}};
    // Parallel and perpendicular ones are turned by quarters of a turn, which keeps them what they are.
    for (const auto& [a, b] : couples) {
        const ExactMap map = vary.exact_map(1);
        if (dot(a, b) == 0 || cross(a, b) == glm::vec3(0))
            record({map.place(a), map.place(b)}, out);
        else
            record({by_quarters(vary, a), by_quarters(vary, b)}, out);
    }
}

/// A power of ten.
float some_size(Random& random, float lowest, float highest)
{
    return std::pow(10.0F, random.uniform(lowest, highest));
}

/// From 0.5 to 8, one time in four nearly 1, as the length of a unit vector that has drifted, little or much.
float some_length(Random& random)
{
    if (random.below(4) != 0) return random.uniform(0.5F, 8);
    return 1 + some_size(random, -5.5F, -3) * (random.below(2) == 0 ? 1.0F : -1.0F);
}

/// On an axis, of another length than 1: not null, though two of its components are.
glm::vec3 on_an_axis(Random& random)
{
    glm::vec3 vector(0);
    vector[static_cast<int>(random.below(3))] = random.uniform(1.5F, 8) * (random.below(2) == 0 ? 1.0F : -1.0F);
    return vector;
}

// Chains of couples in which one number changes, so that any component is 0, or the only one that differs from before.
// Neither vector is null, and no component larger than random ones are: that is what the tolerances are for.
void record_changed(Random& random, Recorder& out, const Couple& couple)
{
    const auto is_near = [](const glm::vec3& v) { return length(v) > 0.25F && length(v) < 8; };
    const auto allowed = [&](const Couple& changed) { return is_near(changed.a) && is_near(changed.b); };
    for (const Couple& changed : numbers_changed(random, couple, 6, allowed)) record(changed, out);
    // Two arguments that are one vector; and a vector without two of its components beside any other.
    record({couple.a, couple.a}, out);
    record({on_an_axis(random), couple.b}, out);
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 a = some_length(random) * random.unit_vector();
        const glm::vec3 b = some_length(random) * random.unit_vector();
        record({a, b}, out);
        if (i % 10 == 0) record_changed(random, out, {a, b});
    }
}

/// Null, as 0 or as -0.
glm::vec3 null_vector(Random& random) { return random.below(2) == 0 ? glm::vec3(0) : glm::vec3(-0.0F); }

/// All its components have one sign, so that its products with a null vector are all 0 or all -0.
glm::vec3 of_one_sign(Random& random)
{
    const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
    return sign * (glm::vec3(1.5F) + random.in_cube());
}

// Pairs of one question about a null vector and one about others, most of them on an axis, in random order.
void record_null(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 a = i % 4 < 3 ? on_an_axis(random) : some_length(random) * random.unit_vector();
        const glm::vec3 b = i % 4 < 2 ? on_an_axis(random) : 2.0F * random.unit_vector();
        const glm::vec3 other = of_one_sign(random);
        const glm::vec3 zero = null_vector(random);
        const glm::vec3 zero_too = null_vector(random);
        const Couple null = i % 3 == 0   ? Couple{zero, other}
                            : i % 3 == 1 ? Couple{other, zero}
                                         : Couple{zero, zero_too};
        const bool swapped = random.below(2) == 1;
        for (const bool is_null : {swapped, !swapped}) {
            const Couple& couple = is_null ? null : Couple{a, other};
            out.append("unit", ask<normalised>(out, is_null ? zero : a));
            out.append("angle", ask<angle_between>(out, couple.a, couple.b));
            out.append("parallel", ask<parallel_part>(out, other, is_null ? zero : b));
            out.append("perpendicular", ask<perpendicular_part>(out, other, is_null ? zero : b));
        }
    }
}

/// Of the smallest floats: whole multiples of the very first, up to 2, each component by itself, and not all 0.
glm::vec3 smallest(Random& random)
{
    constexpr float first = std::numeric_limits<float>::denorm_min();
    glm::vec3 multiples;
    for (int i = 0; i < 3; ++i) multiples[i] = static_cast<float>(static_cast<int>(random.below(5)) - 2);
    if (multiples == glm::vec3(0)) multiples.z = 1;
    return first * multiples;
}

// Squares of these lengths are no floats, or have lost digits; those of the first quarter would not even be floats if
// they were not squared. Every fourth couple is exactly parallel, and every fourth of lengths that are far apart.
void record_sizes(Random& random, Recorder& out)
{
    for (int i = 0; i < 128; ++i) {
        const int kind = i / 4 % 4;
        const float size = kind == 1   ? some_size(random, -43, -36)
                           : kind == 2 ? some_size(random, -36, -19)
                                       : some_size(random, 19.5F, 38);
        const glm::vec3 a = kind == 0 ? smallest(random) : size * random.unit_vector();
        const glm::vec3 b = kind == 0 ? smallest(random) : size * random.uniform(0.1F, 1) * random.unit_vector();
        out.append("length", ask<length_of>(out, a));
        out.append("unit", ask<normalised>(out, a));
        const glm::vec3 unit = random.unit_vector();
        const float multiple = random.below(2) == 0 ? -2.0F : 2.0F;
        const glm::vec3 half = kind == 3 ? a / 4.0F : a;
        const glm::vec3 beside[] = {b, b, multiple * half, unit};
        out.append("angle", ask<angle_between>(out, a, beside[i % 4]));
        const glm::vec3 other = random.uniform(0.5F, 1) * random.unit_vector();
        out.append("parallel", ask<parallel_part>(out, other, b));
        out.append("perpendicular", ask<perpendicular_part>(out, other, b));
    }
}

// Products of components that no float can hold, of vectors whose dot and cross product are floats. `a` and `b` lie at
// right angles in the plane, but for the last component; `c` is nearly parallel to `a`.
void record_large_products(Random& random, Recorder& out)
{
    for (int i = 0; i < 30; ++i) {
        const auto part = [&random] { return random.uniform(3e19F, 6e19F) * (random.below(2) == 0 ? 1.0F : -1.0F); };
        const float x = part();
        const float y = part();
        const glm::vec3 a(x, y, 0.25F * x);
        const glm::vec3 b(-y, x, 0.25F * y);
        const glm::vec3 c = a * (glm::vec3(1) + 1e-2F * random.in_cube());
        out.append("dot", ask<dot_product>(out, a, b));
        out.append("cross", ask<cross_product>(out, a, c));
    }
}

// Of any sizes whose product is a float that has all its digits; a third of them nearly at right angles, where the
// terms of the dot product are a thousand times as long as their sum.
void record_products(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float product = random.uniform(-32, 36);
        const float first = product / 2 + random.uniform(-18, 18);
        const glm::vec3 direction = clear_axis(false, random);
        const glm::vec3 aside =
            i % 3 == 0 ? normalize(cross(direction, random.unit_vector())) + 1e-3F * direction : random.unit_vector();
        const glm::vec3 a = std::pow(10.0F, first) * direction;
        const glm::vec3 b = std::pow(10.0F, product - first) * aside;
        out.append("dot", ask<dot_product>(out, a, b));
        out.append("cross", ask<cross_product>(out, a, b));
    }
}

/// Two whole vectors whose angle is about 10^-`digits`: combinations p u + q v and r u + s v of two short ones with
/// p s - q r = 1, so that their cross product is that of the short ones.
Couple whole_couple(float digits, Random& random)
{
    const auto small = [&random] { return static_cast<float>(1 + random.below(3)); };
    const glm::vec3 u(small(), -small(), small());
    const glm::vec3 v(-small(), small(), small());
    Couple couple{u, v};
    const float most = 0.35F * std::pow(10.0F, digits / 2);  // so that all stay whole numbers of 24 bits
    while (length(couple.a) < most) {
        couple.a += small() * couple.b;
        couple.b += small() * couple.a;
    }
    return couple;
}

// Angles of 0.1 to 3e-7, or as far from π: what the long way round computes is the difference of nearly equal numbers.
// Then whole vectors, down to 1e-13. And angles near a right one, where the sine alone says nothing, and hardly
// anything of one lies along the other.
void record_nearly_parallel(Random& random, Recorder& out)
{
    for (const float angle : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F, 5e-7F, 3e-7F}) {
        for (int i = 0; i < 9; ++i) {
            // None of its components is so small that the other's rounding would turn it by less than the angle.
            const glm::vec3 a = random.uniform(1, 8) * clear_axis(false, random);
            const glm::vec3 aside = normalize(cross(a, random.unit_vector()));
            const float factor = random.uniform(0.5F, 2) * (i % 4 == 3 ? -1.0F : 1.0F);
            const glm::vec3 b = factor * (a + angle * length(a) * aside);
            out.append("cross", ask<cross_product>(out, a, b));
            out.append("angle", ask<angle_between>(out, a, b));
            out.append("perpendicular", ask<perpendicular_part>(out, a, b));
        }
    }
    for (int i = 0; i < 72; ++i) {
        const Couple couple = whole_couple(random.uniform(8, 13), random);
        out.append("cross", ask<cross_product>(out, couple.a, couple.b));
        out.append("angle", ask<angle_between>(out, couple.a, couple.b));
        out.append("perpendicular", ask<perpendicular_part>(out, couple.a, couple.b));
    }
    for (int i = 0; i < 48; ++i) {
        const glm::vec3 a = random.uniform(1, 8) * random.unit_vector();
        const glm::vec3 aside = normalize(cross(a, random.unit_vector()));
        const float lean = std::pow(10.0F, random.uniform(-7.5F, -1)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        out.append("angle", ask<angle_between>(out, a, aside + lean * a));
        out.append("parallel", ask<parallel_part>(out, a, aside + lean * a));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"null vectors", [](Case& c, Recorder& out) { record_null(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"large products", [](Case& c, Recorder& out) { record_large_products(c.random, out); }},
    {"products", [](Case& c, Recorder& out) { record_products(c.random, out); }},
    {"nearly parallel", [](Case& c, Recorder& out) { record_nearly_parallel(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("rosette", draw_rosette(c.vary, out)); }},
};

}
