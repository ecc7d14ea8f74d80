#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <umbral/record/features.hpp>
#include <vector>

namespace umbral {
namespace {

template <class Value>
Features features_of(const Value& value)
{
    Features features;
    add_features(Place{}, value, features);
    return features;
}

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;

TEST(Features, of_lists_count_different_elements)
{
    const Features corners = features_of(std::vector<glm::vec2>{{0, 2}, {-0.0F, 2}, {3, 1}, {0, 2}});
    EXPECT_EQ(corners.names, (Names{"0.size()", "the number of different elements in 0", "the least number in 0",
                                    "the largest number in 0"}));
    EXPECT_EQ(corners.values, (Numbers{4, 2, 0, 3}));
    EXPECT_EQ(features_of(std::vector<float>()).values, (Numbers{0, 0, 0, 0}));
    EXPECT_EQ(features_of(std::vector{std::nanf("1"), std::nanf("2")}).values[1], 1);
}

// Of those that are not looked at nothing is known: they are not said to be equal.
TEST(Features, of_long_lists_count_what_was_looked_at)
{
    std::vector<float> numbers(3 * most_numbers_of_list);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i);
    EXPECT_EQ(features_of(numbers).values[1], static_cast<double>(numbers.size()));
    numbers[1] = 0;
    EXPECT_EQ(features_of(numbers).values[1], static_cast<double>(numbers.size() - 1));
}

TEST(Features, of_lists_of_lists_tell_how_long_these_are)
{
    const Features strips = features_of(std::vector<std::vector<int>>{{4, 1, 2}, {7, 8}, {0, 1, 2, 3, 4}});
    EXPECT_EQ(strips.names, (Names{"0.size()", "the number of different elements in 0", "the least number in 0",
                                   "the largest number in 0", "the length of the shortest list in 0",
                                   "the length of the longest list in 0"}));
    EXPECT_EQ(strips.values, (Numbers{3, 3, 0, 8, 2, 5}));
    EXPECT_EQ(features_of(std::vector<std::vector<int>>()).values, (Numbers{0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(features_of(std::vector<std::string>{"a"}).values.size(), 4U) << "texts are no lists";
}

TEST(Features, of_short_arrays_are_those_of_their_elements)
{
    const Features triangle = features_of(std::array<glm::vec2, 3>{{{1, 2}, {3, 4}, {5, 6}}});
    EXPECT_EQ(triangle.names, (Names{"0[0].x", "0[0].y", "0[1].x", "0[1].y", "0[2].x", "0[2].y"}));
    EXPECT_EQ(triangle.values, (Numbers{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(features_of(std::array<float, 5>{}).names.front(), "0.size()");
}

}
}
