#include <gtest/gtest.h>

#include "first_pattern.hpp"

// What is so of whole lists, and of numbers that are always the same.
namespace umbral::grader::test {
namespace {

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

TEST(ListPatterns, of_right_rows_say_how_often_and_where_they_come)
{
    const auto row_at = [](const Row& list, std::ptrdiff_t i) {
        return Row(list.begin() + 2 * i, list.begin() + 2 * i + 2);
    };
    EXPECT_EQ(said_of_lists([&](Row list) {
                  const Row again = row_at(list, 1);
                  list.insert(list.begin() + 6, again.begin(), again.end());
                  return list;
              }),
              "has a row once too often, and the others as they are to be");
    EXPECT_EQ(said_of_lists([](Row list) {
                  std::rotate(list.begin(), list.begin() + 4, list.end());
                  return list;
              }),
              "begins with another row, and goes round as it should");
    EXPECT_EQ(said_of_lists([](Row list) {
                  std::swap_ranges(list.begin(), list.begin() + 2, list.begin() + 4);
                  return list;
              }),
              "has the right rows in another order");
}

// Corners of polygons are counted: "polygon, corner, 0, x, y".
TEST(ListPatterns, do_not_take_the_number_of_a_row_for_what_it_says)
{
    AnswerTable made;
    made.components = 5;
    made.keys = 3;
    for (double i = 0; i < 6; ++i) {
        AnswerPair pair{{}, {}, true};
        for (double k = 0; k < 5; ++k) pair.expected.insert(pair.expected.end(), {i, k, 0, i + 1, k == 4 ? 0 : k * i});
        // Without the last corner, which is to be that of the first once more, if only i is 0.
        pair.expected[4 * 5 + 4] = pair.expected[4];
        pair.yours.assign(pair.expected.begin(), pair.expected.end() - 5);
        made.answers.push_back(pair);
    }
    EXPECT_EQ(first_pattern(made), "lacks the last row");
    for (AnswerPair& pair : made.answers) {
        // The second corner is left out, which the others of the list do not say by their numbers.
        pair.expected = {pair.expected[0], 0, 0, 1, 1, 0, 1, 0, 2, pair.expected[0], 0, 2, 0, 1, 1, 0, 3, 0, 5, 5};
        for (std::size_t k = 1; k < 4; ++k) pair.expected[5 * k] = pair.expected[0];
        pair.yours = {pair.expected[0], 0, 0, 1, 1, pair.expected[0], 1, 0, 2, pair.expected[0],
                      pair.expected[0], 2, 0, 5, 5};
    }
    EXPECT_EQ(first_pattern(made), "has only once what is to come several times");
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
