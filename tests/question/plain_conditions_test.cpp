#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "question/conditions.hpp"
#include "question/words_of_condition.hpp"

// Conditions without a bound: one of several whole numbers, ties between coordinates.
namespace umbral::grader {
namespace {

TEST(PlainConditions, name_the_one_number_with_which_answers_are_wrong)
{
    QuestionTable table{{"face", "corner"}, {}};
    for (int i = 0; i < 48; ++i) table.numbers.push_back({static_cast<double>(i % 6), std::floor(i / 6.0)});
    const auto third = [](const std::vector<double>& row) { return row[0] == 3; };
    EXPECT_EQ(words(table, wrong_where(table, third)), "face is 3");
}

TEST(PlainConditions, name_no_number_of_the_same_question_asked_again)
{
    QuestionTable table{{"count", "size"}, {}};
    for (int i = 0; i < 48; ++i) table.numbers.push_back({3.0 + i / 6, 0.37 * i});
    const auto third = [](const std::vector<double>& row) { return row[0] == 5; };
    EXPECT_EQ(words(table, wrong_where(table, third)).find("count is 5"), std::string::npos);
}

TEST(PlainConditions, name_no_number_of_a_few)
{
    QuestionTable table{{"face", "size"}, {}};
    for (int i = 0; i < 48; ++i) table.numbers.push_back({5.0 + i % 3, 0.37 * i});
    const auto middle = [](const std::vector<double>& row) { return row[0] == 6; };
    EXPECT_EQ(words(table, wrong_where(table, middle)).find("face is 6"), std::string::npos);
}

// Which row it is may be said; that the right answer is some number is no reason.
TEST(PlainConditions, know_labels_from_answers)
{
    QuestionTable table{{"face", "corners"}, {}};
    table.answers = 0;
    for (int i = 0; i < 48; ++i) table.numbers.push_back({static_cast<double>(i % 6), 0.37 * i});
    const auto third = [](const std::vector<double>& row) { return row[0] == 3; };
    EXPECT_EQ(words(table, wrong_where(table, third)), "nothing");
    table.labels = {0};
    EXPECT_EQ(words(table, wrong_where(table, third)), "face is 3");
}

TEST(PlainConditions, find_ties_between_the_largest_coordinates)
{
    QuestionTable table{{"direction.x", "direction.y", "direction.z"}, {}};
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        std::vector<double> row{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (i % 3 == 0) {
            row[static_cast<std::size_t>(i / 3 % 3)] = i % 2 == 0 ? 2 : -2;
            row[static_cast<std::size_t>((i / 3 + 1) % 3)] = i % 4 == 0 ? 2 : -2;
        }
        table.numbers.push_back(row);
    }
    // A tie of the smaller ones is none.
    table.numbers.push_back({0.5, -0.5, 1});
    const auto tied = [](const std::vector<double>& row) {
        return std::abs(row[0]) == 2 || std::abs(row[1]) == 2 || std::abs(row[2]) == 2;
    };
    const std::vector<bool> wrong = wrong_where(table, tied);
    bool is_said = false;
    for (const Fact& fact : facts_of(table)) is_said = is_said || fact.kind == Fact::Kind::tie;
    EXPECT_TRUE(is_said);
    EXPECT_EQ(words(table, wrong), "the largest coordinates of direction are as large as each other");
}

}
}
