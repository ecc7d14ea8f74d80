#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "pebbles.hpp"

namespace umbral {
namespace {

using namespace transforms;

// The length of a normal matrix is free: what is recorded is its multiple whose largest entry is 1 or -1.
void record_matrix(const glm::mat4& model, Recorder& out)
{
    const glm::mat3 u = ask<normal_matrix>(out, model);
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(double{u[column][row]}));
    out.append("matrix", largest > 0 && std::isfinite(largest) ? glm::mat3(glm::dmat3(u) / largest) : u);
}

void record(const glm::mat4& model, const glm::vec3& normal, Recorder& out)
{
    record_matrix(model, out);
    out.append("normal", ask<transformed_normal>(out, model, normal));
}

glm::mat4 turned(Random& random)
{
    const AxisAngle turn = random_turn(random);
    return glm::rotate(glm::mat4(1), turn.angle, turn.axis);
}

/// A turn, a scaling by factors whose sizes are from 0.3 to 3, another turn, and a translation.
glm::mat4 random_model(bool mirror, Random& random)
{
    glm::vec3 factors;
    for (int i = 0; i < 3; ++i) factors[i] = random.uniform(0.3F, 3);
    if (mirror) factors[static_cast<int>(random.below(3))] *= -1.0F;
    const glm::mat4 second = glm::translate(glm::mat4(1), 10.0F * random.in_cube()) * turned(random);
    return glm::scale(second, factors) * turned(random);
}

void record_known(Variation& vary, Recorder& out)
{
    glm::mat4 sheared(1);
    sheared[1][0] = 0.5F;
    // Slanted, though its columns are as long as those of a turn.
    const glm::mat4 slanted({1, 0, 0, 0}, {0.6F, 0.8F, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    const glm::mat4 stretched = glm::scale(glm::mat4(1), {2, 1, 1});
    const glm::mat4 moved = glm::translate(glm::mat4(1), {3, -4, 5});
    // Without an entry in the diagonal, or without a positive one.
    const glm::mat4 axes_changed({0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {0, 0, 0, 1});
    const glm::mat4 half_turn = glm::scale(glm::mat4(1), {-1, 1, -1});
    const glm::mat4 inside_out = glm::scale(glm::mat4(1), {-2, -1, -3});
    for (const glm::mat4& model :
         {stretched, sheared, moved, glm::mat4(1), moved * stretched, glm::scale(glm::mat4(1), {1, 2, 4}),
          sheared * stretched, axes_changed, half_turn, inside_out, axes_changed * inside_out, slanted})
        for (const glm::vec3& normal : {glm::vec3(1, 1, 0), {0, 1, 0}, {1, 0, 0}, {0, 3, 4}})
            record(glm::mat4(vary.exact_map(1).matrix()) * model, normalize(by_quarters(vary, normal)), out);
}

// Pairs of a mirror and what is none, in random order; in every third both have the same columns but one, which the
// mirror turns round.
void record_mirrors(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const bool first = random.below(2) == 1;
        const glm::mat4 given = random_model(false, random);
        glm::mat4 turned_round = given;
        turned_round[i / 3 % 3] *= -1.0F;
        for (const bool mirror : {first, !first}) {
            glm::mat4 model = random_model(mirror, random);
            if (i % 3 == 0) model = mirror ? turned_round : given;
            const glm::vec3 normal = random.unit_vector();
            record(model, normal, out);
        }
    }
}

// Pairs of a matrix without an inverse and one that has one, in random order: factors of 0, shadows, rows that repeat
// each other, null normals.
void record_flattened(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        glm::vec3 sizes(2, 3, 0.5F);
        sizes[i % 3] = 0;
        glm::mat4 flat = glm::scale(glm::mat4(1), sizes);
        if (i % 5 == 1) flat = shadow_matrix({random.uniform(-1, 1), 1, random.uniform(-1, 1)}, 0.01F);
        if (i % 5 == 2 && i % 3 != 0) flat[2] = flat[1] = glm::vec4(random.unit_vector(), 0);
        if (i % 5 == 3) flat = glm::scale(glm::mat4(1), {0, 0, 2});
        const glm::mat4 solid = random_model(false, random);
        const glm::vec3 normal = random.unit_vector();
        const bool first = random.below(2) == 1;
        for (const bool flattened : {first, !first})
            record(flattened ? flat : solid, flattened && i % 10 == 9 ? glm::vec3(0) : normal, out);
    }
}

// The determinant of these is no float, though each entry is. Normals may have any length. Every tenth turns all round
// in a point, and has no positive entry.
void record_sizes(Random& random, Recorder& out)
{
    for (const float size : {1e-42F, 1e-36F, 1e-25F, 1e-20F, 1e-14F, 1e13F, 1e20F, 1e30F, 1e36F}) {
        for (int i = 0; i < 20; ++i) {
            glm::mat4 model = random_model(i % 4 == 0, random);
            const glm::vec3 factors{random.uniform(0.3F, 3), random.uniform(0.3F, 3), random.uniform(0.3F, 3)};
            if (i % 10 == 9) model = glm::scale(glm::mat4(1), -factors);
            const float length = i % 2 == 0 ? 1 : std::pow(10.0F, random.uniform(-42, 38));
            const glm::vec3 normal = length * random.unit_vector();
            record(model * glm::scale(glm::mat4(1), glm::vec3(size)), normal, out);
        }
    }
}

float power_of_ten(float low, float high, Random& random) { return std::pow(10.0F, random.uniform(low, high)); }

float sign(Random& random) { return random.below(2) == 0 ? 1.0F : -1.0F; }

/// The same matrix after and before a turn that changes axes, which rounds nothing.
glm::mat4 axes_changed(const glm::mat3& model, Random& random)
{
    glm::mat4 result(1);
    const auto first = static_cast<int>(random.below(3));
    const auto other = static_cast<int>(random.below(3));
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result[column][row] = model[(column + first) % 3][(row + other) % 3];
    return result;
}

/// Three columns so nearly in a plane that their volume is 1e-12.7 … 1e-12.1 of the product of their lengths; a mirror
/// or not. Their zeros make it a product of three numbers, which nothing cancels.
glm::mat4 thin(Random& random)
{
    const float low = power_of_ten(-8, -5, random);
    glm::mat3 columns(1);
    columns[1] = {random.uniform(0.5F, 1), low, 0};
    columns[2] = {random.uniform(-1, 1), random.uniform(0.5F, 1), 0};
    const float lengths = glm::length(columns[1]) * glm::length(columns[2]);
    columns[2].z = sign(random) * power_of_ten(-12.7F, -12.1F, random) * lengths / low;
    return axes_changed(columns, random);
}

/// Needles and plates: one or two axes pressed to 1e-13 … 1e-18 of the others, or turned round too.
glm::mat4 pressed(bool needle, Random& random)
{
    glm::mat3 factors(sign(random));
    factors[1].y = sign(random) * power_of_ten(-18, -13, random);
    if (needle) factors[2].z = sign(random) * power_of_ten(-18, -13, random);
    return axes_changed(factors, random);
}

// Volumes that are next to nothing beside the product of the columns' lengths, and normals of which next to nothing is
// left. No number is so small that it counts as 0.
void record_nearly_nothing(Random& random, Recorder& out)
{
    for (int i = 0; i < 32; ++i) {
        const glm::mat4 model = i % 2 == 0 ? thin(random) : pressed(i % 4 == 1, random);
        glm::vec3 normal = random.unit_vector();
        if (i % 2 == 1 && i % 8 != 1) {
            normal = glm::vec3(0);
            normal[i / 2 % 3] = sign(random);
        }
        out.append("normal", ask<transformed_normal>(out, model, normal));
    }
}

// Turned, pressed to 1e-4 … 1e-8 of the thickness, turned again: what rounding leaves decides on which side the outside
// is. Half of them are not turned first, so that one column is short. Half of all are narrow too, as needles are.
// Half of them are mirrors. Of the turned ones every fourth has a normal that the pressing nearly takes away: a side.
void record_nearly_flat(Random& random, Recorder& out)
{
    for (const float thickness : {1e-4F, 1e-6F, 1e-7F, 1e-8F}) {
        for (int i = 0; i < 20; ++i) {
            const glm::mat4 after = turned(random);
            const glm::mat4 before = turned(random);
            const float width = i % 4 == 3 ? std::sqrt(thickness) : i % 4 == 2 ? 1e-3F : 1;
            const float pressed = random.below(2) == 0 ? thickness : -thickness;
            const glm::mat4 model = glm::scale(after, {1, width, pressed}) * (i % 2 == 1 ? glm::mat4(1) : before);
            const glm::vec3 normal = random.unit_vector();
            const float aside = thickness * random.uniform(-2, 2);
            const glm::vec3 side = glm::transpose(glm::mat3(before)) * glm::vec3(0.6F, 0.8F, aside);
            record(model, i % 8 == 0 ? side : normal, out);
        }
    }
    record_nearly_nothing(random, out);
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 200; ++i) {
             glm::mat4 model = random_model(false, c.random);
             if (i % 4 == 1)  // columns of one length
                 for (int k = 0; k < 3; ++k) model[k] = 1.5F * glm::normalize(model[k]);
             const glm::vec3 normal = c.random.unit_vector();
             record(model, normal, out);
         }
     }},
    {"mirrors", [](Case& c, Recorder& out) { record_mirrors(c.random, out); }},
    {"flattened", [](Case& c, Recorder& out) { record_flattened(c.random, out); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"nearly flat", [](Case& c, Recorder& out) { record_nearly_flat(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("pebbles", draw_pebbles(c.vary, out)); }},
};

}
