#include "question/conditions.hpp"
#include "question/possible_conditions.hpp"
#include "question/words_of_condition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <umbral/core/random.hpp>

namespace umbral::grader {
namespace {

/// Rays and spheres, 400 of them: half of the rays begin inside.
QuestionTable rays(std::uint64_t seed)
{
    QuestionTable table{{"ray.origin.x", "ray.origin.y", "ray.origin.z", "ray.t_min", "sphere.centre.x",
                         "sphere.centre.y", "sphere.centre.z", "sphere.radius"},
                        {}};
    Random random(seed);
    for (int i = 0; i < 400; ++i) {
        const float radius = random.uniform(0.5F, 2);
        const glm::vec3 centre = random.in_cube();
        const glm::vec3 origin =
            centre + radius * random.uniform(0.1F, 0.9F) * (i % 2 == 0 ? 1.0F : 3.0F) * random.unit_vector() +
            (i % 2 == 0 ? 0.0F : 2.0F) * radius;
        const float least = i % 4 < 2 ? 0.0F : random.uniform(0.1F, 1);
        table.numbers.push_back({origin.x, origin.y, origin.z, least, centre.x, centre.y, centre.z, radius});
    }
    return table;
}

double apart(const std::vector<double>& row)
{
    return std::sqrt(std::pow(row[0] - row[4], 2) + std::pow(row[1] - row[5], 2) + std::pow(row[2] - row[6], 2));
}

TEST(Conditions, find_that_the_origin_lies_inside)
{
    const QuestionTable table = rays(1);
    const auto wrong = wrong_where(table, [](const auto& row) { return apart(row) < row[7]; });
    EXPECT_EQ(words(table, wrong), "the distance between ray.origin and sphere.centre is less than sphere.radius");
}

TEST(Conditions, call_values_by_their_names)
{
    QuestionTable table{{"closed", "rule", "count"}, {}};
    table.words = {{"false", "true"}, {"even_odd", "nonzero", "positive"}, {}};
    for (int i = 0; i < 60; ++i)
        table.numbers.push_back({static_cast<double>(i % 2), static_cast<double>(i / 2 % 3), static_cast<double>(i)});
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] == 1; })), "closed is true");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] == 0; })), "closed is false");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[1] == 2; })), "rule is positive");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[1] != 1; })), "rule is not nonzero");
}

// Questions of two kinds, whose numbers all differ: which of them is the reason, nobody can tell.
TEST(Conditions, name_the_other_numbers_that_part_alike)
{
    QuestionTable table{{"port.left", "port.width", "port.height", "count"}, {}};
    for (int i = 0; i < 40; ++i)
        table.numbers.push_back(i % 2 == 0 ? std::vector<double>{0, 32, 24, i / 2 % 5 + 1.0}
                                           : std::vector<double>{2, 20, 20, i / 2 % 5 + 1.0});
    const auto left =
        simplest_condition(facts_of(table), wrong_where(table, [](const auto& row) { return row[0] == 0; }));
    ASSERT_TRUE(left);
    EXPECT_EQ(sentence_of(*left),
              "wrong wherever port.left is 0 (20 of 20), right everywhere else (20 of 20); "
              "port.width and port.height tell them apart as well");
    const auto count =
        simplest_condition(facts_of(table), wrong_where(table, [](const auto& row) { return row[3] == 1; }));
    ASSERT_TRUE(count);
    EXPECT_TRUE(count->also_told_by.empty());
}

// On the border of a window: that the same component of two vectors is equal, not any two.
TEST(Conditions, compare_the_same_component_of_two_vectors)
{
    QuestionTable table{{"window.high.x", "window.high.y", "point.x", "point.y"}, {}};
    for (int i = 0; i < 60; ++i) {
        const double x = 1.25 + i % 5;
        const double y = 2.5 + i % 3;
        table.numbers.push_back({x, y, i % 4 == 0 ? x : i % 4 == 1 ? y : 0.1 * i, i % 4 == 2 ? y : 0.3 * i});
    }
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] == row[2]; })),
              "window.high.x is equal to point.x");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[1] == row[2]; })), "nothing");
}

TEST(Conditions, put_bounds_between_magnitudes)
{
    QuestionTable table{{"length"}, {}};
    for (int i = 0; i < 40; ++i) table.numbers.push_back({std::pow(10.0, -i)});
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] < 3e-12; })),
              "length is less than 5e-12");
}

TEST(Conditions, find_signs_zeros_and_bounds_in_the_simplest_words)
{
    const QuestionTable table = rays(2);
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[3] > 0; })), "ray.t_min is not 0");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[4] < 0; })),
              "sphere.centre.x is negative");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[7] >= 1; })),
              "sphere.radius is at least 1");
}

