#include "question/answer_relations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <umbral/core/random.hpp>

#include "question/answer_patterns.hpp"
#include "question/first_pattern.hpp"
#include "question/number_changes.hpp"

// What wrong answers have to do with the right ones, and with what was asked.
namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

struct Asked {
    double t = 0;
    Row v{};
    Row right{};
};

constexpr std::size_t answers_made = 20;

/// Answers of so many numbers to questions of a number t and a vector v, of which two of three are wrong.
AnswerTable answers(std::size_t components, const std::function<Row(const Asked&)>& wrong, double most = 3)
{
    AnswerTable made;
    made.components = components;
    if (components == 3) made.columns = {"x", "y", "z"};
    for (const char* const name : {"t", "v.x", "v.y", "v.z"}) made.facts.push_back({name, Fact::Kind::number});
    made.facts.push_back({"the length of v", Fact::Kind::length});
    Random random(3);
    for (std::size_t i = 0; i < answers_made; ++i) {
        Asked one;
        one.t = random.uniform(1, 2);
        for (int k = 0; k < 3; ++k) one.v.push_back(random.uniform(0.2F, 1));
        for (std::size_t k = 0; k < components; ++k)
            one.right.push_back(random.uniform(0.3F, static_cast<float>(most)));
        const Row values{one.t, one.v[0], one.v[1], one.v[2], std::hypot(one.v[0], one.v[1], one.v[2])};
        for (std::size_t k = 0; k < values.size(); ++k) made.facts[k].values.push_back(values[k]);
        const bool is_wrong = i % 3 != 0;
        made.answers.push_back({is_wrong ? wrong(one) : one.right, one.right, is_wrong});
    }
    return made;
}

std::string of_number(const std::function<double(double)>& wrong, double most = 3)
{
    return first_pattern(answers(
        1, [&](const Asked& one) { return Row{wrong(one.right[0])}; }, most));
}

TEST(AnswerRelations, know_bytes_that_stand_the_other_way_round)
{
    const std::vector<double> right{1, 255, 256, 70'000, 4'294'967'295};
    const std::vector<double> yours{16'777'216, 4'278'190'080, 65'536, 1'880'162'560, 4'294'967'295};
    EXPECT_EQ(change_of_numbers(yours, right).value_or(AnswerPattern{}),
              "the right one with its 4 bytes in the opposite order");
    EXPECT_EQ(
        change_of_numbers(std::vector<double>{256, 2, 513}, std::vector<double>{1, 512, 258}).value_or(AnswerPattern{}),
        "the right one with its 2 bytes in the opposite order");
    EXPECT_EQ(change_of_numbers(std::vector<double>{16'777'216, 33'554'432}, std::vector<double>{1, 2})
                  .value_or(AnswerPattern{}),
              "2^24 times the right one")
        << "it may as well be a factor";
}

TEST(AnswerRelations, call_constants_by_their_names)
{
    constexpr double pi = std::numbers::pi;
    EXPECT_EQ(of_number([](double x) { return std::numbers::ln2 * x; }),
              "is ln 2 (as ln is of log2) times the right one");
    EXPECT_EQ(of_number([](double x) { return pi / 180 * x; }), "is pi/180 (degrees to radians) times the right one");
    EXPECT_EQ(of_number([](double x) { return -180 / pi * x; }), "is -180/pi (radians to degrees) times the right one");
    EXPECT_EQ(of_number([](double x) { return pi * x; }), "is pi times the right one");
    EXPECT_EQ(of_number([](double x) { return std::sqrt(2.0) * x; }), "is the square root of 2 times the right one");
    EXPECT_EQ(of_number([](double x) { return 2.0 / 3 * x; }), "is 2/3 times the right one");
    EXPECT_EQ(of_number([](double x) { return 65535.0 / 65536 * x; }), "is 65535/65536 times the right one");
    EXPECT_EQ(of_number([](double x) { return x - pi / 2; }), "is the right one minus pi/2");
    EXPECT_EQ(of_number([](double x) { return pi / 180 * x + 0.5; }),
              "is pi/180 (degrees to radians) times the right one plus 0.5");
    EXPECT_EQ(of_number([](double x) { return 1 - x; }), "is 1 minus the right one");
    // Near a constant is not the constant.
    EXPECT_EQ(constant_text(3.1412), "3.1412");
    EXPECT_EQ(constant_text(0.6931), "0.6931");
    EXPECT_EQ(constant_text(0.25), "0.25");
    EXPECT_EQ(multiple(0.25).tells, CommonTells::multiple);
    EXPECT_EQ(multiple(0.5 / std::numbers::ln2).tells, CommonTells::multiple);
    EXPECT_EQ(multiple(std::numbers::ln2).tells, CommonTells::other) << "it has a name";
    EXPECT_EQ(multiple(-1).tells, CommonTells::opposite);
    EXPECT_EQ(constant_text(INFINITY), "inf");
    EXPECT_EQ(constant_text(65535.0 / 65536), "65535/65536");
    EXPECT_EQ(constant_text(256.0 / 255), "256/255");
    EXPECT_EQ(constant_text(255.0 / 256), "255/256");
    EXPECT_EQ(constant_text(-256.0 / 257), "-256/257");
    EXPECT_EQ(constant_text(0.99712), "0.99712");
}

