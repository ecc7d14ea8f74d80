#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "question/answer_patterns.hpp"
#include "question/first_pattern.hpp"
#include "question/possible_conditions.hpp"

// What is plain to see, or is nothing that the student's code did, is not said.
namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

/// Wrong answers with these numbers, of rows of so many numbers.
AnswerTable wrong_ones(std::size_t components, const std::vector<Row>& yours, const std::vector<Row>& expected)
{
    AnswerTable made;
    made.components = components;
    for (std::size_t i = 0; i < yours.size(); ++i) made.answers.push_back({yours[i], expected[i], true});
    return made;
}

const std::vector<Row> nothing(5);

// Rows of a kind and a number.
TEST(SillySentences, that_events_are_missing_is_said_with_the_one_that_is)
{
    const std::vector<Row> zooms{{3, 1}, {3, 2}, {3, 5}, {3, 1, 3, 4}, {3, 9}};
    AnswerTable made = wrong_ones(2, nothing, zooms);
    EXPECT_EQ(first_pattern(made), "is empty") << "rows whose kinds have no names";
    made.kinds = {{3, {"zoom"}}, {4, {"orbit"}}};
    EXPECT_EQ(first_pattern(made), "lacks \"zoom\"");
    made.answers[2].expected = {4, 5};
    EXPECT_EQ(first_pattern(made), "");
    made = wrong_ones(2, zooms, nothing);
    EXPECT_EQ(first_pattern(made), "should be empty");
    made.kinds = {{3, {"zoom"}}, {4, {"orbit"}}};
    EXPECT_EQ(first_pattern(made), "has \"zoom\" too often");
    made.kinds = {{3, {"zoom"}}};
    EXPECT_EQ(first_pattern(made), "") << "what else could it be?";
}

// Rows of a mesh, called as the mesh is.
TEST(SillySentences, what_all_rows_of_a_question_are_called_is_not_what_is_missing)
{
    AnswerTable made = wrong_ones(2, {{4, 1}, {4, 2}, {4, 3}, {4, 4}, {4, 5}},
                                  {{4, 1, 4, 7}, {4, 2, 4, 7}, {4, 3, 4, 8}, {4, 4, 4, 6}, {4, 5, 4, 9}});
    made.kinds = {{3, {"cube"}}, {4, {"torus of 8400 triangles"}}};
    made.answers.push_back({{3, 1, 3, 2}, {3, 1, 3, 2}, false});
    for (const AnswerPattern& one : answer_patterns(made)) EXPECT_EQ(one.words.find("torus"), std::string::npos);
}

// Codes, counts and states beside measured numbers.
TEST(SillySentences, of_whole_numbers_that_differ_none_is_nearly_right)
{
    std::vector<Row> yours;
    std::vector<Row> expected;
    for (double i = 0; i < 6; ++i) {
        yours.push_back({0.1 * i, 6912 + std::fmod(i, 2)});
        expected.push_back({0.1 * i, 6914 - std::fmod(i, 2)});
    }
    AnswerTable made = wrong_ones(2, yours, expected);
    made.columns = {"GL_LINE_WIDTH", "GL_POLYGON_MODE back"};
    EXPECT_EQ(first_pattern(made).find("nearly"), std::string::npos) << first_pattern(made);
}

TEST(SillySentences, counts_have_no_direction)
{
    std::vector<Row> yours;
    std::vector<Row> expected;
    for (double i = 1; i < 7; ++i) {
        expected.push_back({i, 3 * i});
        yours.push_back({i * i, 3 * i * i});
    }
    AnswerTable made = wrong_ones(2, yours, expected);
    EXPECT_EQ(first_pattern(made), "has the right direction, but not the right length");
    made.columns = {"buffers alive", "programs alive"};
    for (const AnswerPattern& one : answer_patterns(made)) EXPECT_EQ(one.words.find("direction"), std::string::npos);
}

