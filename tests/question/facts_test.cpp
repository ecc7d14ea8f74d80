#include "question/facts.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "question/possible_conditions.hpp"
#include "question/quantity.hpp"

namespace umbral::grader {
namespace {

TEST(Facts, measure_no_distance_between_a_place_and_a_direction)
{
    EXPECT_EQ(quantity_of("ray.direction"), Quantity::direction);
    EXPECT_EQ(quantity_of("camera.fovy_degrees"), Quantity::angle);
    EXPECT_EQ(quantity_of("the right answer"), Quantity::unknown);
    EXPECT_EQ(quantity_of("group.size"), Quantity::unknown);
    QuestionTable table{{"ray.origin.x", "ray.origin.y", "ray.direction.x", "ray.direction.y"}, {{1, 2, 3, 4}}};
    for (const Fact& fact : facts_of(table))
        EXPECT_EQ(fact.words.find("the distance"), std::string::npos) << fact.words;
}

TEST(PossibleConditions, say_nearly_of_what_is_so_but_for_a_little)
{
    const auto said = [](double sine) {
        std::set<std::string> words;
        const std::vector<Fact> facts{{.words = "u and v", .kind = Fact::Kind::parallel, .values = {sine, 0.5}}};
        for (const PossibleCondition& one : possible_conditions(facts, {true, false})) words.insert(one.words);
        return words;
    };
    EXPECT_TRUE(said(0).contains("u and v are parallel"));
    EXPECT_TRUE(said(1e-6).contains("u and v are parallel, or nearly"));
    EXPECT_TRUE(said(1).contains("u and v are perpendicular"));
    EXPECT_TRUE(said(1 - 1e-12).contains("u and v are perpendicular, or nearly"));
}

TEST(Facts, know_which_way_round_three_corners_go_and_what_mirrors)
{
    QuestionTable table{{"area", "t.a.x", "t.a.y", "t.b.x", "t.b.y", "t.c.x", "t.c.y"}, {}};
    table.numbers = {{1, 0, 0, 2, 0, 0, 3}, {1, 0, 0, 0, 3, 2, 0}};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) table.names.push_back(fmt::format("m[{}][{}]", column, row));
    for (const double entry : {0.0, 2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 3.0}) table.numbers[0].push_back(entry);
    for (const double entry : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0}) table.numbers[1].push_back(entry);
    const std::vector<Fact> facts = facts_of(table);
    const auto values = [&](const std::string& words) {
        const auto found = std::ranges::find(facts, words, &Fact::words);
        return found == facts.end() ? std::vector<double>() : found->values;
    };
    EXPECT_EQ(values("the signed area of t.a, t.b and t.c"), (std::vector<double>{6, -6}));
    ASSERT_EQ(values("the determinant of m").size(), 2U);
    EXPECT_EQ(values("the determinant of m")[0], -6);
    EXPECT_NEAR(values("the determinant of m")[1], -3, 1e-12);
}

TEST(Facts, know_which_way_round_three_vectors_of_different_owners_stand)
{
    const auto determinants = [](const std::vector<std::string>& vectors) {
        QuestionTable table{{}, {{}}};
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                table.names.push_back(fmt::format("{}.{}", vectors[i], "xyz"[axis]));
                table.numbers[0].push_back(axis == (i + 1) % 3 ? 2 : 0);
            }
        std::map<std::string, double> found;
        for (const Fact& fact : facts_of(table))
            if (fact.words.starts_with("the determinant")) found[fact.words] = fact.values[0];
        return found;
    };
    const auto found = determinants({"n", "tangents.u", "tangents.v"});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.begin()->first, "the determinant of n, tangents.u and tangents.v");
    EXPECT_EQ(found.begin()->second, 8);
    EXPECT_EQ(determinants({"n", "light.color", "view"}).size(), 0U);
    EXPECT_EQ(determinants({"a", "b", "c", "d", "e"}).size(), 0U) << "more than anybody thinks of";
}

TEST(Facts, know_lengths_products_and_parallel_vectors)
{
    const QuestionTable table{{"u.x", "u.y", "v.x", "v.y", "m[0][0]"}, {{3, 4, 6, 8, 1}, {1, 0, 0, 2, 1}}};
    std::map<std::string, Fact> facts;
    for (const Fact& fact : facts_of(table)) facts[fact.words] = fact;
    EXPECT_EQ(facts.at("the length of u").values, (std::vector<double>{5, 1}));
    EXPECT_EQ(facts.at("dot(u, v)").values, (std::vector<double>{50, 0}));
    EXPECT_EQ(facts.at("the distance between u and v").values[0], 5);
    EXPECT_EQ(facts.at("u and v").values, (std::vector<double>{0, 1}));
    EXPECT_TRUE(facts.at("u.x").component);
    EXPECT_TRUE(facts.at("m[0][0]").component);
}

}
}
