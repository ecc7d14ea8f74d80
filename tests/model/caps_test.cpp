#include "model/caps.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace umbral::grader::test {
namespace {

TEST(Caps, one_line_keeps_a_short_text) { EXPECT_EQ(one_line("sphere.cpp"), "sphere.cpp"); }

TEST(Caps, one_line_has_no_line_feed_and_no_control_character)
{
    EXPECT_EQ(one_line("a\nb\tc"), "a b c");
    EXPECT_EQ(one_line(std::string_view("a\x1b[2Jb")), "a\xEF\xBF\xBD[2Jb");
}

TEST(Caps, one_line_is_never_longer_than_its_limit_and_a_mark)
{
    for (const std::string& piece : {std::string("x"), std::string("é"), std::string("\xF0\x9F\x98\x80"),
                                     std::string("\xFF"), std::string(1, '\0')})
        for (std::size_t limit = 1; limit < 40; ++limit) {
            std::string text;
            for (int i = 0; i < 60; ++i) text += piece;
            const std::string line = one_line(text, limit);
            EXPECT_LE(line.size(), limit + 3) << limit;
            EXPECT_TRUE(line.ends_with("…")) << limit;
        }
}

TEST(Caps, a_list_names_the_first_and_counts_the_rest)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < caps::listed; ++i) names.push_back("n");
    EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}), "a, b");
    EXPECT_EQ(listed(names).find("more"), std::string::npos);
    names.resize(1000, std::string(5000, 'x'));
    EXPECT_TRUE(listed(names).ends_with("and 988 more"));
    EXPECT_LT(listed(names).size(), caps::listed * (caps::name + 8) + 32);
}

}
}
