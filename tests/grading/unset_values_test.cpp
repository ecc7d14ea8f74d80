#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "spoilt_reference.hpp"

// Values that were never set are never right by chance, and are told as what they are.
namespace umbral::grader::test {
namespace {

class UnsetValues : public SpoiltReference {
protected:
    /// The reference, in which the discriminant is multiplied by `factor`, which `statements` make.
    UnitResult grade(const std::string& statements, const std::string& factor)
    {
        const std::string begin = "const float discriminant = a *";
        GradeOptions options;
        options.questions = false;
        return SpoiltReference::grade(begin, statements + "\n    const float discriminant = " + factor + " * a *",
                                      options);
    }
    static bool is_told(const UnitResult& result)
    {
        return !result.explanations.empty() && result.explanations.front().name == "uninitialized";
    }
};

TEST_F(UnsetValues, lose_points_and_are_told)
{
    const std::vector<std::pair<std::string, std::string>> ways = {
        {"float sum; for (int i = 0; i < 4; ++i) sum += 0.25F;", "sum"},
        {"float one; if (b > 0) one = 1;", "one"},
        {"double one; switch (int(b) % 3) { case 0: one = 1; break; case 1: one = 1; }", "float(one)"},
        {"struct Factors { float one; bool set = false; } f; if (b > 0) f.one = 1;", "f.one"},
        {"struct Factors { Factors() {} float one; } f; if (b > 0) f.one = 1;", "f.one"},
        {"const auto make = [&] { struct Factors { Factors() {} float one; } f; if (b > 0) f.one = 1; return f; };",
         "make().one"},
        {"glm::vec3 ones; if (b > 0) ones = glm::vec3(1);", "ones.y"},
        {"float ones[3]; if (b > 0) ones[2] = 1;", "ones[2]"},
        {"auto* ones = new float[40]; if (b > 0) ones[9] = 1; const float one = ones[9]; delete[] ones;", "one"},
        {"std::vector<float> ones(1, 1.0F); const float& one = ones[0]; if (b < 0) ones.resize(99);", "one"},
    };
    for (const auto& [statements, factor] : ways) {
        const UnitResult result = grade(statements, factor);
        EXPECT_LT(result.score, result.max_score) << statements;
        EXPECT_TRUE(is_told(result)) << statements << '\n'
                                     << (result.explanations.empty() ? "" : result.explanations.front().name);
    }
}

TEST_F(UnsetValues, are_named_where_the_compiler_sees_them)
{
    const UnitResult result = grade("float sum; for (int i = 0; i < 4; ++i) sum += 0.25F;", "sum");
    ASSERT_TRUE(is_told(result));
    EXPECT_NE(result.message.find("g++: sphere.cpp:"), std::string::npos) << result.message;
    EXPECT_NE(result.message.find(" uninitialized\n"), std::string::npos) << result.message;
}

// A submission can have the compiler say what it likes, in lines that look like these.
TEST_F(UnsetValues, are_quoted_in_the_compilers_own_words_only)
{
    for (const std::string line : {"#warning uninitialized: 10 of 10 points", "#line 7 \"10 of 10 points\""}) {
        const UnitResult result = grade("float sum;\n" + line + "\n for (int i = 0; i < 4; ++i) sum += 0.25F;", "sum");
        EXPECT_TRUE(is_told(result)) << line;
        EXPECT_EQ(result.message.find("10 of 10"), std::string::npos) << result.message;
    }
}

TEST_F(UnsetValues, are_told_of_no_other_wrong_work)
{
    EXPECT_FALSE(is_told(grade("", "2.0F")));
    EXPECT_FALSE(is_told(grade("const float zero = 0;", "(b > 0 ? 1 : 1 / zero)")));
    // A crash has its own words.
    EXPECT_FALSE(is_told(grade("if (b < 0) *static_cast<volatile int*>(nullptr) = 1;", "1.0F")));
}

TEST_F(UnsetValues, that_decide_nothing_cost_nothing)
{
    const UnitResult result = grade("float other; float one = 1; if (b > 1e30F) { other = 2; one = other; }", "one");
    EXPECT_EQ(result.score, result.max_score);
}

// g++ 12 fills padding in the wrong place where a value holds an array of structs and padding behind it
// (build/padding_fault.hpp): right work stays right.
TEST_F(UnsetValues, are_not_made_of_values_that_were_set)
{
    const UnitResult result = grade(
        "struct Joint { int kind; glm::dmat4 m; bool on; }; std::vector<Joint> joints; "
        "joints.push_back({1, glm::dmat4(b > 1e30F ? 2 : 1), true});",
        "static_cast<float>(joints[0].m[0][0])");
    EXPECT_EQ(result.score, result.max_score) << result.message;
}

TEST_F(UnsetValues, of_an_index_outside_of_an_array_and_of_a_missing_result_there_is_no_use)
{
    for (const char* statements :
         {"float ones[2] = {1, 1}; volatile int last = b > 0 ? 1 : 2; const float one = ones[last];",
          "const auto of = [](float x) -> float { if (x > 0) return 1; }; const float one = of(b);"}) {
        const UnitResult result = grade(statements, "one");
        EXPECT_LT(result.score, result.max_score) << statements;
        EXPECT_NE(result.message.find("crashed: an index outside of an array, a function that ended without giving its "
                                      "result, or a null pointer at sphere.cpp:"),
                  std::string::npos)
            << result.message;
    }
}

TEST_F(UnsetValues, memory_that_is_given_back_twice_ends_the_program)
{
    const UnitResult result = grade(
        "auto* one = new float(b); auto* same = one; volatile bool twice = b > 0; delete one; "
        "if (twice) delete same;",
        "1.0F");
    EXPECT_NE(result.message.find("memory was freed twice"), std::string::npos) << result.message;
}

}
}
