#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// What one function of several does to its answers is told, though the others' stand in the same table.
namespace umbral::grader::test {
namespace {

class OneFunctionOfSeveral : public SpoiltReference {
protected:
    OneFunctionOfSeveral() : SpoiltReference("transforms/basic-matrices") {}

    static const Explanation* named(const UnitResult& result, const std::string& name)
    {
        const auto found = std::ranges::find(result.explanations, name, &Explanation::name);
        return found == result.explanations.end() ? nullptr : &*found;
    }
};

TEST_F(OneFunctionOfSeveral, that_is_transposed_is_named)
{
    const UnitResult result = grade("return turned(1, 2, angle);", "return glm::transpose(turned(1, 2, angle));");
    const Explanation* found = named(result, "transposed in rotation_about_x");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->sentence.find("Seen in rotation_about_x: your "), 0U) << found->sentence;
    EXPECT_GT(found->confidence, 0.9);
}

// With another mistake in another function, neither explains all.
TEST_F(OneFunctionOfSeveral, is_no_reason_for_what_others_do)
{
    const UnitResult result = grade(
        "glm::mat4 rotation_about_x(float angle) { return turned(1, 2, angle); }\n"
        "glm::mat4 rotation_about_y(float angle) { return turned(2, 0, angle); }",
        "glm::mat4 rotation_about_x(float angle) { return glm::transpose(turned(1, 2, angle)); }\n"
        "glm::mat4 rotation_about_y(float angle) { return turned(2, 1, angle); }");
    const Explanation* found = named(result, "transposed in rotation_about_x");
    ASSERT_NE(found, nullptr);
    EXPECT_LT(found->fit, 1);
}

}
}
