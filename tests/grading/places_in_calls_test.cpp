#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// Where a call has several answers: which of them are wrong.
namespace umbral::grader::test {
namespace {

class PlacesInCalls : public SpoiltReference {
protected:
    PlacesInCalls() : SpoiltReference("meshes/vertex-normals") {}
};

TEST_F(PlacesInCalls, say_that_the_last_answer_of_each_is_wrong)
{
    const UnitResult result = grade("    return normals;\n}\n\n}",
                                    "    if (!normals.empty()) normals.back() = {};\n"
                                    "    return normals;\n}\n\n}");
    const CheckResult& wrong = check(result, "known/vertices");
    ASSERT_LT(wrong.score, wrong.max_score);
    EXPECT_TRUE(wrong.common.starts_with("wrong wherever a row of a call is the last (4 of 4)")) << wrong.common;
}

}
}
