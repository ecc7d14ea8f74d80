#include <gtest/gtest.h>

#include <set>

#include "changes.hpp"

namespace umbral::grader::test {
namespace {

std::set<std::string> slips_of(const std::string& source)
{
    return changes_of([](const auto& parsed) { return find_slips(parsed); }, source);
}

class Slips : public testing::TestWithParam<ExpectedChanges> {};

TEST_P(Slips, are_found) { expect_found(slips_of(GetParam().source), GetParam()); }

const std::vector<ExpectedChanges> expected_slips = {
    {"tolerance",
     "bool f(float a, float b) { return a < b || a == 0; }",
     {"tolerance: a < b → a + 1e-4F < b", "tolerance: a < b → a - 1e-4F < b",
      "tolerance: a == 0 → std::abs((a) - (0)) < 1e-4F"}},
    {"component", "struct V { float x, y; }; float f(V v) { return v.x; }", {"component: v.x → v.y"}},
    {"field",
     "struct View { int width; float near; int height; }; int f(View v) { return v.width - v.height; }",
     {"field: v.width → v.height", "field: v.height → v.width"}},
    {"variable",
     "float f(float a, int n, float b) { float c = a; return b - c; }",
     {"variable: a → b", "variable: b → c", "variable: c → b"}},
    {"limited",
     "float f(float a) { return a * 3; }",
     {"limited: a * 3 → std::abs(a * 3)", "limited: a * 3 → ((a * 3) > 1 ? 0 * (a * 3) + 1 : (a * 3))"}},
    {"loop",
     "int f(int n) { int sum = 0; for (int i = 0; i < n; ++i) sum += i; return sum; }",
     {"last left out: i < n → i + 1 < n"}},
    {"order", "int f(int a, int b) { a += b; b *= a; return b; }", {"order: a += b; b *= a; → b *= a; a += b;"}},
    {"kept",
     "struct List { int n; }; int f(List list, int k) { return list.n + k; }",
     {"kept answer: f(list, k) → what it answered to arguments of the same sizes and numbers"}},
};
INSTANTIATE_TEST_SUITE_P(All, Slips, testing::ValuesIn(expected_slips),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(FindSlips, changes_nothing_that_would_be_the_same)
{
    // Statements that do not depend on each other, whole numbers, variables of other types, functions of numbers and
    // enumerators alone.
    EXPECT_EQ(slips_of("int f(int a, double b) { int c; a += 1; c = 2; return a < c ? a : c; }"),
              (std::set<std::string>{"variable: a → c", "variable: c → a"}));
    EXPECT_EQ(slips_of("enum class Kind { one, two }; int f(Kind kind, const Kind& other) { return kind == other; }"),
              (std::set<std::string>{"variable: kind → other", "variable: other → kind"}));
}

TEST(FindSlips, a_loops_head_keeps_its_variables)
{
    EXPECT_EQ(slips_of("int f(int n) { int k = 0; for (int i = 0; i < n; ++i) ++k; return k; }"),
              (std::set<std::string>{"last left out: i < n → i + 1 < n", "variable: k → i", "variable: k → n"}));
}

}
}
