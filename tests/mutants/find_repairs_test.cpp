#include <gtest/gtest.h>

#include "changes.hpp"

namespace umbral::grader::test {
namespace {

std::set<std::string> repairs_of(const std::string& source)
{
    return changes_of([](const auto& parsed) { return find_repairs(parsed); }, source);
}

class Repairs : public testing::TestWithParam<ExpectedChanges> {};

TEST_P(Repairs, are_found) { expect_found(repairs_of(GetParam().source), GetParam()); }

const std::vector<ExpectedChanges> expected_repairs = {
    {"sign",
     "float g(float); float f(float a) { return g(a) * 2.5F; }",
     {"sign: a → -(a)", "sign: g(a) → -(g(a))", "sign: 2.5F → -2.5F"}},
    {"comparison",
     "bool f(int a, int b) { return a < b; }",
     {"comparison: a < b → a > b", "comparison: a < b → a <= b"}},
    {"component",
     "struct V { float x, y, z; }; float f(V v) { return v.x; }",
     {"component: v.x → v.y", "component: v.x → v.z"}},
    {"variable", "float f(float a, float b, float c) { return c; }", {"variable: c → a", "variable: c → b"}},
    {"limited",
     "float f(float a, float b) { return a - b; }",
     {"limited: a - b → ((a - b) < 0 ? 0 * (a - b) : (a - b))", "limited: a - b → std::abs(a - b)",
      "factor: a - b → (a - b) * 0.5F"}},
    {"integers",
     "int f(int a, int* list) { return list[a * 2 + 1]; }",
     {"one more or less: a * 2 + 1 → (a * 2 + 1) - 1", "constant: 1 → 1 - 1",
      "index: list[a * 2 + 1] → list[a * 2 + 1 - 1]"}},
    {"casts",
     "float f(int a, float b) { return static_cast<float>(a) * static_cast<float>(static_cast<int>(b)); }",
     {"half: static_cast<float>(a) → static_cast<float>(a) + 0.5F",
      "rounding: static_cast<int>(b) → static_cast<int>(std::floor(b))"}},
    {"angles",
     "float sin(float); float f(float a) { return sin(a); }",
     {"angle: a → glm::radians(a)", "angle: a → 0.5F * (a)", "angle: a → 2 * (a)"}}};

INSTANTIATE_TEST_SUITE_P(All, Repairs, testing::ValuesIn(expected_repairs),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Repairs, are_no_changes_that_only_break_and_none_twice)
{
    const std::set<std::string> found =
        repairs_of("struct V { float x, y; }; float f(V v, int n) { float a = v.x; a += 1; return a < 2 ? a : v.y; }");
    for (const std::string& change : found) {
        EXPECT_FALSE(change.starts_with("early return")) << change;
        EXPECT_FALSE(change.starts_with("kept answer")) << change;
    }
    const umbral::test::TemporaryFolder folder;
    const std::string file = folder.path() / "source.cpp";
    std::ofstream(file) << "struct V { float x, y; }; float f(V v) { return v.x * v.y; }";
    std::set<std::string> all;
    for (const Mutant& mutant : find_repairs(parse(file, {"-std=c++20"})))
        EXPECT_TRUE(all.insert(std::to_string(mutant.begin) + mutant.change).second) << mutant.change;
}

// `(b ? -(a) : a) = 1` is no C++.
TEST(Repairs, leave_alone_what_is_written_to)
{
    for (const std::string& change : repairs_of("void f(float& a, float b) { a = b; a += b; }"))
        EXPECT_NE(change, "sign: a → -(a)");
}

}
}
