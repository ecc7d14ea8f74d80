#include <gtest/gtest.h>

#include <map>
#include <string>
#include <umbral/record/changes.hpp>
#include <vector>

namespace umbral {
namespace {

enum class Rule { even_odd, nonzero, other };
struct Lamp {
    glm::vec3 place;
    float power;
};
struct Edge {
    std::array<std::uint32_t, 2> ends;
    float length;
};

/// The value as each small change leaves it.
template <class Value>
std::map<std::string, Value> moved(const Value& value)
{
    std::map<std::string, Value> all;
    for (const Change& move : detail::MovesOf<Value>::all) {
        Value changed = value;
        move.make(&changed);
        EXPECT_TRUE(all.emplace(move.name, changed).second) << move.name << " stands twice in the list";
        EXPECT_TRUE(std::string(move.name).starts_with("moved"));
    }
    return all;
}

TEST(Moves, of_single_values_change_them)
{
    EXPECT_EQ(moved(16.0F).at("moved"), 17);
    EXPECT_EQ(moved(0.0).at("moved"), 1.0 / 16);
    EXPECT_EQ(moved(7).at("moved"), 8);
    EXPECT_EQ(moved(std::uint8_t{255}).at("moved"), 255) << "never another number by wrapping";
    EXPECT_EQ(moved(true).at("moved"), false);
    EXPECT_EQ(moved(Rule::nonzero).at("moved"), Rule::other);
    EXPECT_EQ(moved(Rule::other).at("moved"), Rule::even_odd);
}

TEST(Moves, of_vectors_change_a_component_the_length_or_the_direction)
{
    const glm::vec3 v(16, 0, -32);
    const auto of = moved(v);
    EXPECT_EQ(of.size(), 5U);
    EXPECT_EQ(of.at("moved .x"), glm::vec3(17, 0, -32));
    EXPECT_EQ(of.at("moved .y"), glm::vec3(16, 1.0F / 16, -32));
    EXPECT_EQ(of.at("moved length"), glm::vec3(17, 0, -34));
    EXPECT_NEAR(glm::length(of.at("moved direction")), glm::length(v), 1e-5);
    EXPECT_GT(glm::distance(of.at("moved direction"), v), 1);
    EXPECT_EQ(moved(glm::ivec2(1, 2)).at("moved .y"), glm::ivec2(1, 3));
    EXPECT_FALSE(moved(glm::ivec2(1, 2)).contains("moved length"));
}

TEST(Moves, of_matrices_change_an_entry_or_turn_the_whole)
{
    const auto of = moved(glm::mat3(1));
    EXPECT_EQ(of.size(), 10U);
    glm::mat3 entry(1);
    entry[2][1] = 1.0F / 16;
    EXPECT_EQ(of.at("moved [2][1]"), entry);
    const glm::mat3& turned = of.at("moved");
    EXPECT_NE(turned, glm::mat3(1));
    EXPECT_NEAR(glm::determinant(turned), 1, 1e-6);
    EXPECT_NEAR(glm::length(turned[0]), 1, 1e-6);
}

TEST(Moves, of_lists_change_an_element_or_the_order)
{
    using List = std::vector<glm::vec2>;
    const auto of = moved(List{{16, 32}, {0, 64}});
    EXPECT_EQ(of.at("moved [1]"), (List{{16, 32}, {1.0F / 16, 68}}));
    EXPECT_EQ(of.at("moved [5]"), (List{{16, 32}, {0, 64}})) << "there is none";
    EXPECT_EQ(of.at("moved order"), (List{{0, 64}, {16, 32}}));
    const std::vector<Lamp> lamps{{{1, 0, 0}, 1}, {{2, 0, 0}, 2}};
    EXPECT_EQ(moved(lamps).at("moved order").front().power, 2);
    EXPECT_TRUE(moved(std::vector<Edge>{{{0, 1}, 2}}).empty()) << "what means others by their numbers";
    EXPECT_TRUE(moved(std::vector<int>{1, 2}).empty());
}

}
}
