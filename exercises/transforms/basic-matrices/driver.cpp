#include <cmath>
#include <kit/numbers_changed.hpp>
#include <limits>
#include <numbers>
#include <tuple>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <vector>

#include "../support.hpp"
#include "tower.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr float pi = std::numbers::pi_v<float>;

// Of either sign, from 10^low to 10^high.
float of_any_size(Random& random, float low, float high)
{
    const float size = std::pow(10.0F, random.uniform(low, high));
    return random.below(2) == 0 ? size : -size;
}

// A matrix that is not the student's, so that a wrong matrix does not hide a wrong product.
glm::mat4 given_matrix(Random& random)
{
    glm::mat4 matrix(1);
    for (int column = 0; column < 3; ++column) matrix[column] = glm::vec4(2.0F * random.in_cube(), 0);
    matrix[3] = glm::vec4(5.0F * random.in_cube(), 1);
    return matrix;
}

void record_rotations(float angle, Recorder& out)
{
    out.append("rotation", ask<rotation_about_x>(out, angle));
    out.append("rotation", ask<rotation_about_y>(out, angle));
    out.append("rotation", ask<rotation_about_z>(out, angle));
}

// The course's examples first: Tra[0,1.2,0], Tra[0.7,0.6,-0.5], Esc[1.5,…], the mirror Esc[1,1,-1], Rot_x[23°],
// Rot_y[60°], Rot_z[45°].
void record_known(Variation& vary, Recorder& out)
{
    for (const glm::vec3& offset : {glm::vec3(0, 1.2F, 0), {0.7F, 0.6F, -0.5F}, {1, 2, 3}, {0, 0, 0}})
        out.append("translation", ask<translation_matrix>(out, vary.near(offset, 0.5F)));
    for (const glm::vec3& factors : {glm::vec3(1.5F), {2.5F, 1, 1}, {1, 3, 1}, {1, 1, -1}, {2, 0, 0.5F}})
        out.append("scaling", ask<scaling_matrix>(out, vary.scaled(1.0F, 1.4F) * factors));
    for (int moved = 0; moved < 3; ++moved)
        for (const int by : {(moved + 1) % 3, (moved + 2) % 3})
            out.append("shear", ask<shear_matrix>(out, moved, by, vary.near(0.5F + static_cast<float>(moved), 0.3F)));
    for (const float angle : {pi / 2, 23 * pi / 180, pi / 3, pi / 4, -pi / 2, pi})
        record_rotations(vary.near(angle, 0.2F), out);

    glm::mat4 matrix(0.0F, 2.0F, 0.0F, 0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 5.0F, 6.0F, 7.0F, 1.0F);
    for (const glm::vec3& v : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 0}, {1, 2, 3}}) {
        out.append("point", ask<transform_point>(out, matrix, by_quarters(vary, v)));
        out.append("vector", ask<transform_vector>(out, matrix, by_quarters(vary, v)));
    }
    // Free vectors do not feel how far a matrix moves points.
    matrix[3] = {3e7F, -5e7F, 7e7F, 1};
    for (const glm::vec3& v : {glm::vec3(1, 2, 3), {0.5F, -1, 0.25F}})
        out.append("vector", ask<transform_vector>(out, matrix, by_quarters(vary, v)));
    matrix[3] = glm::vec4(by_quarters(vary, glm::vec3(5, 6, 7)), 1);
    glm::mat4 moved(1);
    moved[3] = {by_quarters(vary, 3), 0, 0, 1};
    glm::mat4 flat(1);
    flat[1] = glm::vec4(0);
    glm::mat4 doubled(2);
    doubled[3] = {0, 0, 0, 1};
    for (const auto& steps : {std::vector<glm::mat4>{moved, doubled},
                              {doubled, moved},
                              {moved, matrix},
                              {matrix, moved, doubled},
                              {matrix},
                              {moved, flat, matrix},
                              {matrix, matrix},
                              std::vector<glm::mat4>(20, moved)})
        out.append("composed", ask<compose_matrices>(out, steps));
}

