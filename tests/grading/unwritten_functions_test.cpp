#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// Who writes a unit function by function is told, after each, how good it is.
namespace umbral::grader::test {
namespace {

class UnwrittenFunction : public SpoiltReference {
protected:
    UnwrittenFunction() : SpoiltReference("lighting/color") {}
    UnitResult without_encoding(const std::string& begin = "return not_implemented<float>(light);")
    {
        return grade("float encode_srgb(float light) {", "float encode_srgb(float light) { " + begin);
    }
};

// The case asks two functions in turn, two hundred times.
TEST_F(UnwrittenFunction, costs_nothing_of_others)
{
    const UnitResult result = without_encoding();
    const CheckResult& other = check(result, "to the last digit/decoded");
    EXPECT_EQ(other.score, other.max_score) << other.message;
    const CheckResult& missing = check(result, "to the last digit/encoded");
    EXPECT_EQ(missing.score, 0);
    EXPECT_EQ(missing.message, "not implemented yet");
    EXPECT_EQ(result.verdict, Verdict::partial);
}

// What is unwritten for some arguments only has no answer there, and is not taken for a wrong one.
TEST_F(UnwrittenFunction, costs_what_it_does_not_answer)
{
    const UnitResult result = without_encoding("if (light > 0.5F) return not_implemented<float>();");
    const CheckResult& half = check(result, "to the last digit/encoded");
    EXPECT_GT(half.score, 0);
    EXPECT_LT(half.score, half.max_score);
    EXPECT_NE(half.message.find(" rows have no answer: not implemented yet"), std::string::npos) << half.message;
}

// What draws with a function that is missing cannot be judged, and is not called wrong.
TEST_F(UnwrittenFunction, leaves_pictures_unjudged)
{
    const UnitResult result = grade("glm::u8vec3 to_pixel(const glm::vec3& light)\n{",
                                    "glm::u8vec3 to_pixel(const glm::vec3& light)\n{\n"
                                    "    return not_implemented<glm::u8vec3>(light);");
    const CheckResult& picture = check(result, "picture/shadows");
    EXPECT_EQ(picture.score, 0);
    EXPECT_EQ(picture.message, "not implemented yet");
    EXPECT_EQ(picture.unjudged, Unjudged::unwritten);
}

// Empty answers may be the right ones now and then.
TEST_F(UnwrittenFunction, earns_nothing_by_its_empty_answer)
{
    const UnitResult result = without_encoding();
    for (const char* const name : {"by hand/encoded", "random/encoded", "out of range/encoded", "not numbers/encoded",
                                   "to the last digit/encoded"})
        EXPECT_EQ(check(result, name).score, 0) << name << ": " << check(result, name).message;
}

}
}
