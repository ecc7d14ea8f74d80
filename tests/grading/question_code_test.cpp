#include "explain/question_code.hpp"

#include <gtest/gtest.h>

// The questions that led to one value, as one piece of code.
namespace umbral::grader::test {
namespace {

TEST(QuestionCode, of_several_calls_stands_below_each_other)
{
    EXPECT_EQ(together({4, 2}, {{4, "f(1)"}, {5, "f(2)"}}), "// 2 calls in this order led to it\nf(1)\nf(2)");
    EXPECT_EQ(together({4, 2}, {{4, "f(1)"}, {5, "f(1)"}}), "// 2 calls in this order led to it\nf(1)\nf(1)");
    EXPECT_EQ(together({4, 1}, {{4, "f(1)"}}), "f(1)");
    EXPECT_EQ(together({4, 2}, {{4, "f(1)"}}), "") << "one is missing";
}

TEST(QuestionCode, says_once_how_an_object_was_made)
{
    EXPECT_EQ(together({0, 3}, {{0, "make(7)"}, {1, "g(2)"}, {2, "const auto drawing = make(7);\ndrawing->draw()"}}),
              "// 3 calls in this order led to it\ng(2)\nconst auto drawing = make(7);\ndrawing->draw()");
}

TEST(QuestionCode, of_many_calls_shows_the_first_and_the_last)
{
    std::map<std::uint32_t, std::string> code;
    for (std::uint32_t i = 0; i < 9; ++i) code[i] = "f(" + std::to_string(i) + ")";
    EXPECT_EQ(together({0, 9}, code),
              "// 9 calls in this order led to it\nf(0)\nf(1)\nf(2)\n// … 3 calls left out\nf(6)\nf(7)\nf(8)");
}

}
}
