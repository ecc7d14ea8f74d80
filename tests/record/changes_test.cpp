#include <gtest/gtest.h>

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

}
}
