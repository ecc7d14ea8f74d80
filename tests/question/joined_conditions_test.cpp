#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "question/words_of_condition.hpp"

namespace umbral::grader {
namespace {

TEST(Conditions, join_the_same_of_several_numbers_by_or)
{
    QuestionTable table{{"viewport.width", "viewport.height", "other.x", "other.y"}, {}};
    Random random(7);
    for (int i = 0; i < 200; ++i)
        table.numbers.push_back({static_cast<double>(1 + random.below(500)), static_cast<double>(1 + random.below(500)),
                                 random.uniform(-1, 1), random.uniform(-1, 1)});
    const auto is_odd = [](double x) { return std::fmod(x, 2) == 1; };
    EXPECT_EQ(words(table, wrong_where(table, [&](const auto& row) { return is_odd(row[0]) || is_odd(row[1]); })),
              "viewport.width is odd or viewport.height is odd");
    // Not where one of them explains all.
    EXPECT_EQ(words(table, wrong_where(table, [&](const auto& row) { return is_odd(row[0]); })),
              "viewport.width is odd");
}

TEST(Conditions, tell_a_determinant_that_is_taken_for_nothing)
{
    QuestionTable table{{"frame.x.x", "frame.x.y", "frame.x.z", "frame.y.x", "frame.y.y", "frame.y.z", "frame.z.x",
                         "frame.z.y", "frame.z.z"},
                        {}};
    Random random(9);
    for (int i = 0; i < 200; ++i) {
        const float size = std::exp2(random.uniform(-12, 3));
        const glm::vec3 x = size * random.unit_vector();
        const glm::vec3 y = size * random.unit_vector();
        const glm::vec3 z = size * random.unit_vector();
        table.numbers.push_back({x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z});
    }
    const auto wrong = wrong_where(table, [](const auto& m) {
        return std::abs(m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                        m[2] * (m[3] * m[7] - m[4] * m[6])) < 1e-6;
    });
    EXPECT_EQ(words(table, wrong).substr(0, 77),
              "the size of the determinant of frame.x, frame.y and frame.z is less than 1e-0");
}

// Sizes whose quotient is taken of integers.
TEST(Conditions, find_numbers_that_are_no_multiples)
{
    QuestionTable table{{"framebuffer.x", "window.x", "cursor"}, {}};
    for (int i = 0; i < 60; ++i) {
        const int window = 20 + 7 * (i % 5);
        const int framebuffer = window * (1 + i % 3) + (i % 4 < 2 ? 0 : 5 + i % 11);
        table.numbers.push_back({double(framebuffer), double(window), double(i * i % 17)});
    }
    const auto is_no_multiple = [](const auto& row) { return std::fmod(row[0], row[1]) != 0; };
    EXPECT_EQ(words(table, wrong_where(table, is_no_multiple)), "framebuffer.x is no multiple of window.x");
}

}
}
