#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// What is said of bugs in units of light: tables of colours, and shaders.
namespace umbral::grader::test {
namespace {

class QuestionsOfColors : public SpoiltReference {
protected:
    QuestionsOfColors() : SpoiltReference("lighting/color") {}
};

class QuestionsOfShaders : public SpoiltReference {
protected:
    QuestionsOfShaders() : SpoiltReference("lighting/shaders") {}
};

// Where values are clamped, the positive ones happen to be larger than 1; another case asks for 0.5, rightly answered.
TEST_F(QuestionsOfColors, what_another_case_denies_is_no_condition)
{
    const UnitResult result =
        grade("float decode_srgb(float value) { return static_cast<float>(decoded(clamped(value)));",
              "float decode_srgb(float value) { return static_cast<float>(decoded(value > 0 ? "
              "double{value} : 0.0));");
    for (const CheckResult& one : result.checks)
        EXPECT_EQ(one.common.find("is positive"), std::string::npos) << one.name << ": " << one.common;
}

// A table of few numbers is nearly as well explained by a factor that no light has.
TEST_F(QuestionsOfColors, a_table_that_is_nearly_right_has_no_missing_light)
{
    const UnitResult result = grade("1.055 * std::pow(light, 1 / 2.4)", "std::pow(1.055 * light, 1 / 2.4)");
    for (const Explanation& one : result.explanations) EXPECT_NE(one.name, "light scaled") << one.sentence;
}

TEST_F(QuestionsOfShaders, uniforms_can_be_taken_for_each_other)
{
    const UnitResult result = grade("sum += specular *", "sum += diffuse *");
    ASSERT_FALSE(result.explanations.empty());
    EXPECT_NE(result.explanations.front().sentence.find("the shaders with specular taken as diffuse"),
              std::string::npos)
        << result.explanations.front().sentence;
}

}
}
