#include "question/answer_sizes.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

TEST(AnswerSizes, right_ones_are_not_spoken_of)
{
    EXPECT_EQ(sentence_of_sizes({}), "");
    EXPECT_EQ(sentence_of_sizes({{3, 3}, {0, 0}}), "");
}

TEST(AnswerSizes, a_difference_that_is_always_the_same)
{
    EXPECT_EQ(sentence_of_sizes({{2, 3}, {4, 5}, {6, 7}, {1, 1}}), "has 1 element too few in 3 of 4 calls");
    EXPECT_EQ(sentence_of_sizes({{5, 3}, {7, 5}, {9, 7}}), "has 2 elements too many in 3 of 3 calls");
}

TEST(AnswerSizes, a_quotient_that_is_always_the_same)
{
    EXPECT_EQ(sentence_of_sizes({{3, 6}, {4, 8}, {6, 12}}), "has half as many elements as it should in 3 of 3 calls");
    EXPECT_EQ(sentence_of_sizes({{9, 3}, {12, 4}, {18, 6}}),
              "has 3 times as many elements as it should in 3 of 3 calls");
    EXPECT_EQ(sentence_of_sizes({{2, 6}, {4, 12}, {1, 3}}), "has 1/3 as many elements as it should in 3 of 3 calls");
}

TEST(AnswerSizes, empty_ones) { EXPECT_EQ(sentence_of_sizes({{0, 6}, {4, 4}, {0, 3}}), "is empty in 2 of 3 calls"); }

TEST(AnswerSizes, of_few_or_different_ones_the_numbers)
{
    EXPECT_EQ(sentence_of_sizes({{2, 3}, {4, 4}}), "has 2 elements where 3 are right in 1 of 2 calls");
    EXPECT_EQ(sentence_of_sizes({{2, 1}}), "has 2 elements where 1 is right in 1 of 1 call");
    EXPECT_EQ(sentence_of_sizes({{1, 0}, {1, 0}, {1, 0}}), "has 1 element where none are right in 3 of 3 calls");
    EXPECT_EQ(sentence_of_sizes({{2, 3}, {3, 5}, {9, 10}}),
              "has too few elements (first 2 elements where 3 are right) in 3 of 3 calls");
    EXPECT_EQ(sentence_of_sizes({{4, 3}, {3, 5}, {9, 10}}),
              "has a wrong number of elements (first 4 elements where 3 are right) in 3 of 3 calls");
}

}
}
