#include "question/matrix_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <umbral/core/random.hpp>

#include "question/first_pattern.hpp"

// What is said of columns and rows of wrong matrices.
namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

/// Twenty matrices of 3 x 3, of which two of three are wrong.
AnswerTable matrices(const std::function<Row(Row)>& wrong)
{
    constexpr std::size_t made_in_all = 20;
    AnswerTable made;
    made.components = 9;
    Random random(3);
    for (std::size_t i = 0; i < made_in_all; ++i) {
        Row right;
        for (int k = 0; k < 9; ++k) right.push_back(random.uniform(0.3F, 3));
        const bool is_wrong = i % 3 != 0;
        made.answers.push_back({is_wrong ? wrong(right) : right, right, is_wrong});
    }
    return made;
}

TEST(MatrixLines, find_rows_with_the_opposite_sign)
{
    EXPECT_EQ(first_pattern(matrices([](Row wrong) {
                  for (const std::size_t i : {1, 4, 7}) wrong[i] = -wrong[i];
                  return wrong;
              })),
              "is right but for some rows: row 1 is the right one with the opposite sign");
}

TEST(MatrixLines, tell_of_most_columns_what_cannot_be_told_of_all)
{
    EXPECT_EQ(first_pattern(matrices([](Row wrong) {
                  for (const std::size_t i : {0, 1, 2, 6, 7, 8}) wrong[i] = -wrong[i];
                  wrong[3] = std::sin(99 * wrong[3]) + 4;
                  wrong[4] = std::cos(99 * wrong[4]) + 4;
                  return wrong;
              })),
              "has several wrong columns: each of columns 0 and 2 is the right one with the opposite sign");
}

}
}