// What is not a number is not 0 either, and neither less nor more than any bound.
TEST(Conditions, say_of_numbers_that_are_none_what_is_true_of_them)
{
    QuestionTable table{{"light"}, {}};
    for (int i = 0; i < 48; ++i)
        table.numbers.push_back({i % 2 == 0 ? std::nan("") : 0.1 + 0.01 * static_cast<double>(i)});
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return std::isfinite(row[0]); })),
              "light is positive");
    for (std::vector<double>& row : table.numbers)
        if (row[0] > 0.4) row[0] -= 1;
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return std::isfinite(row[0]); })),
              "light is finite");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return !(row[0] < 0); })), "nothing");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] > 0; })), "light is positive");
}

// Such a bound means something only if it parts other questions too.
TEST(Conditions, say_whether_a_bound_was_put_between_these_very_questions)
{
    const QuestionTable table = rays(2);
    const auto fitted = [&](const std::vector<bool>& wrong) {
        return simplest_condition(facts_of(table), wrong)->fitted;
    };
    EXPECT_TRUE(fitted(wrong_where(table, [](const auto& row) { return row[7] >= 1; })));
    EXPECT_FALSE(fitted(wrong_where(table, [](const auto& row) { return row[4] < 0; })));
}

TEST(Conditions, say_whether_they_tell_of_the_right_answer)
{
    QuestionTable table = rays(2);
    const auto of_answer = [&](const std::vector<bool>& wrong) {
        return simplest_condition(facts_of(table), wrong)->of_answer;
    };
    const auto wrong = wrong_where(table, [](const auto& row) { return row[6] < 0; });
    EXPECT_FALSE(of_answer(wrong));
    table.answers = 6;
    EXPECT_TRUE(of_answer(wrong));
    EXPECT_FALSE(of_answer(wrong_where(table, [](const auto& row) { return row[4] < 0; })));
}

std::string condition_on(const std::vector<double>& values, const std::function<bool(double)>& is_wrong,
                         std::size_t answers_from = 1)
{
    QuestionTable table{{"number"}, {}, answers_from};
    for (const double value : values) table.numbers.push_back({value});
    return words(table, wrong_where(table, [&](const std::vector<double>& row) { return is_wrong(row[0]); }));
}

// Between two groups of numbers a bound can be put anywhere: what it is not, is simpler.
TEST(Conditions, put_no_bound_between_a_few_different_numbers)
{
    const auto large = [](double x) { return x > 0.3; };
    std::vector<double> values;
    for (int i = 0; i < 20; ++i) values.push_back(i % 2 == 0 ? 0.0 : 0.8 + 0.001 * i);
    EXPECT_EQ(condition_on(values, large, 0), "number is not 0");
    for (double& x : values) x += 0.1;
    EXPECT_EQ(condition_on(values, large), "nothing") << "at least 0.4, 0.5, or 0.9";
    // Counts: that all but one group are wrong says that one, and no bound.
    std::vector<double> counts;
    for (int i = 0; i < 40; ++i) counts.push_back(3 + i % 6);
    EXPECT_EQ(condition_on(counts, [](double x) { return x > 5; }), "number is at least 6");
    EXPECT_EQ(condition_on(counts, [](double x) { return x > 7; }), "nothing");
    EXPECT_EQ(condition_on(
                  counts, [](double x) { return x > 5; }, 0),
              "nothing")
        << "codes have no order";
}

TEST(Conditions, take_numbers_that_always_are_one_for_no_equal_ones)
{
    QuestionTable table{{"radius", "distance"}, {}};
    for (int i = 0; i < 40; ++i) table.numbers.push_back({2.5, i % 2 == 0 ? 2.5 : 2.1 + 0.1 * (i % 7)});
    const auto equal = [](const std::vector<double>& row) { return row[0] == row[1]; };
    EXPECT_EQ(words(table, wrong_where(table, equal)), "nothing");
    for (int i = 0; i < 40; ++i)
        for (double& x : table.numbers[static_cast<std::size_t>(i)]) x += 0.25 * (i % 5);
    EXPECT_EQ(words(table, wrong_where(table, equal)), "radius is equal to distance");
}

TEST(Conditions, know_which_are_simple)
{
    const QuestionTable table = rays(4);
    const auto simple = [&](const auto& test) {
        return simplest_condition(facts_of(table), wrong_where(table, test))->is_simple;
    };
    EXPECT_TRUE(simple([](const auto& row) { return row[3] > 0; }));
    EXPECT_TRUE(simple([](const auto& row) { return row[4] < 0; }));
    EXPECT_FALSE(simple([](const auto& row) { return row[7] >= 1; }));
    EXPECT_FALSE(simple([](const auto& row) { return apart(row) < row[7]; }));
    EXPECT_FALSE(simple([](const auto& row) { return row[3] > 0 && row[5] < 0; }));
}

