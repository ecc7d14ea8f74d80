#include <gtest/gtest.h>

#include "first_pattern.hpp"

// What is so of whole lists, and of numbers that are always the same.
namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

/// Lists of pairs of numbers, all wrong as `spoil` makes them.
template <class Spoil>
std::string said_of_lists(const Spoil& spoil)
{
    AnswerTable made;
    made.components = 2;
    for (double i = 0; i < 6; ++i) {
        Row right;
        for (double k = 0; k < 4 + i; ++k) right.insert(right.end(), {i * i + 3 * k + 1, k * k - 5 * i});
        made.answers.push_back({spoil(right), right, true});
    }
    return first_pattern(made);
}

TEST(ListPatterns, say_that_what_should_begin_anew_goes_on)
{
    EXPECT_EQ(said_of_lists([](Row row) {
                  for (std::size_t at = 2; at < row.size(); ++at) row[at] += row[at - 2];
                  return row;
              }),
              "has in each row the sum of the right ones up to there");
    EXPECT_EQ(said_of_lists([](Row row) {
                  for (std::size_t at = 2; at < row.size(); ++at) row[at] += row[at - 1];
                  return row;
              }),
              "");
}

TEST(ListPatterns, say_that_rows_come_one_place_too_late)
{
    EXPECT_EQ(said_of_lists([](Row row) {
                  for (std::size_t at = row.size() - 1; at >= 2; --at) row[at] = row[at - 2];
                  return row;
              }),
              "has each row one place too late");
}

TEST(ListPatterns, of_one_number_of_several_say_that_it_is_always_the_same)
{
    AnswerTable made;
    made.components = 2;
    made.columns = {"longitude", "latitude"};
    for (double i = 0; i < 6; ++i) made.answers.push_back({{360, 7 * i}, {0, 7 * i}, true});
    EXPECT_EQ(first_pattern(made), "differs in longitude only, which is 360");
}

TEST(ListPatterns, of_vectors_say_that_they_lie_along_the_right_ones)
{
    AnswerTable made;
    made.components = 3;
    for (double i = 1; i < 9; ++i) {
        const Row right{i, 9 - i * i, 2 + i};
        Row yours = right;
        for (double& number : yours) number *= static_cast<int>(i) % 2 == 0 ? i : -2 * i;
        made.answers.push_back({yours, right, true});
    }
    EXPECT_EQ(first_pattern(made), "lies along the right one, with another length, and not always to the same side");
}

}
}
