#include "question/conditions.hpp"
#include "question/one_sided.hpp"
#include "question/words_of_condition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>

// Bounds between right and wrong answers: of sizes, of differences, on both sides, and where they may lie.
namespace umbral::grader {
namespace {

/// Vectors of lengths from 1e-30 to 1e30, every eighth of them null, and angles from -10⁷ to 10⁷ degrees.
QuestionTable vectors(std::uint64_t seed)
{
    QuestionTable table{{"normal.x", "normal.y", "normal.z", "l.x", "l.y", "l.z", "degrees"}, {}};
    Random random(seed);
    for (int i = 0; i < 240; ++i) {
        const auto vector = [&] { return std::pow(10.0, random.uniform(-30, 30)) * glm::dvec3(random.unit_vector()); };
        const glm::dvec3 normal = i % 8 == 7 ? glm::dvec3(0) : vector();
        const glm::dvec3 l = vector();
        const double degrees = (i % 2 == 0 ? -1 : 1) * std::pow(10.0, random.uniform(0, 7));
        table.numbers.push_back({normal.x, normal.y, normal.z, l.x, l.y, l.z, degrees});
    }
    return table;
}

double length_at(const std::vector<double>& row, std::size_t first)
{
    return std::sqrt(row[first] * row[first] + row[first + 1] * row[first + 1] + row[first + 2] * row[first + 2]);
}

TEST(BoundConditions, tell_of_sizes_without_their_signs)
{
    const QuestionTable table = vectors(1);
    const std::string said = words(table, wrong_where(table, [](const auto& row) { return std::abs(row[6]) > 1e5; }));
    EXPECT_TRUE(said.starts_with("the size of degrees is at least ")) << said;
}

TEST(BoundConditions, tell_of_lengths_that_are_too_small_or_too_large)
{
    const QuestionTable table = vectors(2);
    const auto is_lost = [](double length) { return length != 0 && (length < 1e-19 || length > 1e19); };
    const std::string one =
        words(table, wrong_where(table, [&](const auto& row) { return is_lost(length_at(row, 3)); }));
    EXPECT_TRUE(one.starts_with("the length of l is less than ")) << one;
    EXPECT_NE(one.find(" or at least "), std::string::npos) << one;
    const std::string null =
        words(table, wrong_where(table, [&](const auto& row) { return is_lost(length_at(row, 0)); }));
    EXPECT_TRUE(null.starts_with("the length of normal is above 0 and less than ")) << null;
}

TEST(BoundConditions, tell_of_the_shortest_of_several_vectors)
{
    QuestionTable table = vectors(3);
    std::erase_if(table.numbers, [](const auto& row) { return length_at(row, 0) == 0; });
    const auto shortest = [](const auto& row) { return std::min(length_at(row, 0), length_at(row, 3)); };
    const std::string said = words(table, wrong_where(table, [&](const auto& row) { return shortest(row) < 1e-15; }));
    EXPECT_TRUE(said.starts_with("the length of the shortest of normal and l is less than ")) << said;
}

TEST(BoundConditions, tell_how_far_numbers_of_a_struct_lie_apart)
{
    QuestionTable table{{"segment.from.x", "segment.from.y", "segment.to.x", "segment.to.y"}, {}};
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const double x = random.uniform(-1.0F, 1.0F);
        const double apart = (i % 2 == 0 ? -1 : 1) * std::pow(10.0, random.uniform(-9, 0));
        table.numbers.push_back({x, random.uniform(-1.0F, 1.0F), x + apart, random.uniform(-1.0F, 1.0F)});
    }
    const auto steep = [](const auto& row) { return std::abs(row[2] - row[0]) < 1e-6; };
    const std::string said = words(table, wrong_where(table, steep));
    EXPECT_TRUE(said.starts_with("the size of segment.to.x - segment.from.x is less than ")) << said;
}

// Questions between the last right and the first wrong one that were seen say nothing about a bound put there.
TEST(BoundConditions, leave_undecided_what_lies_nearer_than_all_that_was_seen)
{
    QuestionTable seen{{"height"}, {}};
    for (int i = 0; i < 40; ++i) seen.numbers.push_back({0.1 * i});
    const auto is_wrong = [](double bound) {
        return [bound](const std::vector<double>& row) { return row[0] > bound; };
    };
    const auto condition = simplest_condition(facts_of(seen), wrong_where(seen, is_wrong(2.01)));
    ASSERT_TRUE(condition);
    QuestionTable fresh = seen;
    for (int i = 0; i < 20; ++i) fresh.numbers.push_back({2.0001 + 0.0999 * i / 20});
    EXPECT_TRUE(parts(*condition, facts_of(fresh), wrong_where(fresh, is_wrong(2.01))));
    EXPECT_TRUE(parts(*condition, facts_of(fresh), wrong_where(fresh, is_wrong(2.09))));
    EXPECT_FALSE(parts(*condition, facts_of(fresh), wrong_where(fresh, is_wrong(2.35))));
}

// A condition that was found on some questions is asked of others by the places of its facts.
TEST(BoundConditions, look_at_the_same_facts_whatever_the_numbers_are)
{
    QuestionTable table = vectors(7);
    const std::vector<Fact> before = facts_of(table);
    for (std::vector<double>& row : table.numbers)
        for (double& number : row) number = 1 + std::abs(number);
    EXPECT_TRUE(std::ranges::equal(facts_of(table), before, {}, &Fact::words, &Fact::words));
}

// Each is so in all of these questions by the way they are made, and no reason.
TEST(BoundConditions, compare_no_unlike_quantities)
{
    const auto said_of = [](const std::vector<std::string>& names, auto question) {
        QuestionTable table{names, {}};
        Random random(5);
        for (int i = 0; i < 60; ++i) table.numbers.push_back(question(random, i % 2 == 0));
        std::vector<bool> wrong;
        for (int i = 0; i < 60; ++i) wrong.push_back(i % 2 == 0);
        return words(table, wrong);
    };
    const auto one_or_two = [](Random& random, bool less) {
        const double first = 1 + random.below(1000);
        return std::vector<double>{first, less ? first + 0.5 : first - 0.5};
    };
    EXPECT_EQ(said_of({"viewport.width", "viewport.near_depth"}, one_or_two), "nothing");
    EXPECT_EQ(said_of({"hit.t", "material.index"}, one_or_two), "nothing");
    EXPECT_EQ(said_of({"hit.t", "ray.t_max"}, one_or_two), "hit.t is less than ray.t_max");
}

TEST(OneSidedConditions, tell_of_a_bound_where_many_are_wrong)
{
    const QuestionTable table = vectors(6);
    const auto wrong = wrong_where(table, [](const auto& row) { return std::abs(row[6]) > 1e5 && row[3] > 0; });
    const auto condition = one_sided_condition(facts_of(table), wrong);
    ASSERT_TRUE(condition);
    EXPECT_TRUE(sentence_of(*condition).starts_with("wrong only where ")) << sentence_of(*condition);
}

}
}
