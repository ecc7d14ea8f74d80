#include "text/joined.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace umbral::test {
namespace {

TEST(Joined, words_stand_as_in_a_sentence)
{
    EXPECT_EQ(joined_with_and({}), "");
    EXPECT_EQ(joined_with_and(std::vector<std::string>{"a"}), "a");
    EXPECT_EQ(joined_with_and(std::vector<std::string>{"a", "b"}), "a and b");
    EXPECT_EQ(joined_with_and(std::vector<std::string>{"a", "b", "c"}), "a, b and c");
}

}
}
