#include "question/answer_patterns.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <umbral/core/random.hpp>

namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

/// Right answers of one to `components` numbers, and wrong ones made of them.
template <class Wrong>
AnswerTable table(std::size_t components, Wrong wrong, std::size_t rows = 1)
{
    AnswerTable made{components, {}, {}};
    if (components > 1) made.columns = {"x", "y", "z"};
    for (int i = 0; i < 12; ++i) {
        Row right;
        for (std::size_t at = 0; at < rows * components; ++at) right.push_back(i + 10 * static_cast<double>(at) + 1);
        const bool is_wrong = i % 2 == 0;
        made.answers.push_back({is_wrong ? wrong(right) : right, right, is_wrong});
    }
    return made;
}

std::string first(const AnswerTable& made)
{
    const std::vector<std::string> patterns = answer_patterns(made);
    return patterns.empty() ? "" : patterns.front();
}

TEST(AnswerPatterns, say_what_is_always_answered)
{
    EXPECT_EQ(first(table(1, [](Row) { return Row{0}; })), "is always 0");
    EXPECT_EQ(first(table(3, [](Row) { return Row{0, 0, 1}; })), "is always (0, 0, 1)");
    EXPECT_EQ(first(table(1, [](Row) { return Row{}; })), "is empty");
    EXPECT_EQ(first(table(1, [](Row) { return Row{std::numeric_limits<double>::quiet_NaN()}; })), "is not finite");
}

TEST(AnswerPatterns, say_what_was_done_to_the_right_answer)
{
    EXPECT_EQ(first(table(1, [](Row right) { return Row{right[0] + 1}; })), "is the right one plus 1");
    EXPECT_EQ(first(table(1, [](Row right) { return Row{2 * right[0]}; })), "is 2 times the right one");
    EXPECT_EQ(first(table(1, [](Row right) { return Row{-right[0]}; })), "is the right one with the opposite sign");
}

TEST(AnswerPatterns, say_which_number_of_a_row_differs)
{
    const auto spoilt = [](Row right) { return Row{right[0], right[1] * right[1], right[2]}; };
    EXPECT_EQ(first(table(3, spoilt)), "differs in y only");
    const auto moved = [](Row right) { return Row{right[0], right[1] - 3, right[2]}; };
    EXPECT_EQ(first(table(3, moved)), "differs in y only, which is the right one minus 3");
    EXPECT_EQ(first(table(3, [](Row right) { return Row{right[0] * right[0], right[1] * right[1], right[2]}; })), "");
}

TEST(AnswerPatterns, say_which_rows_of_a_list_are_missing_or_too_many)
{
    const auto cut = [](Row right) { return Row(right.begin(), right.end() - 1); };
    EXPECT_EQ(first(table(1, cut, 4)), "lacks the last row");
    EXPECT_EQ(first(table(
                  1, [](Row right) { return Row(right.begin() + 1, right.end()); }, 4)),
              "lacks the first row");
    const auto longer = [](Row right) {
        right.push_back(right.front());
        return right;
    };
    EXPECT_EQ(first(table(1, longer, 4)), "has a row too many at its end");
    EXPECT_EQ(first(table(
                  1, [](Row right) { return Row(right.rbegin(), right.rend()); }, 4)),
              "has its rows in the opposite order");
}

TEST(AnswerPatterns, say_nothing_of_few_wrong_answers)
{
    AnswerTable made = table(1, [](Row) { return Row{0}; });
    made.answers.resize(2 * (least_wrong - 1));
    EXPECT_EQ(first(made), "");
}

TEST(AnswerPatterns, say_nothing_of_random_answers)
{
    Random random(20260901);
    for (int round = 0; round < 200; ++round) {
        const auto noise = [&](const Row& right) {
            Row wrong;
            for (const double number : right) wrong.push_back(number * random.uniform(0.5F, 1.5F));
            return wrong;
        };
        EXPECT_EQ(first(table(3, noise, static_cast<std::size_t>(round) % 3 + 1)), "") << "round " << round;
    }
}

}
}
