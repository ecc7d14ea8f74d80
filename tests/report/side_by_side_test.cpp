#include "report/side_by_side.hpp"
#include "report/next_steps.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

TEST(SideBySide, finds_matrices_and_their_differences)
{
    EXPECT_FALSE(find_matrix("4.5"));
    EXPECT_FALSE(find_matrix("[1 2 3]")) << "a vector stays a text";
    EXPECT_FALSE(find_matrix("[1 2; 3]"));
    EXPECT_FALSE(find_matrix("][;"));
    EXPECT_EQ(find_matrix("5 in [1 2; 3 nan]"), (MatrixText{{"1", "2"}, {"3", "nan"}}));
    const auto differs = differing_entries({{"1", "2.0001"}, {"nan", "9"}}, {{"1", "2"}, {"0", "4"}});
    EXPECT_EQ(differs, (std::vector<std::vector<bool>>{{false, false}, {true, true}}))
        << "a thousandth of the largest difference is noise";
    const auto same = differing_entries({{"1", "nan"}, {"0", "0"}}, {{"1", "nan"}, {"0", "0"}});
    EXPECT_EQ(same, (std::vector<std::vector<bool>>{{false, false}, {false, false}}));
}

TEST(SideBySide, shell_words_are_one_word)
{
    EXPECT_EQ(shell_word("raytracing/sphere"), "raytracing/sphere");
    EXPECT_EQ(shell_word("far away"), "'far away'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word("$(rm)"), "'$(rm)'");
    EXPECT_EQ(shell_word(""), "''");
}

}
}