TEST(Conditions, join_two_where_one_does_not_do)
{
    const QuestionTable table = rays(3);
    const auto wrong = wrong_where(table, [](const auto& row) { return row[3] > 0 && row[5] < 0; });
    const std::string found = words(table, wrong);
    EXPECT_NE(found.find("ray.t_min is not 0"), std::string::npos) << found;
    EXPECT_NE(found.find("sphere.centre.y is negative"), std::string::npos) << found;
    EXPECT_NE(found.find(" and "), std::string::npos) << found;
}

TEST(Conditions, say_nothing_about_chance)
{
    int said = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const QuestionTable table = rays(seed);
        Random random(seed + 1000);
        const auto wrong = wrong_where(table, [&](const auto&) { return random.below(2) == 0; });
        said += words(table, wrong) == "nothing" ? 0 : 1;
    }
    EXPECT_EQ(said, 0);
}

// An unforeseen bug shows in few of many questions: what is true of them may be true of hardly any other.
TEST(Conditions, of_few_wrong_ones_leave_out_the_right_ones)
{
    QuestionTable table{{"size.x", "size.y", "scale"}, {}};
    for (int i = 0; i < 400; ++i)
        table.numbers.push_back({i < 5 ? 0.0 : 1.0 + i % 7, i < 10 ? 3.0 : 1.0 + i % 5, i < 12 ? -0.0 : i * 1.0});
    const auto first = [&](std::size_t count) {
        std::vector<bool> wrong(400, false);
        std::fill_n(wrong.begin(), count, true);
        return words(table, wrong);
    };
    EXPECT_EQ(first(5), "size.x is 0");
    EXPECT_EQ(first(12), "scale is 0");
    // It holds for 12, of which 8 are right.
    table.numbers.front()[0] = 1;
    for (std::vector<double>& row : table.numbers) row[0] += 1;
    EXPECT_EQ(first(4), "nothing");
}

TEST(Conditions, tell_minus_zero_and_the_least_coordinate)
{
    QuestionTable table{{"window.x", "window.y", "shift"}, {}};
    for (int i = 0; i < 60; ++i)
        table.numbers.push_back({i % 6 == 0 ? 0.0 : 2.0 + i, i % 6 == 3 ? 0.0 : 90.0 - i, i % 4 == 0 ? -0.0 : 0.0});
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return row[0] == 0 || row[1] == 0; })),
              "the least coordinate of window is 0");
    EXPECT_EQ(words(table, wrong_where(table, [](const auto& row) { return std::signbit(row[2]); })), "shift is -0");
}

TEST(Conditions, need_four_of_either)
{
    QuestionTable table{{"x"}, {{-1}, {-2}, {-3}, {1}, {2}, {3}, {4}}};
    const auto negative = [](const auto& row) { return row[0] < 0; };
    EXPECT_EQ(words(table, wrong_where(table, negative)), "nothing");
    table.numbers.push_back({-4});
    EXPECT_EQ(words(table, wrong_where(table, negative)), "x is negative");
}

TEST(Conditions, count_what_they_part)
{
    QuestionTable table{{"x"}, {}};
    for (int i = -100; i <= 100; ++i) table.numbers.push_back({static_cast<double>(i)});
    auto wrong = wrong_where(table, [](const auto& row) { return row[0] < 0; });
    wrong[200] = true;
    const auto condition = simplest_condition(facts_of(table), wrong);
    ASSERT_TRUE(condition);
    EXPECT_EQ(sentence_of(*condition), "wrong wherever x is negative (100 of 101), right everywhere else (100 of 100)");
}

TEST(Conditions, hold_or_not_on_other_questions)
{
    const QuestionTable seen = rays(5);
    const auto inside = [](const auto& row) { return apart(row) < row[7]; };
    const auto condition = simplest_condition(facts_of(seen), wrong_where(seen, inside));
    ASSERT_TRUE(condition);
    const QuestionTable fresh = rays(6);
    EXPECT_TRUE(parts(*condition, facts_of(fresh), wrong_where(fresh, inside)));
    EXPECT_FALSE(parts(*condition, facts_of(fresh), wrong_where(fresh, [](const auto& row) { return row[4] < 0; })));
    EXPECT_FALSE(parts(*condition, facts_of(fresh), std::vector<bool>(400, true)));
}

// A side of 1 is less than 30 degrees, always: that is no reason.
TEST(Conditions, compare_no_angle_with_a_length)
{
    QuestionTable table{{"side", "fovy_degrees", "distance"}, {}};
    for (int i = 0; i < 40; ++i) table.numbers.push_back({1.0 + i % 3, i % 2 == 0 ? 105.5 + i : 99.5 - i, 9.0});
    const auto wide = [](const std::vector<double>& row) { return row[1] > 100; };
    EXPECT_EQ(words(table, wrong_where(table, wide)), "fovy_degrees is at least 100");
}

}
}