// No step and one step, in pairs, in random order.
void record_no_steps(Random& random, Recorder& out)
{
    for (int i = 0; i < 10; ++i) {
        const std::vector<glm::mat4> steps{given_matrix(random)};
        const bool first = random.below(2) == 1;
        for (const bool none : {first, !first})
            out.append("composed", ask<compose_matrices>(out, std::span(steps).first(none ? 0 : 1)));
    }
}

// Chains of questions in which one number changes: coordinates, factors and angles that are 0, equal, or the only one
// that differs from the call before. None becomes larger than random ones are: that is what the tolerances are for.
void record_changed(Random& random, Recorder& out, int i)
{
    const auto is_near = [](const glm::vec3& v) { return std::abs(v.x) < 8 && std::abs(v.y) < 8 && std::abs(v.z) < 8; };
    const glm::vec3 numbers = 8.0F * random.in_cube();
    for (const glm::vec3& offset : numbers_changed(random, numbers, 3, is_near))
        out.append("translation", ask<translation_matrix>(out, offset));
    for (const glm::vec3& factors : numbers_changed(random, numbers, 3, is_near))
        out.append("scaling", ask<scaling_matrix>(out, factors));
    for (const auto& [moved, by, amount] : {std::tuple(i % 3, (i + 1) % 3, numbers.x),
                                            {i % 3, (i + 1) % 3, numbers.y},
                                            {i % 3, (i + 2) % 3, numbers.y},
                                            {(i + 1) % 3, (i + 2) % 3, numbers.y},
                                            {(i + 1) % 3, (i + 2) % 3, i % 2 == 0 ? 0 : 1.0F}})
        out.append("shear", ask<shear_matrix>(out, moved, by, amount));
    const glm::mat4 matrix = given_matrix(random);
    for (const glm::vec3& point : numbers_changed(random, numbers, 3, is_near)) {
        out.append("point", ask<transform_point>(out, matrix, point));
        out.append("vector", ask<transform_vector>(out, matrix, point));
    }
    glm::mat4 other = matrix;
    other[i % 3] = glm::vec4(0);
    other[3][i % 3] = 0;
    out.append("point", ask<transform_point>(out, matrix, numbers));
    out.append("point", ask<transform_point>(out, other, numbers));
    out.append("vector", ask<transform_vector>(out, matrix, numbers));
    out.append("vector", ask<transform_vector>(out, other, numbers));
    // The same step again, at once or later, and one step of a list that changes.
    const glm::mat4 last = given_matrix(random);
    for (const auto& steps : {std::vector{matrix, last, last}, {matrix, last, matrix}, {other, last, matrix}})
        out.append("composed", ask<compose_matrices>(out, steps));
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 numbers = 8.0F * random.in_cube();
        out.append("translation", ask<translation_matrix>(out, numbers));
        out.append("scaling", ask<scaling_matrix>(out, {numbers.y, numbers.z, numbers.x}));
        out.append("shear", ask<shear_matrix>(out, i % 3, (i + 1 + i / 3 % 2) % 3, numbers.z));
        record_rotations(random.uniform(-pi, pi), out);
        const glm::mat4 matrix = given_matrix(random);
        out.append("point", ask<transform_point>(out, matrix, numbers));
        glm::mat4 far = matrix;
        if (i % 3 == 0) far[3] = glm::vec4(1e7F * random.in_cube(), 1);
        out.append("vector", ask<transform_vector>(out, far, numbers));
        if (i % 4 == 0) record_changed(random, out, i / 4);
        if (i % 10 == 0) record_rotations(i % 20 == 0 ? 0 : random.uniform(-1, 1), out);
    }
    // Every third chain is flattened by one of its steps.
    for (std::size_t i = 0; i < 60; ++i) {
        std::vector<glm::mat4> steps;
        for (std::size_t k = 0; k < 2 + i % 5; ++k) steps.push_back(given_matrix(random));
        const std::uint32_t flattens = random.below(static_cast<std::uint32_t>(steps.size()));
        if (i % 3 == 0) steps[flattens][static_cast<int>(random.below(3))] = glm::vec4(0);
        out.append("composed", ask<compose_matrices>(out, steps));
    }
}

