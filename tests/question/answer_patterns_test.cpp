#include "question/answer_patterns.hpp"
#include "question/first_pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <umbral/core/random.hpp>
#include <utility>

namespace umbral::grader::test {
namespace {

TEST(AnswerPatterns, say_what_is_always_answered)
{
    EXPECT_EQ(first_pattern(table(1, [](Row) { return Row{0}; })), "is 0");
    EXPECT_EQ(first_pattern(table(3, [](Row) { return Row{0, 0, 1}; })), "is (0, 0, 1)");
    EXPECT_EQ(first_pattern(table(1, [](Row) { return Row{}; })), "is empty");
    EXPECT_EQ(first_pattern(table(1, [](Row) { return Row{std::numeric_limits<double>::quiet_NaN()}; })),
              "is not finite");
}

TEST(AnswerPatterns, say_what_was_done_to_the_right_answer)
{
    EXPECT_EQ(first_pattern(table(1, [](Row right) { return Row{right[0] + 1}; })), "is the right one plus 1");
    EXPECT_EQ(first_pattern(table(1, [](Row right) { return Row{2 * right[0]}; })), "is 2 times the right one");
    EXPECT_EQ(first_pattern(table(1, [](Row right) { return Row{-right[0]}; })),
              "is the right one with the opposite sign");
}

TEST(AnswerPatterns, know_integers_that_are_too_small)
{
    const auto wrap = [](Row right) { return Row{std::fmod(right[0], 65536)}; };
    AnswerTable made = table(1, [](Row right) { return right; });
    for (std::size_t i = 0; i < made.answers.size(); ++i) {
        AnswerPair& one = made.answers[i];
        one.expected = {70000.0 + 30011.0 * static_cast<double>(i)};
        one.yours = wrap(one.expected);
        one.wrong = true;
    }
    EXPECT_EQ(first_pattern(made).find("is what an integer of 16 bits can hold"), 0U) << first_pattern(made);
}

// No chance gives even one such answer. Large sums may be recorded as floats, and only a term of them wrapped round.
TEST(AnswerPatterns, know_few_integers_that_wrapped_round_in_part)
{
    AnswerTable made{2, 0, {"plain", "indexed"}, {}, {}};
    for (const double vertices : {10.0, 20.0, 4e8, 3e9, 8.589934592e9}) {
        const double right = 12 * vertices + 28;
        const double wrapped = std::fmod(12 * vertices, 0x1p32) + 28;
        const auto recorded = [](double x) { return double(static_cast<float>(x)); };
        made.answers.push_back({{60, recorded(wrapped)}, {60, recorded(right)}, wrapped != right});
    }
    EXPECT_EQ(first_pattern(made).find("differs in indexed only, which is the right one less a multiple of 2^32"), 0U)
        << first_pattern(made);
    made.answers[3].yours[1] += 1 << 20;
    EXPECT_EQ(first_pattern(made), "differs in indexed only");
}

// Numbers of double that are no numbers of four digits, and such as float does not have.
TEST(AnswerPatterns, take_factors_of_any_size)
{
    for (const double factor : {1e-310, 5e-324, std::numeric_limits<double>::max(), 1e308}) {
        const auto patterns = answer_patterns(table(1, [factor](Row right) { return Row{right[0] * factor}; }));
        EXPECT_TRUE(patterns.empty() || !patterns.front().words.empty()) << factor;
    }
}

TEST(AnswerPatterns, say_which_number_of_a_row_differs)
{
    const auto spoilt = [](Row right) { return Row{right[0], right[1] * right[1], right[2]}; };
    EXPECT_EQ(first_pattern(table(3, spoilt)), "differs in y only");
    const auto moved = [](Row right) { return Row{right[0], right[1] - 3, right[2]}; };
    EXPECT_EQ(first_pattern(table(3, moved)), "differs in y only, which is the right one minus 3");
    EXPECT_EQ(first_pattern(table(3,
                                  [](Row right) {
                                      return Row{right[0] * right[0], right[1] * right[1], right[2]};
                                  })),
              "differs in other numbers than z");
}

TEST(AnswerPatterns, do_not_say_that_all_differs_but_what_a_row_is_about)
{
    // Corners: polygon, -, corner, x, y, z.
    const auto spoilt = [](Row right) {
        for (std::size_t i = 3; i < right.size(); ++i) right[i] *= right[i];
        return right;
    };
    AnswerTable corners = table(6, spoilt);
    EXPECT_NE(first_pattern(corners), "");
    corners.keys = 3;
    EXPECT_EQ(first_pattern(corners), "");
    corners =
        table(6, [](Row right) { return Row{right[0], right[1], right[2], right[3], right[4] * right[4], right[5]}; });
    corners.keys = 3;
    corners.columns.clear();
    EXPECT_EQ(first_pattern(corners), "differs in its number 2 only");
}

TEST(AnswerPatterns, say_which_rows_of_a_list_are_missing_or_too_many)
{
    const auto cut = [](Row right) { return Row(right.begin(), right.end() - 1); };
    EXPECT_EQ(first_pattern(table(1, cut, 4)), "lacks the last row");
    EXPECT_EQ(first_pattern(table(
                  1, [](Row right) { return Row(right.begin() + 1, right.end()); }, 4)),
              "lacks the first row");
    const auto longer = [](Row right) {
        right.push_back(right.front());
        return right;
    };
    EXPECT_EQ(first_pattern(table(1, longer, 4)), "has a row too many at its end");
    EXPECT_EQ(first_pattern(table(
                  1, [](Row right) { return Row(right.rbegin(), right.rend()); }, 4)),
              "has its rows in the opposite order");
}

// That y is wrong is seen; that it is the right one minus 3 may be chance.
TEST(AnswerPatterns, of_few_wrong_answers_say_only_which_numbers_differ)
{
    AnswerTable made = table(3, [](Row right) { return Row{right[0], right[1] - 3, right[2]}; });
    made.answers.resize(4);
    EXPECT_EQ(answer_patterns(made), (std::vector<AnswerPattern>{{"differs in y only", CommonTells::place}}));
    made.answers.resize(2);
    EXPECT_EQ(answer_patterns(made), std::vector<AnswerPattern>{}) << "the one row is shown anyway";
}

TEST(AnswerPatterns, say_nothing_of_few_wrong_answers)
{
    AnswerTable made = table(1, [](Row) { return Row{0}; });
    made.answers.resize(2 * (least_wrong - 1));
    EXPECT_EQ(first_pattern(made), "");
}

/// Questions of one number t and one vector v, with their right answers, and wrong ones made of both.
template <class Wrong>
AnswerTable asked_table(std::size_t components, Wrong wrong)
{
    AnswerTable made{components, 0, {}, {}, {}};
    if (components == 3) made.columns = {"x", "y", "z"};
    for (const char* const name : {"t", "v.x", "v.y", "v.z"}) made.facts.push_back({name, Fact::Kind::number});
    made.facts.push_back({"the length of v", Fact::Kind::length});
    Random random(7);
    for (std::size_t i = 0; i < 20; ++i) {
        const double t = 1 + static_cast<double>(random.uniform());
        const Row v{random.uniform(), random.uniform(), random.uniform()};
        const Row values{t, v[0], v[1], v[2], std::hypot(v[0], v[1], v[2])};
        for (std::size_t k = 0; k < values.size(); ++k) made.facts[k].values.push_back(values[k]);
        Row right;
        for (std::size_t c = 0; c < components; ++c) right.push_back(random.uniform(-1, 1));
        const bool is_wrong = i % 3 != 0;
        made.answers.push_back({is_wrong ? wrong(t, v, right) : right, right, is_wrong});
    }
    return made;
}

TEST(AnswerPatterns, say_what_wrong_answers_have_to_do_with_their_questions)
{
    const auto number = [](auto wrong) {
        return first_pattern(asked_table(1, [&](double t, const Row& v, const Row& right) {
            return Row{wrong(t, std::hypot(v[0], v[1], v[2]), right[0])};
        }));
    };
    EXPECT_EQ(number([](double t, double, double) { return t; }), "is the given t");
    EXPECT_EQ(number([](double t, double, double right) { return right + t; }), "is the right one plus t");
    EXPECT_EQ(number([](double t, double, double right) { return right - t; }), "is the right one minus t");
    EXPECT_EQ(number([](double, double length, double right) { return right * length; }),
              "is the right one times the length of v");
    EXPECT_EQ(number([](double, double length, double right) { return right / length; }),
              "is the right one divided by the length of v");
    EXPECT_EQ(number([](double, double, double right) { return 0.5 * right + 3; }),
              "is 0.5 times the right one plus 3");
    EXPECT_EQ(number([](double t, double, double right) { return t * t * right + 1; }), "");
    EXPECT_EQ(first_pattern(asked_table(3,
                                        [](double t, const Row&, const Row& right) {
                                            return Row{right[0], right[1], right[2] + t};
                                        })),
              "differs in z only, which is the right one plus t");
}

TEST(AnswerPatterns, say_what_wrong_vectors_are)
{
    const auto vector = [](auto wrong) { return first_pattern(asked_table(3, wrong)); };
    EXPECT_EQ(vector([](double, const Row& v, const Row&) { return v; }), "is the given v");
    EXPECT_EQ(vector([](double, const Row& v, const Row&) {
                  return Row{-v[0], -v[1], -v[2]};
              }),
              "is the given v with the opposite sign");
    EXPECT_EQ(vector([](double, const Row& v, const Row& right) {
                  const double length = std::hypot(v[0], v[1], v[2]);
                  return Row{length * right[0], length * right[1], length * right[2]};
              }),
              "is the right one times the length of v");
    EXPECT_EQ(vector([](double, const Row&, const Row& right) {
                  const double factor = 1 + right[0] * right[0];
                  return Row{factor * right[0], factor * right[1], factor * right[2]};
              }),
              "has the right direction, but not the right length");
    EXPECT_EQ(vector([](double, const Row&, const Row& right) {
                  return Row{3 * right[0], 3 * right[1], 3 * right[2]};
              }),
              "is 3 times the right one");
    EXPECT_EQ(vector([](double, const Row&, const Row& right) {
                  return Row{right[1], -right[0], right[2]};
              }),
              "is (y, -x, z) of the right one");
    EXPECT_EQ(vector([](double, const Row&, const Row& right) {
                  return Row{right[0], right[2], right[1]};
              }),
              "is the right one with y and z exchanged");
}

TEST(AnswerPatterns, say_which_columns_of_a_matrix_are_wrong)
{
    const auto scaled = [](double, const Row& v, Row right) {
        const double length = std::hypot(v[0], v[1], v[2]);
        for (std::size_t i = 3; i < 6; ++i) right[i] *= length;
        return right;
    };
    EXPECT_EQ(first_pattern(asked_table(9, scaled)),
              "is right but for some columns: column 1 is the right one times the length of v");
}

TEST(AnswerPatterns, say_that_an_answer_comes_one_question_late)
{
    Row last;
    const auto late = [&](double, const Row&, const Row& right) { return std::exchange(last, right); };
    AnswerTable made = asked_table(3, [](double, const Row&, const Row& right) { return right; });
    for (AnswerPair& one : made.answers) {
        one.yours = late(0, {}, one.expected);
        one.wrong = true;
    }
    made.answers.front().yours = made.answers.front().expected;
    made.answers.front().wrong = false;
    EXPECT_EQ(first_pattern(made), "is the right one to the question before");
}

TEST(AnswerPatterns, say_of_no_numbers_that_they_are_one_infinite_one)
{
    AnswerTable made = asked_table(1, [](double t, const Row&, const Row&) { return Row{t * t}; });
    std::ranges::find_if(made.answers, &AnswerPair::wrong)->yours = {INFINITY};
    EXPECT_EQ(first_pattern(made), "");
}

TEST(AnswerPatterns, say_nothing_of_questions_about_infinity)
{
    AnswerTable made = asked_table(1, [](double t, const Row&, const Row& right) { return Row{right[0] * t * t}; });
    for (double& t : made.facts.front().values) t = INFINITY;
    EXPECT_EQ(first_pattern(made), "");
}

// Answers by chance have nothing to do with anything.
TEST(AnswerPatterns, say_nothing_of_numbers_by_chance)
{
    Random random(11);
    for (int i = 0; i < 300; ++i)
        for (const std::size_t components : {std::size_t{1}, std::size_t{3}, std::size_t{9}}) {
            const auto chance = [&](double, const Row&, Row right) {
                for (double& x : right) x = random.uniform(-2, 2);
                return right;
            };
            EXPECT_EQ(first_pattern(asked_table(components, chance)), "");
        }
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
        EXPECT_EQ(first_pattern(table(3, noise, static_cast<std::size_t>(round) % 3 + 1)), "") << "round " << round;
    }
}

// As where y stands for z in the third of three.
TEST(AnswerPatterns, say_that_a_row_is_the_one_before_once_more)
{
    AnswerTable made{3, 0, {"x", "y", "z"}, {}, {}};
    made.several = true;
    for (int i = 0; i < 30; ++i) {
        const Row right{0.3 * i, std::sin(7.0 * i), std::cos(5.0 * i)};
        const bool is_third = i % 3 == 2;
        made.answers.push_back({is_third ? made.answers.back().yours : right, right, is_third});
    }
    EXPECT_EQ(first_pattern(made), "is your row before it once more");
    made.answers[5].yours[1] += 0.5;
    EXPECT_EQ(first_pattern(made).find("once more"), std::string::npos);
}

}
}
