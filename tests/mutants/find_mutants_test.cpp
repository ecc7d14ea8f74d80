#include <gtest/gtest.h>

#include <set>

#include "changes.hpp"

namespace umbral::grader::test {
namespace {

std::set<std::string> mutants_of(const std::string& source)
{
    return changes_of([](const auto& parsed) { return find_mutants(parsed); }, source);
}

class Operators : public testing::TestWithParam<ExpectedChanges> {};

TEST_P(Operators, are_found) { expect_found(mutants_of(GetParam().source), GetParam()); }

const std::vector<ExpectedChanges> expected_mutants = {
    {"comparison", "bool f(int a, int b) { return a < b; }", {"comparison: a < b → a <= b"}},
    {"arithmetic",
     "float f(float a, float b) { return a + b / a; }",
     {"arithmetic: a + b / a → a - b / a", "arithmetic: b / a → b * a", "term left out: a + b / a → a"}},
    {"sign", "float f(float a) { return -a; }", {"sign: -a → a"}},
    {"logic", "bool f(bool a, bool b) { return a && !b; }", {"logic: a && !b → a || !b", "logic: !b → b"}},
    {"function",
     "double sin(double); double cos(double); double f(double a) { return sin(a); }",
     {"function: sin(a) → cos(a)"}},
    {"call",
     "float clamp(float, float, float); float f(float a) { return clamp(a, 0, 1); }",
     {"call left out: clamp(a, 0, 1) → a"}},
    {"arguments",
     "int g(int, int); int f(int a, int b) { return g(a, b); }",
     {"arguments exchanged: g(a, b) → g(b, a)"}},
    {"index", "int f(int* a, int i) { return a[i]; }", {"index: a[i] → a[i + 1]"}},
    {"constants",
     "float f() { bool b = true; return b ? 0.5F : 0.0F + 2; }",
     {"constant: true → false", "constant: 0.5F → 0.5F * 2", "constant: 0.0F → 0.0F + 1", "constant: 2 → 2 + 1"}},
    {"precision",
     "float f(double a, double b) { return float(a * b); }",
     {"float for double: a * b → static_cast<double>(static_cast<float>(a * b))"}},
    {"conditions",
     "void g(); void f(int a) { if (a) g(); while (a) { g(); } for (int i = 0; i < a; ++i) { g(); } }",
     {"condition: a → !(a)", "condition: a → true", "condition: a → false", "condition: i < a → false",
      "statement left out: g(); → left out"}},
    {"endings",
     "int f(int a) { if (a) throw 1; a += 2; return a; }",
     {"error not thrown: throw 1; → left out", "statement left out: a += 2; → left out",
      "early return: { → { return {};", "arithmetic: a += 2 → a -= 2"}},
};
INSTANTIATE_TEST_SUITE_P(All, Operators, testing::ValuesIn(expected_mutants),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(FindMutants, leaves_out_what_the_compiler_computes)
{
    EXPECT_TRUE(mutants_of("constexpr int a = 1 + 2; int b[3]; enum { d = 4 };").empty());
    for (const std::string& change : mutants_of("constexpr int f(int x) { return x + 1; }\nint g(int x) { static "
                                                "constexpr int c = 5; switch (x) { case 7: return c; } return x; }"))
        for (const char* constant : {"x + 1", "5", "7"}) EXPECT_EQ(change.find(constant), std::string::npos) << change;
}

TEST(FindMutants, leaves_declarations_whole_but_for_their_arguments)
{
    const std::set<std::string> changes =
        mutants_of("struct V { V(int, int); int x; };\nint f(int a, int b) { V v(a + b, 2); return v.x; }");
    EXPECT_TRUE(changes.contains("arithmetic: a + b → a - b"));
    for (const std::string& change : changes) EXPECT_EQ(change.find("v(a"), std::string::npos) << change;
}

TEST(FindMutants, names_what_cannot_be_parsed) { EXPECT_THROW((void)mutants_of("int f( {"), std::runtime_error); }

}
}
