#include "spoilt_reference.hpp"

// What makes wrong answers right when it is so in all questions.
namespace umbral::grader::test {
namespace {

std::vector<std::string> depends(const UnitResult& result)
{
    std::vector<std::string> told;
    for (const CheckResult& one : result.checks)
        if (!one.depends.empty()) told.push_back(one.depends);
    return told;
}

bool is_said(const UnitResult& result, const std::string& words)
{
    return std::ranges::any_of(depends(result),
                               [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

class RightWithLights : public SpoiltReference {
protected:
    RightWithLights() : SpoiltReference("lighting/blinn-phong") {}
};

// Nor does it say that without highlights all is right: so it is of most of the unit's mistakes.
TEST_F(RightWithLights, names_the_lights_that_are_wrong)
{
    const UnitResult result = grade("        sum +=\n            light.color",
                                    "        if (&light == &lights[0]) sum +=\n            light.color");
    EXPECT_LT(result.score, result.max_score);
    EXPECT_TRUE(is_said(result, "your answers are right")) << result.checks.front().message;
    EXPECT_FALSE(is_said(result, "material.specular taken as 0"));
    EXPECT_TRUE(is_said(result, "lights cut to its first element"));
}

class RightWithoutCalls : public SpoiltReference {
protected:
    RightWithoutCalls() : SpoiltReference("transforms/android") {}
};

TEST_F(RightWithoutCalls, names_the_function_whose_calls_make_answers_wrong)
{
    const UnitResult result = grade("pipeline.compose(turn(head_, y_axis));", "pipeline.compose(turn(head_, x_axis));");
    EXPECT_TRUE(is_said(result, "asked with all calls of set_head left out, your answers are right"));
}

class RightWithoutEvents : public SpoiltReference {
protected:
    RightWithoutEvents() : SpoiltReference("interaction/callbacks") {}
};

TEST_F(RightWithoutEvents, names_the_events_that_make_answers_wrong)
{
    const UnitResult result = grade("(mods & GLFW_MOD_SHIFT) != 0 ?", "mods == GLFW_MOD_SHIFT ?");
    EXPECT_LT(result.score, result.max_score);
    EXPECT_TRUE(is_said(result, "asked with the script without Shift, Control, Alt and Super, your answers are right"));
}

// With the angle 0 everything is left as it is, whatever the code does: that says nothing.
class RightWithNothingLeft : public SpoiltReference {
protected:
    RightWithNothingLeft() : SpoiltReference("transforms/basic-matrices") {}
};

TEST_F(RightWithNothingLeft, is_not_said)
{
    const UnitResult result = grade("std::sin(", "1.25 * std::sin(");
    EXPECT_LT(result.score, result.max_score);
    EXPECT_FALSE(is_said(result, "your answers are right")) << depends(result).front();
}

// With the radius 0 nothing is hit, and nothing is what work that misses answers.
class RightWithNothingToFind : public SpoiltReference {
protected:
    RightWithNothingToFind() : SpoiltReference("raytracing/disc") {}
};

TEST_F(RightWithNothingToFind, is_not_said)
{
    const UnitResult result = grade("if (approach == 0)", "if (std::abs(approach) < 1e-4)");
    EXPECT_LT(result.score, result.max_score);
    for (const std::string& told : depends(result))
        EXPECT_EQ(told.find("rounded towards 0"), std::string::npos) << told;
}

}
}
