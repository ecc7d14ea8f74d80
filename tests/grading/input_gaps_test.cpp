#include "validate/input_gaps.hpp"

#include <gtest/gtest.h>

// What a unit's functions are never asked.
namespace umbral::grader {
namespace {

/// What is said of these gaps, or "" if that is none.
std::string where(const std::vector<InputGap>& gaps, const std::string& what)
{
    std::string text;
    for (const InputGap& gap : gaps)
        if (gap.what == what)
            for (const std::string& one : gap.where) text += (text.empty() ? "" : ", ") + one;
    return text;
}

CallsOfFunction calls_of(const std::vector<std::string>& names, const std::vector<std::size_t>& arguments,
                         std::vector<std::vector<double>> calls)
{
    CallsOfFunction made{{}, {std::move(calls)}};
    for (std::size_t i = 0; i < names.size(); ++i)
        made.numbers.push_back({names[i], arguments[i], false, names[i].starts_with("the ")});
    return made;
}

TEST(InputGaps, of_numbers)
{
    const auto gaps = input_gaps(calls_of({"e", "t"}, {0, 1}, {{2, 0}, {1, -0.5}, {30.5, 0.5}}));
    EXPECT_EQ(where(gaps, "never between 0 and 1"), "e");
    EXPECT_EQ(where(gaps, "never 0"), "e");
    EXPECT_EQ(where(gaps, "never negative"), "e");
    EXPECT_EQ(where(input_gaps(calls_of({"e", "t"}, {0, 1}, {{2, 0}, {2, 1}})), "always the same"), "e");
    EXPECT_TRUE(input_gaps(calls_of({"e"}, {0}, {})).empty());
    CallsOfFunction after_none = calls_of({"e"}, {0}, {{2}, {2}});
    after_none.runs.insert(after_none.runs.begin(), {{}, {}});
    EXPECT_EQ(where(input_gaps(after_none), "always the same"), "e");
}

TEST(InputGaps, counts_of_what_came_before_are_no_inputs)
{
    const std::string steps = "the number of steps of the wheel until then";
    const auto gaps = input_gaps(calls_of({"e", "t", steps}, {0, 1, 2}, {{2, 0, 1}, {1, -0.5, 1}, {30.5, 0.5, 1}}));
    for (const InputGap& gap : gaps)
        for (const std::string& one : gap.where) EXPECT_EQ(one.find("wheel"), std::string::npos) << gap.what;
}

TEST(InputGaps, of_vectors)
{
    const std::vector<std::string> names{"a.x", "a.y", "a.z", "b.x", "b.y", "b.z"};
    const std::vector<std::size_t> arguments{0, 0, 0, 1, 1, 1};
    const auto gaps = input_gaps(calls_of(names, arguments, {{0, 1, 2, 1, 1, 0}, {1, 1, 2, 1, 2, 2}}));
    EXPECT_EQ(where(gaps, "never 0 beside others that are not"), "a.yz, b.xy");
    EXPECT_EQ(where(gaps, "never equal"), "a = b");
    const auto equal = input_gaps(calls_of(names, arguments, {{0, 1, 2, 0, 1, 2}, {1, 1, 2, 1, 2, 2}}));
    EXPECT_EQ(where(equal, "never equal"), "");
}

TEST(InputGaps, of_lists)
{
    const auto gaps = input_gaps(calls_of({"list.size()", "the number of different elements in list"}, {0, 0},
                                          {{0, 0}, {1, 1}, {3, 3}, {5, 5}}));
    EXPECT_EQ(where(gaps, "never of 2 elements"), "list.size()");
    EXPECT_EQ(where(gaps, "never of 1 elements"), "");
    EXPECT_EQ(where(gaps, "never with equal elements"), "list");
}

// A code that an answer is kept by: of the eye alone, it is found out; of all but the window, it is not.
TEST(InputGaps, of_calls_after_each_other)
{
    const auto gaps = input_gaps(
        calls_of({"point", "eye", "window"}, {0, 1, 2}, {{1, 5, 7}, {2, 5, 7}, {2, 5, 7}, {3, 6, 7}, {4, 6, 8}}));
    EXPECT_EQ(where(gaps, "never the same as in the call before, beside others that differ"), "point");
    EXPECT_EQ(where(gaps, "never the only one that differs from the call before"), "eye, window");
    const auto of_one = input_gaps(calls_of({"turn.axis", "turn.degrees"}, {0, 0}, {{1, 5}, {2, 6}, {2, 7}}));
    EXPECT_EQ(where(of_one, "never the only one that differs from the call before"), "turn.axis");
}

// Of many calls, a few are hardly ever.
TEST(InputGaps, are_counted_where_they_are_rare)
{
    std::vector<std::vector<double>> calls(500, std::vector<double>{1});
    calls[3] = {0};
    calls[7] = {-1};
    for (std::size_t i = 8; i < 20; ++i) calls[i] = {-2};
    const auto gaps = input_gaps(calls_of({"count"}, {0}, std::move(calls)));
    EXPECT_EQ(where(gaps, "never 0"), "count (1 of 500)");
    EXPECT_EQ(where(gaps, "never negative"), "");
}

}
}
