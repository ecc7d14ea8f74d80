#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// The line of a student's file that wrong answers come through, and right ones do not.
namespace umbral::grader::test {
namespace {

class CodePlaces : public SpoiltReference {
protected:
    static std::vector<CodePlace> told(const UnitResult& result)
    {
        std::vector<CodePlace> places;
        for (const CheckResult& check : result.checks)
            if (check.code_place) places.push_back(*check.code_place);
        return places;
    }
    /// The places that are told of a reference in which `from` became `to`.
    std::vector<CodePlace> of(const std::string& from, const std::string& to)
    {
        const UnitResult result = grade(from, to, {});
        EXPECT_LT(result.score, result.max_score) << to;
        return told(result);
    }
};

const std::string first_root = "if (ray.t_min < t && t < ray.t_max) return t;";

TEST_F(CodePlaces, name_the_branch_with_the_bug)
{
    const std::vector<CodePlace> places =
        of(first_root,
           "if (ray.t_min < t && t < ray.t_max) {\n            if (t > 10)\n                return t + "
           "1;\n            return t;\n        }");
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0].file, "sphere.cpp");
    EXPECT_EQ(places[0].text, "return t + 1;");
    EXPECT_TRUE(places[0].sentence.starts_with("all ")) << places[0].sentence;
    EXPECT_NE(places[0].sentence.find("come through here, and none of the"), std::string::npos) << places[0].sentence;
}

TEST_F(CodePlaces, name_the_lines_of_a_loop_that_does_not_end)
{
    const std::string loop =
        "{\n        volatile float s = t;\n        while (s > -1) {\n            s = s + 1;\n        }\n }";
    const UnitResult result = grade(first_root, loop, {});
    EXPECT_NE(result.message.find(": one call runs lines "), std::string::npos) << result.message;
    EXPECT_NE(result.message.find(" of sphere.cpp again and again\n"), std::string::npos) << result.message;
    EXPECT_EQ(grade(first_root, loop, {}).message, result.message);
}

// A submission may call its lines what it likes.
TEST_F(CodePlaces, are_only_told_of_files_that_were_handed_in)
{
    for (const char* const line : {"#line 3 \"/etc/passwd\"", "#line 90000 \"sphere.cpp\"", "#line 3 \"other.cpp\""})
        for (const CodePlace& place :
             of(first_root, "if (ray.t_min < t && t < ray.t_max) {\n            if (t > 10)\n" + std::string(line) +
                                "\n                return t + 1;\n return t; }")) {
            EXPECT_EQ(place.file, "sphere.cpp") << line;
            EXPECT_EQ(place.text.find("root:"), std::string::npos) << line;
            EXPECT_LT(place.line, 100) << line;
        }
}

}
}
