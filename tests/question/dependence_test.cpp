#include "question/dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <umbral/record/not_finite.hpp>

#include "question/movable.hpp"
#include "question/moved_answers.hpp"

namespace umbral::grader::moved_test {
namespace {

double length(const Asked& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

const MovedPlace left{"f", "0.left"};
const MovedPlace top{"f", "0.top"};
const MovedPlace size{"f", "1"};
const MovedPlace vector{"f", "2"};

TEST(Dependence, one_number_is_taken_for_another)
{
    const auto found = dependences(answers(
        [](const Asked& a) {
            return std::vector{a.left, a.left * a.size};
        },
        [](const Asked& a) {
            return std::vector{a.left, a.top * a.size};
        }));
    EXPECT_EQ(found, (std::vector<Dependence>{{{1}, {left}, {top}}}));
}

TEST(Dependence, something_is_forgotten_in_all_numbers)
{
    const auto found = dependences(answers(
        [](const Asked& a) {
            return std::vector{a.left, a.top + 1};
        },
        [](const Asked& a) {
            return std::vector{a.left * a.size, a.top + a.size};
        }));
    EXPECT_EQ(found, (std::vector<Dependence>{{{0, 1}, {}, {size}}}));
}

TEST(Dependence, a_vector_stands_for_its_components)
{
    const auto found = dependences(answers([](const Asked& a) { return std::vector{a.left * a.x * a.y * a.z}; },
                                           [](const Asked& a) { return std::vector{a.left + 1}; }));
    EXPECT_EQ(found, (std::vector<Dependence>{{{0}, {vector}, {}}}));
}

TEST(Dependence, a_vector_should_have_been_made_unit)
{
    const auto found = dependences(answers([](const Asked& a) { return std::vector{a.x * a.left}; },
                                           [](const Asked& a) { return std::vector{a.x / length(a) * a.left}; }));
    // Without the length, x alone is another question.
    EXPECT_EQ(found, (std::vector<Dependence>{{{0}, {{"f", "2", true}}, {{"f", "2.y"}, {"f", "2.z"}}}}));
}

TEST(Dependence, nothing_is_said_of_what_does_not_change_or_changes_with_all)
{
    const Answer right = [](const Asked& a) { return std::vector{a.left * a.top + a.size}; };
    EXPECT_TRUE(dependences(answers([](const Asked&) { return std::vector{7.0}; }, right)).empty());
    const Answer sum = [](const Asked& a) { return std::vector{a.left * a.top - a.size}; };
    EXPECT_TRUE(dependences(answers(sum, right)).empty()) << "a wrong sign changes nothing";
    EXPECT_TRUE(dependences(answers([](const Asked&) { return std::vector{std::nan("")}; }, right)).empty());
}

// That an answer changes because what is moved leads away from the one place where it is wrong tells nothing.
TEST(Dependence, nothing_is_said_of_what_is_wrong_in_single_places_only)
{
    const Answer right = [](const Asked& a) { return std::vector{a.top * a.size}; };
    AnswersToMoves all = answers([](const Asked& a) { return std::vector{a.left == 1 ? 7 : a.top * a.size}; }, right);
    all.wrong = {0, 0, 0};
    EXPECT_TRUE(dependences(all).empty());
    // Where two are equal, one is chosen: three of five moves end that, and the others leave it wrong.
    AnswersToMoves tie{1, {3, 3, 3}, {2, 2, 2}, {0, 1, 2}, {}, {}};
    for (const char* const place : {"0", "1", "2", "3", "4"}) {
        const bool ends = *place < '3';
        const auto rows = [](double x) { return std::vector{x, x, x}; };
        tie.moved.push_back({{"f", place, "moved", ""}, rows(ends ? 5 : 4), rows(ends ? 5 : 2)});
    }
    EXPECT_TRUE(dependences(tie).empty());
    all = answers([](const Asked& a) { return std::vector{a.left == 1 ? 7 : a.top}; }, right);
    all.wrong = {0, 0, 0};
    const auto found = dependences(all);
    ASSERT_EQ(found.size(), 1U) << "it is wrong elsewhere, too";
    EXPECT_EQ(found.front().wrongly, (std::vector<MovedPlace>{left}));
}

TEST(Dependence, the_order_of_a_list_is_called_so)
{
    AnswersToMoves all =
        answers([](const Asked& a) { return std::vector{a.left}; }, [](const Asked& a) { return std::vector{a.top}; });
    all.moved.push_back({{"f", "3", "moved order", ""}, all.yours, all.right});
    for (double& number : all.moved.back().yours) number *= 2;
    const auto found = dependences(all);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().wrongly, (std::vector<MovedPlace>{left, {"f", "3", false, true}}));
}

// Where the one set of inputs has all numbers of a kind, what it shows is that kind's.
TEST(Dependence, each_set_of_inputs_must_show_it)
{
    const Answer yours = [](const Asked& a) { return std::vector{a.left + (a.x > 2 ? a.top : 0)}; };
    AnswersToMoves all = answers(yours, [](const Asked& a) { return std::vector{a.left * 3}; });
    all.wrong = {0, 1, 2, 3, 4, 0, 1, 2, 3};
    EXPECT_FALSE(dependences(all).empty());
    all.wrong = {0, 1, 2, 3, 0, 1, 2, 3, 4, 4, 4, 4};
    all.ends = {8, 12};
    EXPECT_TRUE(dependences(all).empty()) << "the last question's answers do not change with top";
}

TEST(Dependence, beside_infinity_all_changes_would_be_rounding)
{
    const auto beside = [](double x) { return std::vector{x, double{recorded_infinity}}; };
    const auto found = dependences(answers([&](const Asked& a) { return beside(a.left * a.size); },
                                           [&](const Asked& a) { return beside(a.top * a.size); }));
    EXPECT_TRUE(found.empty()) << "nothing is said of what cannot be told";
}

TEST(Dependence, rounding_is_no_change)
{
    const Answer right = [](const Asked& a) { return std::vector{a.left * 1000}; };
    const auto found =
        dependences(answers([](const Asked& a) { return std::vector{a.left * 1001 + 1e-7 * a.top * a.left}; }, right));
    EXPECT_TRUE(found.empty());
}

TEST(Dependence, fewer_than_three_answers_say_nothing)
{
    AnswersToMoves few =
        answers([](const Asked& a) { return std::vector{a.left}; }, [](const Asked& a) { return std::vector{a.top}; });
    EXPECT_FALSE(dependences(few).empty());
    few.wrong = {1, 3};
    EXPECT_TRUE(dependences(few).empty());
}

std::vector<std::string> moved_of(const QuestionLog& log)
{
    std::vector<std::string> all;
    for (const OtherQuestion& move : movable(log, "f")) all.push_back(move.place + ' ' + move.change);
    return all;
}

TEST(Movable, what_has_length_one_keeps_it)
{
    QuestionLog log;
    log.kinds = {{"f", {"0.x", "0.y", "1.x", "1.y"}, {{}, {}, {}, {}}, {{0, {0.6, 0.8, 1, 2}}, {1, {0, 1, 0.6, 0.8}}}}};
    for (const char* place : {"0", "1"})
        for (const char* change : {"moved .x", "moved length", "moved direction"})
            log.moves.push_back({"f", place, change, ""});
    log.moves.push_back({"g", "0", "moved", ""});
    EXPECT_EQ(moved_of(log), (std::vector<std::string>{"0 moved direction", "1 moved .x", "1 moved length"}));
}

TEST(Movable, the_parts_of_a_frame_or_a_quaternion_are_left_alone)
{
    QuestionLog log;
    log.kinds = {{"f",
                  {"0.a.x", "0.a.y", "0.b.x", "0.b.y", "1.w", "1.v.x", "1.v.y", "2"},
                  {{}, {}, {}, {}, {}, {}, {}, {}},
                  {{0, {1, 0, 0, 1, 0.6, 0.8, 0, 5}}, {1, {0, 1, -1, 0, 0, 0.6, 0.8, 6}}}}};
    for (const char* place : {"0.a", "0.b"}) log.moves.push_back({"f", place, "moved direction", ""});
    log.moves.push_back({"f", "1.w", "moved", ""});
    log.moves.push_back({"f", "1.v", "moved .x", ""});
    log.moves.push_back({"f", "2", "moved", ""});
    EXPECT_EQ(moved_of(log), (std::vector<std::string>{"2 moved"}));
}

TEST(Movable, entries_that_make_a_matrix_what_it_is_are_left_alone)
{
    QuestionLog log;
    log.kinds = {{"f", {"0[0][0]", "0[0][1]"}, {{}, {}}, {{0, {2, 0}}, {1, {3, 0}}}}};
    for (const char* change : {"moved [0][0]", "moved [0][1]"}) log.moves.push_back({"f", "0", change, ""});
    EXPECT_EQ(moved_of(log), (std::vector<std::string>{"0 moved [0][0]"}));
}

}
}
