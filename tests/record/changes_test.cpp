#include <gtest/gtest.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <umbral/record/changes.hpp>
#include <vector>

namespace umbral {
namespace {

/// The value as each way to misunderstand it has it.
template <class Value>
std::map<std::string, Value> misunderstood(const Value& value)
{
    std::map<std::string, Value> all;
    for (const Change& change : detail::ChangesOf<Value>::all) {
        Value changed = value;
        change.make(&changed);
        EXPECT_TRUE(all.emplace(change.name, changed).second) << change.name << " stands twice in the list";
    }
    return all;
}

TEST(Changes, of_numbers)
{
    const auto of = misunderstood(1.75);
    EXPECT_EQ(of.at("negated"), -1.75);
    EXPECT_EQ(of.at("subtracted from 1"), -0.75);
    EXPECT_EQ(of.at("replaced by its reciprocal"), 1 / 1.75);
    EXPECT_EQ(of.at("limited to [0, 1]"), 1);
    EXPECT_EQ(of.at("rounded towards 0"), 1);
    EXPECT_EQ(misunderstood(-1.75F).at("rounded towards 0"), -1);
}

TEST(Changes, of_vectors)
{
    const glm::vec3 v(0.5F, -2.5F, 1.25F);
    const auto of = misunderstood(v);
    EXPECT_EQ(of.at("with y subtracted from 1"), glm::vec3(0.5F, 3.5F, 1.25F));
    EXPECT_EQ(of.at("limited to [0, 1]"), glm::vec3(0.5F, 0, 1));
    EXPECT_EQ(of.at("rounded towards 0"), glm::vec3(0, -2, 1));
    EXPECT_EQ(of.at("with z negated"), glm::vec3(0.5F, -2.5F, -1.25F));
    EXPECT_EQ(of.at("with y taken as x"), glm::vec3(0.5F, 0.5F, 1.25F));
    EXPECT_EQ(of.at("with z taken as y"), glm::vec3(0.5F, -2.5F, -2.5F));
    EXPECT_EQ(misunderstood(glm::ivec2(1, 2)).at("with x taken as y"), glm::ivec2(2, 2));
    EXPECT_FALSE(misunderstood(glm::vec2(v)).contains("with z taken as y"));
    EXPECT_FALSE(misunderstood(glm::vec2(v)).contains("with z negated"));
    EXPECT_FALSE(misunderstood(glm::ivec3(1, 2, 3)).contains("negated"));
}

TEST(Changes, of_lists)
{
    using List = std::vector<float>;
    const auto of = misunderstood(List{1, 2, 3});
    EXPECT_EQ(of.at("in reverse order"), (List{3, 2, 1}));
    EXPECT_EQ(of.at("without its first element"), (List{2, 3}));
    EXPECT_EQ(of.at("beginning with its second element, the first one last"), (List{2, 3, 1}));
    EXPECT_EQ(of.at("with its last element twice"), (List{1, 2, 3, 3}));
    EXPECT_EQ(of.at("with its first element at its end as well"), (List{1, 2, 3, 1}));
    const std::vector<glm::uvec3> triangle{{0, 1, 2}};
    EXPECT_EQ(misunderstood(triangle).at("with each triangle turned round").front(), glm::uvec3(0, 2, 1));
}

TEST(Changes, of_empty_lists_are_bearable)
{
    for (const auto& [name, list] : misunderstood(std::vector<glm::vec2>{})) EXPECT_TRUE(list.empty()) << name;
}

struct Paint {
    glm::vec3 diffuse;
    glm::vec3 specular;
    float shininess;
};
struct Wall {
    std::vector<Paint> coats;
    Paint front;
    Paint back;
};

std::vector<Part> parts_of(Wall& wall)
{
    std::vector<Part> parts;
    add_parts(Place{0}, wall, parts);
    return parts;
}

Wall wall() { return {{{{1, 1, 1}, {2, 2, 2}, 3}}, {{4, 4, 4}, {5, 5, 5}, 6}, {{7, 7, 7}, {8, 8, 8}, 9}}; }

const std::string paint(reflect::type_name<Paint>());

TEST(Changes, of_one_part_for_another_are_asked_among_parts_of_one_type)
{
    Wall one = wall();
    const std::vector<OtherQuestion> all = other_questions("f", parts_of(one));
    const auto has = [&](const OtherQuestion& question) { return std::ranges::find(all, question) != all.end(); };
    EXPECT_TRUE(has({"f", "0.front.specular", "taken as", "0.front.diffuse"}));
    EXPECT_TRUE(has({"f", "0.front.diffuse", "taken as", "0.front.specular"}));
    EXPECT_TRUE(has({"f", "0.front.diffuse", "taken as", "0.back.diffuse"}));
    EXPECT_TRUE(has({"f", "0.front", "taken as", "0.back"}));
    EXPECT_TRUE(has({"", paint + ".specular", "taken as", paint + ".diffuse"}));
    EXPECT_FALSE(has({"f", "0.front.diffuse", "taken as", "0.front.shininess"}));
    EXPECT_FALSE(has({"f", "0.front.diffuse", "taken as", "0.front.diffuse"}));
    EXPECT_FALSE(has({"f", "0.coats.diffuse", "taken as", "0.coats.specular"})) << "one of many";
}

TEST(Changes, take_one_part_for_another_wherever_it_is_meant)
{
    Wall one = wall();
    AskedInstead({"f", "0.front.specular", "taken as", "0.back.diffuse"}).change("f", parts_of(one));
    EXPECT_EQ(one.front.specular, glm::vec3(7));
    EXPECT_EQ(one.front.diffuse, glm::vec3(4));
    EXPECT_EQ(one.back.diffuse, glm::vec3(7));
    Wall other = wall();
    AskedInstead({"", paint + ".specular", "taken as", paint + ".diffuse"}).change("any", parts_of(other));
    EXPECT_EQ(other.coats[0].specular, glm::vec3(1));
    EXPECT_EQ(other.front.specular, glm::vec3(4));
    EXPECT_EQ(other.back.specular, glm::vec3(7));
    EXPECT_EQ(other.back.diffuse, glm::vec3(7));
}

TEST(Changes, find_their_part_behind_lists_of_all_lengths)
{
    AskedInstead doubled({"f", "0.back.shininess", "doubled", ""});
    for (const std::size_t coats : {1, 3, 0, 2}) {
        Wall one = wall();
        one.coats.resize(coats, Paint{});
        doubled.change("f", parts_of(one));
        EXPECT_EQ(one.back.shininess, 18);
        EXPECT_EQ(one.front.shininess, 6);
    }
}

TEST(Changes, of_several_functions_are_made_in_each)
{
    AskedInstead both({"f", "0.front.shininess", "doubled", "", {{"g", "0.back.shininess"}}});
    EXPECT_TRUE(both.means("f") && both.means("g"));
    EXPECT_FALSE(both.means("h"));
    Wall one = wall();
    both.change("f", parts_of(one));
    EXPECT_EQ(one.front.shininess, 12);
    EXPECT_EQ(one.back.shininess, 9);
    both.change("g", parts_of(one));
    EXPECT_EQ(one.front.shininess, 12);
    EXPECT_EQ(one.back.shininess, 18);
}

}
}
