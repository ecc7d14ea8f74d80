#include "spoilt_reference.hpp"

// Checks whose answers come of several functions, or of which one question has several.
namespace umbral::grader::test {
namespace {

class AnswersOfFunctions : public SpoiltReference {
protected:
    AnswersOfFunctions() : SpoiltReference("transforms/basic-matrices") {}
};

TEST_F(AnswersOfFunctions, the_only_one_with_wrong_answers_is_named)
{
    const UnitResult result = grade("rotation_about_z(float angle) { return turned(0, 1, angle); }",
                                    "rotation_about_z(float angle)\n{\n    glm::mat4 m = turned(0, 1, angle);\n"
                                    "    m[1][1] = 1;\n    return m;\n}");
    const std::string told = check(result, "known/rotation").common;
    EXPECT_TRUE(told.starts_with("only answers of rotation_about_z are wrong (")) << told;
    EXPECT_NE(told.find("none of rotation_about_x and rotation_about_y"), std::string::npos) << told;
    EXPECT_NE(told.find("entry (row 1, column 1) only"), std::string::npos) << told;
}

class ListsInTurn : public SpoiltReference {
protected:
    ListsInTurn() : SpoiltReference("meshes/winged-edge") {}
};

TEST_F(ListsInTurn, what_a_list_is_as_a_whole_is_said)
{
    const UnitResult result =
        grade("mesh.edges[item].start == vertex ? mesh.edges[item].left : mesh.edges[item].right;",
              "mesh.edges[item].start == vertex ? mesh.edges[item].right : mesh.edges[item].left;");
    const std::string told = check(result, "questions/faces round vertices").common;
    EXPECT_NE(told.find("begins with another row, and goes round as it should"), std::string::npos) << told;
    EXPECT_EQ(told.find("is not the first"), std::string::npos) << told;
}

class EventsOfOtherMoments : public SpoiltReference {
protected:
    EventsOfOtherMoments() : SpoiltReference("interaction/callbacks") {}
};

TEST_F(EventsOfOtherMoments, what_came_later_did_not_come_instead)
{
    const UnitResult result = grade("void on_scroll(GLFWwindow* window, double, double steps)\n{",
                                    "void on_scroll(GLFWwindow* window, double, double steps)\n{\n"
                                    "    steps = static_cast<int>(steps);\n    if (steps == 0) return;");
    const CheckResult& wheel = check(result, "wheel/commands");
    ASSERT_TRUE(wheel.first_difference);
    EXPECT_TRUE(wheel.first_difference->yours.starts_with("no")) << wheel.first_difference->yours;
    EXPECT_EQ(wheel.message.find("came instead"), std::string::npos) << wheel.message;
}

TEST_F(EventsOfOtherMoments, what_came_instead_is_shown_once)
{
    const UnitResult result = grade("button == GLFW_MOUSE_BUTTON_RIGHT ? Drag::pan : Drag::none",
                                    "button == GLFW_MOUSE_BUTTON_RIGHT ? Drag::orbit : Drag::none");
    const CheckResult& pan = check(result, "pan/commands");
    ASSERT_TRUE(pan.first_difference);
    EXPECT_TRUE(pan.first_difference->yours.starts_with("orbit")) << pan.first_difference->yours;
    EXPECT_TRUE(pan.first_difference->expected.starts_with("pan")) << pan.first_difference->expected;
    EXPECT_NE(pan.message.find(" came instead ("), std::string::npos) << pan.message;
    EXPECT_NE(pan.headline.find(" expected events are right"), std::string::npos) << pan.headline;
    EXPECT_EQ(pan.headline.find("orbit"), std::string::npos) << pan.headline;
}

}
}
