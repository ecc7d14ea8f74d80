#include "question/lost_rows.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

using Rows = std::vector<std::vector<double>>;

const std::vector<std::string> names{"edge.a", "edge.b"};

/// All edges of a fan of n triangles round vertex 0, and those of them that `is_kept`.
template <class IsKept>
RowsOfCall fan(int n, IsKept is_kept)
{
    RowsOfCall call;
    const auto add = [&](double a, double b) {
        call.expected.push_back({a, b});
        if (is_kept(a, b)) call.yours.push_back({a, b});
    };
    for (int i = 1; i <= n; ++i) {
        add(0, i);
        add(i, i + 1);
    }
    return call;
}

std::string told(const std::vector<RowsOfCall>& calls, Side side)
{
    const auto condition = condition_of_alone(told_rows(calls, side, names));
    return condition ? sentence_of_alone(side, *condition) : "";
}

TEST(LostRows, what_those_that_lack_have_in_common)
{
    const auto kept = [](double a, double /*b*/) { return a != 0; };
    EXPECT_EQ(told({fan(5, kept), fan(3, kept)}, Side::expected),
              "a row is lacking wherever edge.a is 0 (8 of 8), and there everywhere else (8 of 8)");
    EXPECT_EQ(told({fan(5, kept), fan(3, kept)}, Side::yours), "");
}

TEST(LostRows, what_those_that_are_too_many_have_in_common)
{
    RowsOfCall call = fan(6, [](double, double) { return true; });
    for (double i = 1; i <= 5; ++i) call.yours.push_back({i, i});
    EXPECT_EQ(told({call}, Side::yours),
              "a row is too much wherever edge.a is equal to edge.b (5 of 5), and right everywhere "
              "else (12 of 12)");
}

TEST(LostRows, each_has_a_partner_of_its_own)
{
    const RowsOfCall call{{{1, 2}, {1, 2}, {3, 4}}, {{3, 4.0000001}, {1, 2}}};
    EXPECT_EQ(told_rows({call}, Side::yours, names).alone, (std::vector<bool>{false, true, false}));
    EXPECT_EQ(told_rows({call}, Side::expected, names).alone, (std::vector<bool>{false, false}));
    const RowsOfCall other{{{1, 2}}, {}};
    EXPECT_EQ(told_rows({call, other}, Side::yours, names).alone, (std::vector<bool>{false, true, false, true}))
        << "of the same call";
}

TEST(LostRows, few_or_scattered_ones_have_nothing_in_common)
{
    EXPECT_EQ(told({fan(3, [](double a, double) { return a != 0; })}, Side::expected), "") << "three are few";
    int i = 0;
    const auto kept = [&](double, double) { return i++ * 7 % 5 < 3; };
    EXPECT_EQ(told({fan(9, kept), fan(12, kept)}, Side::expected), "");
}

}
}
