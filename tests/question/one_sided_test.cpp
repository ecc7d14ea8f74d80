#include "question/one_sided.hpp"
#include "question/words_of_condition.hpp"

#include <gtest/gtest.h>

#include <umbral/core/random.hpp>

// Conditions without which nothing is wrong, and with which not everything is.
namespace umbral::grader {
namespace {

/// Questions with two numbers between -1 and 1 that have nothing to do with each other, and a count from 0 to 3.
QuestionTable questions(std::uint64_t seed, int count = 200)
{
    QuestionTable table{{"height", "width", "count"}, {}};
    Random random(seed);
    for (int i = 0; i < count; ++i)
        table.numbers.push_back(
            {random.uniform(-1.0F, 1.0F), random.uniform(-1.0F, 1.0F), static_cast<double>(random.below(4))});
    return table;
}

std::string words_of(const QuestionTable& table, const std::vector<bool>& wrong)
{
    const auto condition = one_sided_condition(facts_of(table), wrong);
    return condition ? sentence_of(*condition) : "nothing";
}

TEST(OneSidedConditions, tell_where_alone_answers_are_wrong)
{
    const QuestionTable table = questions(3);
    const auto wrong = wrong_where(table, [](const auto& row) { return row[0] < 0 && row[1] > -0.5 && row[2] > 0; });
    const std::string said = words_of(table, wrong);
    EXPECT_TRUE(said.starts_with("wrong only where height is negative (")) << said;
    EXPECT_NE(said.find("), right everywhere else ("), std::string::npos) << said;
}

TEST(OneSidedConditions, say_nothing_where_wrong_answers_lie_anywhere)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const QuestionTable table = questions(seed);
        Random random(1000 + seed);
        const auto wrong = wrong_where(table, [&](const auto&) { return random.below(8) == 0; });
        EXPECT_EQ(words_of(table, wrong), "nothing") << "seed " << seed;
    }
}

TEST(OneSidedConditions, say_nothing_where_one_parts_right_from_wrong)
{
    const QuestionTable table = questions(4);
    EXPECT_EQ(words_of(table, wrong_where(table, [](const auto& row) { return row[0] < 0; })), "nothing");
}

TEST(OneSidedConditions, say_nothing_of_what_holds_nearly_everywhere)
{
    const QuestionTable table = questions(5, 400);
    const auto wrong = wrong_where(table, [](const auto& row) { return row[2] > 0 && row[0] + row[1] > 0.2; });
    EXPECT_EQ(words_of(table, wrong).find("count"), std::string::npos);
}

TEST(OneSidedConditions, hold_on_other_questions_if_all_wrong_ones_lie_there)
{
    const auto is_wrong = [](const auto& row) { return row[0] < 0 && row[1] > 0; };
    const QuestionTable table = questions(7);
    const auto condition = one_sided_condition(facts_of(table), wrong_where(table, is_wrong));
    ASSERT_TRUE(condition);
    const QuestionTable others = questions(8);
    EXPECT_TRUE(parts(*condition, facts_of(others), wrong_where(others, is_wrong)));
    EXPECT_FALSE(parts(*condition, facts_of(others), wrong_where(others, [](const auto& row) { return row[2] == 1; })));
}

}
}
