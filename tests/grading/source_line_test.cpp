#include "explain/source_line.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

TEST(SourceLine, is_taken_without_its_end)
{
    const std::string_view text = "one\r\ntwo\n\nfour";
    EXPECT_EQ(source_line(text, 1), "one");
    EXPECT_EQ(source_line(text, 2), "two");
    EXPECT_EQ(source_line(text, 3), "");
    EXPECT_EQ(source_line(text, 4), "four");
    EXPECT_EQ(source_line(text, 0), std::nullopt);
    EXPECT_EQ(source_line(text, 5), std::nullopt);
}

TEST(SourceLine, equal_returns_of_the_same_function_are_found)
{
    const std::string_view text =
        "int f(int a)\n{\n    if (a < 0) return 0;\n    if (a == 7) return 0;\n    return 1;\n}\n"
        "int g()\n{\n    return 0;\n}\n";
    EXPECT_EQ(equal_returns(text, 3, 16), std::vector<int>{4});
    EXPECT_EQ(equal_returns(text, 4, 17), std::vector<int>{3});
    EXPECT_EQ(equal_returns(text, 5, 5), std::vector<int>{});
    EXPECT_EQ(equal_returns(text, 3, 5), std::vector<int>{}) << "that is the if";
    EXPECT_EQ(equal_returns(text, 3, 0), std::vector<int>{});
    EXPECT_EQ(equal_returns(text, 99, 5), std::vector<int>{});
    EXPECT_EQ(equal_returns(text, 3, 99), std::vector<int>{});
}

TEST(SourceLine, is_shown_if_it_says_what_runs)
{
    for (const char* const line : {"    return t;", "} else if (a < b) {", "else return 1;", "double f() {", "? a : b;",
                                   "std::get<0>(entry)->draw(pipeline);", "classes.push_back(1);", "throw;"})
        EXPECT_TRUE(says_what_runs(line)) << line;
    for (const char* const line : {"", "}", "    });", "} else {", "else", "class Node final : public GraphNode {",
                                   "struct Corner", "  public:", "namespace {", "/", "// nothing"})
        EXPECT_FALSE(says_what_runs(line)) << line;
}

}
}