void record_many_turns(Random& random, Recorder& out)
{
    for (const float angle : {2 * pi, 7.0F, -100.0F, 1e3F, -1e4F, 1e6F})
        for (int i = 0; i < 5; ++i) record_rotations(angle * random.uniform(0.9F, 1), out);
}

// What is small beside 1 is no less a number than others. A matrix's entries are compared with the largest of their
// column, so that sines of small angles, in which 1 is the largest, are recorded one by one.
void record_small_turns(Random& random, Recorder& out)
{
    const float angle = of_any_size(random, -30, -2);
    const auto record = [&](const glm::mat4& matrix, int from, int to) {
        out.columns("small turns", "the sine's entries");
        for (const float entry : {matrix[from][to], matrix[to][from]}) out.append("small turns", entry);
    };
    record(ask<rotation_about_x>(out, angle), 1, 2);
    record(ask<rotation_about_y>(out, angle), 2, 0);
    record(ask<rotation_about_z>(out, angle), 0, 1);
}

glm::vec3 any_factors(Random& random)
{
    glm::vec3 factors;
    for (int i = 0; i < 3; ++i) factors[i] = of_any_size(random, -10, 10);
    return factors;
}

glm::mat4 given_factors(Random& random)
{
    const glm::vec3 factors = any_factors(random);
    glm::mat4 matrix(1);
    for (int i = 0; i < 3; ++i) matrix[i][i] = factors[i];
    return matrix;
}

// All terms of an image's sums have one sign, so that nothing is lost.
void record_images(Random& random, Recorder& out)
{
    const float size = of_any_size(random, -12, 12);
    const float length = of_any_size(random, -18, 18);
    const auto terms = [&](float of) {
        const float x = random.uniform(0.3F, 1);
        const float y = random.uniform(0.3F, 1);
        return of * glm::vec3(x, y, random.uniform(0.3F, 1));
    };
    glm::mat4 matrix(1);
    for (int column = 0; column < 3; ++column) matrix[column] = glm::vec4(terms(size), 0);
    matrix[3] = glm::vec4(terms(size * length), 1);
    const glm::vec3 v = terms(length);
    out.append("images", ask<transform_point>(out, matrix, v));
    out.append("images", ask<transform_vector>(out, matrix, v));
}

// Numbers of all sizes; those that are only copied may be the smallest and the largest that there are.
void record_sizes(Random& random, Recorder& out)
{
    const float ends[] = {0, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
    for (int i = 0; i < 24; ++i) {
        glm::vec3 numbers;
        for (int k = 0; k < 3; ++k) numbers[k] = of_any_size(random, -37, 37);
        if (i % 4 == 0) numbers[static_cast<int>(random.below(3))] = ends[random.below(3)];
        out.append("copied", ask<translation_matrix>(out, numbers));
        out.append("copied", ask<scaling_matrix>(out, {numbers.y, numbers.z, numbers.x}));
        out.append("copied", ask<shear_matrix>(out, i % 3, (i + 1 + i / 3 % 2) % 3, numbers.z));
        record_small_turns(random, out);
        record_images(random, out);
        std::vector<glm::mat4> steps;
        for (int k = 0; k < 2 + i % 2; ++k) steps.push_back(given_factors(random));
        out.append("composed", ask<compose_matrices>(out, steps));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { record_many_turns(c.random, out); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"no steps", [](Case& c, Recorder& out) { record_no_steps(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("tower", draw_tower(c.vary, out)); }},
};

}
