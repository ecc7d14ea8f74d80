#include "spoilt_reference.hpp"

// Bugs that are in no list of mistakes, told by the question that was answered instead.
namespace umbral::grader::test {
namespace {

class CopiedArguments : public SpoiltReference {
protected:
    CopiedArguments() : SpoiltReference("projections/viewport") {}
};

class CopiedColours : public SpoiltReference {
protected:
    CopiedColours() : SpoiltReference("lighting/phong") {}
};

class MisunderstoodEvents : public SpoiltReference {
protected:
    MisunderstoodEvents() : SpoiltReference("interaction/orbit-camera") {}
};

class MisunderstoodAngles : public SpoiltReference {
protected:
    MisunderstoodAngles() : SpoiltReference("projections/cameras") {}
};

class OppositeAnswers : public SpoiltReference {
protected:
    OppositeAnswers() : SpoiltReference("transforms/perpendicular") {}
};

/// The name of the first reason; nothing where none is told.
std::string reason(const UnitResult& result)
{
    return result.explanations.empty() ? "" : result.explanations.front().name;
}

TEST_F(CopiedArguments, one_used_in_place_of_another_is_told)
{
    const UnitResult result =
        grade("middle(pixel.y, viewport.bottom, viewport.height)", "middle(pixel.y, viewport.bottom, viewport.width)");
    EXPECT_EQ(reason(result), "question: viewport.height taken as viewport.width");
    EXPECT_EQ(result.explanations.size(), 1U);
}

// The answer's sign is wrong: that the question's is misread says the same, and sends one to look at the wrong end.
TEST_F(OppositeAnswers, are_no_misread_questions)
{
    GradeOptions options;
    options.questions = true;
    const UnitResult result = grade("return {u.y, -u.x};", "return {u.y, u.x};", options);
    EXPECT_EQ(reason(result).find("question: "), std::string::npos) << reason(result);
    EXPECT_EQ(check(result, "known/right").common,
              "every wrong answer differs in y only, which is the right one with the opposite sign");
}

TEST_F(CopiedArguments, a_component_used_in_place_of_another_is_told)
{
    const UnitResult result =
        grade("middle(pixel.y, viewport.bottom, viewport.height)", "middle(pixel.x, viewport.bottom, viewport.height)");
    EXPECT_EQ(reason(result), "question: pixel with y taken as x");
}

// What both questions explain is told in the words of the simpler one.
TEST_F(CopiedArguments, what_is_not_looked_at_is_not_taken_for_another)
{
    const UnitResult result =
        grade("middle(pixel.y, viewport.bottom, viewport.height)", "middle(pixel.y, 0, viewport.height)");
    EXPECT_EQ(reason(result), "question: viewport.bottom taken as 0");
}

TEST_F(CopiedColours, behind_many_other_arguments_are_told)
{
    const UnitResult result = grade("light.color * material.specular *", "light.color * material.diffuse *");
    EXPECT_EQ(reason(result), "question: material.specular taken as material.diffuse");
}

// The answers are those of view(), and what was misunderstood is an event before.
TEST_F(MisunderstoodEvents, are_told_of_the_view_that_came_of_them)
{
    const UnitResult result = grade("yaw_ - right / height_", "yaw_ - 2 * right / height_");
    ASSERT_EQ(reason(result), "question: right doubled");
    EXPECT_NE(result.explanations.front().sentence.find("drag with right doubled"), std::string::npos);
}

// An angle comes to the camera by its factory and by set_angles().
TEST_F(MisunderstoodAngles, are_told_of_all_calls_that_take_them)
{
    const UnitResult result = grade("b_ = radians(b_degrees);", "b_ = b_degrees;");
    ASSERT_EQ(reason(result), "question: b_degrees turned from radians into degrees");
    EXPECT_NE(result.explanations.front().sentence.find("make_orbital_camera and set_angles with"), std::string::npos);
}

}
}
