#include <gtest/gtest.h>

#include "message_of.hpp"
#include "model/change.hpp"

namespace umbral::grader {
namespace {

const std::string far_root =
    "mistake: returns the far root\n"
    "credit: 10..30\n"
    "hint: The smaller root is\n"
    "  where the ray goes in.\n"
    "---\n"
    "    near\n"
    "+++\n"
    "    far\n"
    "---\n"
    "gone\n"
    "+++\n";

TEST(Change, reads_header_and_steps)
{
    const Change change = parse_change(far_root, "far_root.change");
    EXPECT_EQ(change.header.at("credit"), "10..30");
    EXPECT_EQ(change.header.at("hint"), "The smaller root is where the ray goes in.");
    ASSERT_EQ(change.steps.size(), 2U);
    EXPECT_EQ(change.steps[0].before, "    near");
    EXPECT_EQ(change.steps[0].after, "    far");
    EXPECT_EQ(change.steps[1].before, "gone");
    EXPECT_EQ(change.steps[1].after, "");
}

TEST(Change, changes_what_occurs_once)
{
    EXPECT_EQ(apply_change(parse_change(far_root, ""), "a\n    near\ngone\nb\n", ""), "a\n    far\n\nb\n");
}

TEST(Change, refuses_what_occurs_never_or_twice)
{
    const Change change = parse_change("mistake: m\n---\nx\n+++\ny\n", "");
    EXPECT_NE(test::message_of([&] {
                  (void)apply_change(change, "abc", "m.change");
              }).find("m.change: the text to change does not occur"),
              std::string::npos);
    EXPECT_NE(test::message_of([&] { (void)apply_change(change, "x x", "m.change"); }).find("more than once"),
              std::string::npos);
    // Occurrences that overlap are two.
    EXPECT_NE(test::message_of([&] {
                  (void)apply_change(parse_change("---\naa\n+++\nb\n", ""), "aaa", "");
              }).find("more than once"),
              std::string::npos);
    EXPECT_NE(test::message_of([&] {
                  (void)apply_change(parse_change("---\n+++\nb\n", ""), "a", "");
              }).find("does not occur"),
              std::string::npos);
}

TEST(Change, refuses_halves)
{
    for (const char* text :
         {"", "mistake: m\n", "---\nx\n", "+++\nx\n", "---\nx\n---\ny\n+++\nz\n", "---\nx\n+++\ny\n+++\nz\n"})
        EXPECT_NE(test::message_of([&] { (void)parse_change(text, "m.change"); }).find("m.change"), std::string::npos)
            << text;
}

TEST(SolutionHeader, is_read_from_comments_and_from_plain_lines)
{
    const auto comments =
        solution_header("// mistake: a b\n// hint: c\n//   d: e\n\n#include <cmath>\n// credit: 1..2\n");
    EXPECT_EQ(comments.at("mistake"), "a b");
    EXPECT_EQ(comments.at("hint"), "c d: e");
    EXPECT_FALSE(comments.contains("credit"));
    EXPECT_TRUE(solution_header("int main() {}\n// mistake: no\n").empty());
    EXPECT_TRUE(solution_header("").empty());
}

}
}