// Depths that differ in the seventh digit look like a list turned round, and like anything else.
TEST(SillySentences, rows_that_are_nearly_equal_have_no_order)
{
    std::vector<Row> yours;
    std::vector<Row> expected;
    for (double i = 0; i < 6; ++i) {
        expected.push_back({0.0354331, 0.0354332, 0.0354331, 0.0354330});
        yours.push_back({0.0354331, 0.0354330, 0.0354331, 0.0354330});
    }
    for (const AnswerPattern& one : answer_patterns(wrong_ones(1, yours, expected)))
        EXPECT_EQ(one.words.find("row"), std::string::npos) << one.words;
}

// What a driver writes down where nothing was answered is not what the student's code said.
TEST(SillySentences, a_refusal_is_no_number)
{
    AnswerTable made = wrong_ones(2, nothing, {{3, 1}, {3, 2}, {3, 5}, {3, 1}, {3, 9}});
    for (AnswerPair& one : made.answers) one.refused = true;
    EXPECT_EQ(first_pattern(made), "is a refusal of what was asked");
    made.answers[1].refused = false;
    EXPECT_EQ(first_pattern(made), "is empty");
}

TEST(SillySentences, events_that_are_missing_among_others_are_named)
{
    std::vector<Row> yours;
    std::vector<Row> expected;
    for (double i = 0; i < 5; ++i) {
        yours.push_back({4, i, 4, i + 1});
        expected.push_back({4, i, 3, 7 * i, 4, i + 1});
    }
    AnswerTable made = wrong_ones(2, yours, expected);
    made.kinds = {{3, {"zoom"}}, {4, {"orbit"}}};
    EXPECT_EQ(first_pattern(made), "lacks \"zoom\"");
    made.answers[1].yours = {4, 1, 5, 2};
    EXPECT_EQ(first_pattern(made), "") << "another one is missing there as well";
    made.answers[1].yours = {NAN, 1, 4, 2};
    EXPECT_EQ(first_pattern(made), "");
}

TEST(SillySentences, the_background_of_a_picture_is_no_answer_that_is_always_given)
{
    std::vector<Row> expected;
    for (double i = 0; i < 6; ++i) expected.push_back({20 + i * i, 30 + 5 * i, i, 255});
    AnswerTable made = wrong_ones(4, std::vector<Row>(6, Row{10, 12, 21, 255}), expected);
    made.columns = {"r", "g", "b", "a"};
    EXPECT_EQ(first_pattern(made), "is (10, 12, 21, 255)");
    made.picture = true;
    EXPECT_EQ(first_pattern(made), "");
}

TEST(SillySentences, that_two_channels_of_a_picture_differ_is_seen)
{
    std::vector<Row> yours;
    std::vector<Row> expected;
    for (double i = 0; i < 6; ++i) {
        expected.push_back({50, 30 + 5 * i, 9 + i, 255});
        yours.push_back({50, 31 + i * i, 7 * i * i, 255});
    }
    AnswerTable made = wrong_ones(4, yours, expected);
    made.columns = {"r", "g", "b", "a"};
    EXPECT_EQ(first_pattern(made), "differs in nothing but g, b");
    made.picture = true;
    EXPECT_EQ(first_pattern(made), "");
}

TEST(SillySentences, what_a_driver_fills_in_is_not_laid_to_the_student)
{
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    AnswerTable made = wrong_ones(2, std::vector<Row>(5, Row{no_number, no_number}), std::vector<Row>(5, Row{1, 2}));
    EXPECT_EQ(first_pattern(made), "is not finite");
    made.several = true;
    EXPECT_EQ(first_pattern(made), "is no number (NaN), or was not given at all");
    for (AnswerPair& one : made.answers) one.yours[1] = 3;
    EXPECT_EQ(first_pattern(made), "is not finite");
}