TEST(AnswerRelations, find_quotients_upside_down)
{
    EXPECT_EQ(of_number([](double x) { return 1 / x; }), "is 1 divided by the right one");
    EXPECT_EQ(of_number([](double x) { return 3 / x; }), "is 3 divided by the right one");
    // Of two different numbers, it may be chance.
    const Row yours{2, 0.5, 2, 0.5};
    const Row right{0.5, 2, 0.5, 2};
    EXPECT_FALSE(change_of_numbers(yours, right));
}

TEST(AnswerRelations, find_that_a_fraction_was_lost)
{
    EXPECT_EQ(of_number([](double x) { return std::trunc(x); }, 40), "is the right one without its fraction");
    EXPECT_EQ(of_number([](double x) { return std::ceil(x); }, 40), "is the right one rounded up");
    EXPECT_EQ(of_number([](double x) { return std::round(x); }, 40), "is the right one rounded to a whole number");
    EXPECT_EQ(first_pattern(answers(
                  3,
                  [](const Asked& one) {
                      return Row{std::trunc(one.right[0]), std::trunc(one.right[1]), std::trunc(one.right[2])};
                  },
                  40)),
              "is the right one without its fraction, in each of its numbers");
    const Row below{-1, -2, -3, -4};
    const Row right{-0.5, -1.25, -2.75, -3.5};
    EXPECT_EQ(change_of_numbers(below, right), "the right one rounded down");
    // Whole numbers have no fraction to lose.
    EXPECT_EQ(change_of_numbers(Row{1, 2, 3, 5}, Row{1, 2, 3, 4}), std::nullopt);
}

// Where the ends of an interval are taken in.
TEST(AnswerRelations, find_that_each_is_one_of_two_numbers)
{
    std::size_t number = 0;
    const auto either = [&](const Asked& one) { return Row{number++ % 2 == 0 ? one.t : one.v[1]}; };
    EXPECT_EQ(first_pattern(answers(1, either)), "is t or v.y");
    number = 0;
    const auto one_of_three = [&](const Asked& one) {
        ++number;
        return Row{number % 3 == 0 ? one.t : number % 3 == 1 ? one.v[1] : one.v[2]};
    };
    EXPECT_EQ(first_pattern(answers(1, one_of_three)).find(" or "), std::string::npos);
}

TEST(AnswerRelations, find_squares_of_what_was_asked)
{
    const auto with = [](const std::function<double(const Asked&)>& factor) {
        return first_pattern(answers(1, [&](const Asked& one) { return Row{factor(one) * one.right[0]}; }));
    };
    const auto square = [](const Asked& one) { return std::pow(std::hypot(one.v[0], one.v[1], one.v[2]), 2); };
    EXPECT_EQ(with(square), "is the right one times the square of the length of v");
    EXPECT_EQ(with([&](const Asked& one) { return 1 / square(one); }),
              "is the right one divided by the square of the length of v");
    EXPECT_EQ(with([&](const Asked& one) { return one.t * one.t; }), "is the right one times the square of t");
    EXPECT_EQ(first_pattern(answers(3,
                                    [&](const Asked& one) {
                                        Row wrong = one.right;
                                        for (double& x : wrong) x *= square(one);
                                        return wrong;
                                    })),
              "is the right one times the square of the length of v");
}

