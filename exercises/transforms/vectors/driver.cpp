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
                              {{0, -4, 3}, {0, 6, 8}}};
    // Parallel and perpendicular ones are turned by quarters of a turn, which keeps them what they are.
    for (const auto& [a, b] : couples) {
        const ExactMap map = vary.exact_map(1);
        if (dot(a, b) == 0 || cross(a, b) == glm::vec3(0))
            record({map.place(a), map.place(b)}, out);
        else
            record({by_quarters(vary, a), by_quarters(vary, b)}, out);
    }
}

/// From 0.5 to 8, one time in four nearly 1, as the length of a unit vector that has drifted.
float some_length(Random& random)
{
    return random.below(4) == 0 ? random.uniform(0.999F, 1.001F) : random.uniform(0.5F, 8);
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 a = some_length(random) * random.unit_vector();
        const glm::vec3 b = some_length(random) * random.unit_vector();
        record({a, b}, out);
    }
}

// Pairs of one question about a null vector and one about others, in random order.
void record_null(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 a = some_length(random) * random.unit_vector();
        const glm::vec3 b = 2.0F * random.unit_vector();
        const glm::vec3 c = random.unit_vector();
        const Couple null = i % 3 == 0   ? Couple{{0, 0, 0}, b}
                            : i % 3 == 1 ? Couple{a, {0, 0, 0}}
                                         : Couple{{0, 0, 0}, {0, 0, 0}};
        const bool swapped = random.below(2) == 1;
        for (const bool is_null : {swapped, !swapped}) {
            const Couple& couple = is_null ? null : Couple{a, c};
            out.append("unit", ask<normalised>(out, is_null ? glm::vec3(0) : a));
            out.append("angle", ask<angle_between>(out, couple.a, couple.b));
            out.append("parallel", ask<parallel_part>(out, a, is_null ? glm::vec3(0) : b));
            out.append("perpendicular", ask<perpendicular_part>(out, a, is_null ? glm::vec3(0) : b));
        }
    }
}

// Squares of these lengths are no floats, or have lost digits. Every fourth couple is exactly parallel, and every
// fourth of lengths that are far apart.
void record_sizes(Random& random, Recorder& out)
{
    for (const float size : {1e-43F, 1e-40F, 1e-37F, 1e-30F, 1e-23F, 1e-20F, 1e20F, 1e25F, 1e30F, 1e38F}) {
        for (int i = 0; i < 12; ++i) {
            const glm::vec3 a = size * random.unit_vector();
            const glm::vec3 b = size * random.uniform(0.1F, 1) * random.unit_vector();
            out.append("length", ask<length_of>(out, a));
            out.append("unit", ask<normalised>(out, a));
            const glm::vec3 unit = random.unit_vector();
            const glm::vec3 beside[] = {b, b, (i % 8 < 4 ? -0.5F : 0.5F) * a, unit};
            out.append("angle", ask<angle_between>(out, a, beside[i % 4]));
            const glm::vec3 other = random.uniform(0.5F, 1) * random.unit_vector();
            out.append("parallel", ask<parallel_part>(out, other, b));
            out.append("perpendicular", ask<perpendicular_part>(out, other, b));
        }
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

// Angles of 0.1 to 1e-7, or as far from π: what the long way round computes is the difference of nearly equal numbers.
void record_nearly_parallel(Random& random, Recorder& out)
{
    for (const float angle : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F, 3e-7F}) {
        for (int i = 0; i < 24; ++i) {
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
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"null vectors", [](Case& c, Recorder& out) { record_null(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"large products", [](Case& c, Recorder& out) { record_large_products(c.random, out); }},
    {"nearly parallel", [](Case& c, Recorder& out) { record_nearly_parallel(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("rosette", draw_rosette(c.vary, out)); }},
};

}