TEST(SillySentences, entries_that_a_matrix_shows_are_not_listed)
{
    const auto with = [](const std::vector<std::size_t>& wrong) {
        AnswerTable made;
        made.components = 16;
        for (std::size_t i = 0; i < 16; ++i)
            made.columns.push_back("entry (row " + std::to_string(i % 4) + ", column " + std::to_string(i / 4) + ")");
        for (int k = 0; k < 6; ++k) {
            AnswerPair one{{}, {}, true};
            for (std::size_t i = 0; i < 16; ++i) one.expected.push_back(std::sin(16 * k + static_cast<double>(i)));
            one.yours = one.expected;
            for (const std::size_t i : wrong) one.yours[i] = std::cos(99.0 * k + 7 * static_cast<double>(i));
            made.answers.push_back(one);
        }
        return first_pattern(made);
    };
    EXPECT_EQ(with({0, 1, 4, 5}), "");
    EXPECT_EQ(with({1, 4}), "");
    EXPECT_EQ(with({6}), "differs in entry (row 2, column 1) only");
    EXPECT_EQ(with({12, 13, 14}), "differs in column 3 only");
    EXPECT_EQ(with({3, 7, 11}), "differs in row 3 only");
}

/// What may be said of these questions, of which the first half is answered wrong.
bool may_be_said(const QuestionTable& table, const std::string& words)
{
    std::vector<bool> wrong(table.numbers.size(), false);
    std::fill_n(wrong.begin(), wrong.size() / 2, true);
    const std::vector<PossibleCondition> all = possible_conditions(facts_of(table), wrong);
    return std::ranges::any_of(all, [&](const PossibleCondition& one) { return one.words == words; });
}

// A light's colour is no place, and whether a length is a whole number is chance.
TEST(SillySentences, colours_are_not_set_beside_places)
{
    QuestionTable table{{"light.color.x", "light.color.y", "light.color.z", "point.x", "point.y", "point.z"}, {}};
    for (int i = 0; i < 8; ++i) table.numbers.push_back({1, 1, 1, 0.1 * i, 0.2 * i, i < 4 ? 0.3 : 0.0});
    EXPECT_FALSE(may_be_said(table, "the length of light.color is greater than the length of point"));
    EXPECT_FALSE(may_be_said(table, "light.color.x is greater than point.x"));
    EXPECT_FALSE(may_be_said(table, "the length of point is no whole number"));
    EXPECT_TRUE(may_be_said(table, "point.z is no whole number"));
    table.names = {"light.center.x", "light.center.y", "light.center.z", "point.x", "point.y", "point.z"};
    EXPECT_TRUE(may_be_said(table, "light.center.x is greater than point.x"));
}

// "enabled is equal to writes", where both are true.
TEST(SillySentences, two_words_are_equal_only_where_they_are_so_in_several_ways)
{
    QuestionTable table{{"enabled", "writes"}, {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 0}, {0, 1}, {1, 0}, {0, 1}}};
    table.words = {{"false", "true"}, {"false", "true"}};
    EXPECT_FALSE(may_be_said(table, "enabled is equal to writes"));
    table.numbers[1] = {0, 0};
    EXPECT_TRUE(may_be_said(table, "enabled is equal to writes"));
}

// Places with a fourth coordinate, as OpenGL has lights: one that is 0 makes a direction of it.
TEST(SillySentences, a_direction_is_at_no_distance)
{
    QuestionTable table{{"light.position.x", "light.position.y", "light.position.z", "light.position.w", "point.x",
                         "point.y", "point.z"},
                        {{1, 2, 2, 1, 0, 0, 0}, {1, 2, 2, 0, 0, 0, 0}}};
    for (const Fact& fact : facts_of(table)) {
        if (fact.words != "the distance between light.position and point") continue;
        EXPECT_EQ(fact.values[0], 3);
        EXPECT_TRUE(std::isnan(fact.values[1]));
        return;
    }
    ADD_FAILURE() << "no distance";
}

}
}