// Which of two numbers that are equal in all questions is meant, nobody can tell.
// A size in another one's place: differences of nearly equal floats keep few digits, and some are off by more.
TEST(AnswerRelations, find_the_quotient_of_two_sizes)
{
    const auto relation = [](const std::vector<std::string>& names, double most_off) {
        const std::vector<std::pair<double, double>> sizes{{2, 4}, {1, 128}, {5, 9}, {16, 4}};
        std::vector<Fact> facts;
        for (const std::string& name : names) facts.push_back({name, Fact::Kind::number});
        WrongNumbers numbers;
        Random random(7);
        for (std::size_t i = 0; i < 20; ++i) {
            const auto [width, height] = sizes[i % sizes.size()];
            facts[0].values.push_back(width);
            facts[1].values.push_back(height);
            numbers.right.push_back(random.uniform(-1, 1));
            const double off = i % 10 == 0 ? most_off : 1e-6;
            numbers.yours.push_back(numbers.right.back() * width / height * (1 + off));
            numbers.questions.push_back(i);
        }
        return relation_of(numbers, facts).value_or("nothing");
    };
    EXPECT_EQ(relation({"heights.width", "heights.height"}, 1e-2),
              "the right one times heights.width / heights.height");
    EXPECT_EQ(relation({"width", "height"}, 1e-7), "the right one times width / height");
    EXPECT_EQ(relation({"heights.width", "window.height"}, 1e-7), "nothing");
    EXPECT_EQ(relation({"heights.width", "heights.height"}, 0.1), "nothing");
}

TEST(AnswerRelations, name_all_numbers_that_are_the_same_there)
{
    AnswerTable made = answers(1, [](const Asked& one) { return Row{one.t * one.right[0]}; });
    made.facts.push_back(made.facts[0]);
    made.facts.back().words = "radius";
    EXPECT_EQ(first_pattern(made), "is the right one times t (here the same as radius)");
    for (const char* const name : {"a", "b"}) {
        made.facts.push_back(made.facts[0]);
        made.facts.back().words = name;
    }
    EXPECT_EQ(first_pattern(made).find("radius"), std::string::npos);
}

TEST(AnswerRelations, find_a_number_in_another_one_s_place)
{
    EXPECT_EQ(first_pattern(answers(3,
                                    [](const Asked& one) {
                                        return Row{one.right[0], one.right[0], one.right[2]};
                                    })),
              "differs in y only, which is the right x");
    EXPECT_EQ(first_pattern(answers(3,
                                    [](const Asked& one) {
                                        return Row{one.right[0], one.right[1], -one.right[1]};
                                    })),
              "differs in z only, which is the right y with the opposite sign");
}

TEST(AnswerRelations, find_a_column_in_another_one_s_place)
{
    const auto copied = [](double sign) {
        return first_pattern(answers(9, [sign](const Asked& one) {
            Row wrong = one.right;
            for (std::size_t i = 0; i < 3; ++i) wrong[3 + i] = sign * one.right[i];
            return wrong;
        }));
    };
    EXPECT_EQ(copied(1), "is right but for some columns: column 1 is the right column 0");
    EXPECT_EQ(copied(-1), "is right but for some columns: column 1 is the right column 0 with the opposite sign");
}

// Light that a surface gives off itself, say: beside bright light, floats keep few digits of it.
TEST(AnswerRelations, find_the_vector_that_is_lacking_or_too_much)
{
    const auto with = [](double sign, double scale) {
        return first_pattern(answers(3, [=](const Asked& one) {
            Row wrong;
            for (std::size_t i = 0; i < 3; ++i)
                wrong.push_back(static_cast<float>(scale * one.right[i]) + sign * one.v[i]);
            return wrong;
        }));
    };
    EXPECT_EQ(with(-1, 1), "lacks v");
    EXPECT_EQ(with(1, 1), "has v too much");
    EXPECT_EQ(with(1, 1.5).find(" v"), std::string::npos);
}

TEST(AnswerRelations, say_on_which_side_of_the_right_ones_all_lie)
{
    EXPECT_EQ(of_number([](double x) { return x + std::abs(std::sin(99 * x)) + 0.1; }), "is larger than the right one");
    EXPECT_EQ(of_number([](double x) { return x - std::abs(std::sin(99 * x)) - 0.1; }),
              "is smaller than the right one");
    EXPECT_EQ(of_number([](double x) { return x + std::sin(99 * x); }), "");
    EXPECT_EQ(
        first_pattern(answers(3,
                              [](const Asked& one) {
                                  return Row{one.right[0], one.right[1] + one.right[0] * one.right[0], one.right[2]};
                              })),
        "differs in y only, which is larger than the right one");
    AnswerTable few = answers(1, [](const Asked& one) { return Row{one.right[0] + one.right[0] * one.right[0]}; });
    few.answers.resize(10);
    EXPECT_EQ(first_pattern(few), "") << "of six, all may lie on one side by chance";
}

}
}
