#include "spoilt_reference.hpp"

// What wrong answers change with and should not, or the reverse.
namespace umbral::grader::test {
namespace {

std::string depends(const UnitResult& result)
{
    const auto told = std::ranges::find_if(result.checks, [](const CheckResult& one) { return !one.depends.empty(); });
    return told == result.checks.end() ? "" : told->depends;
}

class DependenceOfMatrices : public SpoiltReference {
protected:
    DependenceOfMatrices() : SpoiltReference("projections/orthographic") {}
};

TEST_F(DependenceOfMatrices, names_the_side_that_an_entry_should_not_change_with)
{
    const UnitResult result = grade("matrix[3][axis] = static_cast<float>(along.offset);",
                                    "matrix[3][axis] = static_cast<float>(along.offset);\n"
                                    "        if (axis == 1) matrix[3][1] *= sides[1].to - sides[1].from, "
                                    "matrix[3][1] /= sides[0].to - sides[0].from;");
    EXPECT_EQ(
        depends(result),
        "in entry (row 1, column 3) your wrong answers change with box.left and box.right, and the right ones do not");
}

TEST_F(DependenceOfMatrices, says_nothing_of_a_wrong_sign)
{
    const UnitResult result = grade("matrix[3][axis] = static_cast<float>(along.offset);",
                                    "matrix[3][axis] = static_cast<float>(-along.offset);");
    EXPECT_LT(result.score, result.max_score);
    EXPECT_EQ(depends(result), "");
}

class DependenceOfProducts : public SpoiltReference {
protected:
    DependenceOfProducts() : SpoiltReference("transforms/gram-matrix") {}
};

TEST_F(DependenceOfProducts, names_what_is_not_used)
{
    const UnitResult result = grade("return static_cast<float>(dot(glm::dvec3(a), glm::dmat3(gram) * glm::dvec3(b)));",
                                    "glm::dmat3 upper(gram);\n    upper[0][1] = upper[0][2] = 0;\n"
                                    "    return static_cast<float>(dot(glm::dvec3(a), upper * glm::dvec3(b)));");
    EXPECT_TRUE(depends(result).starts_with("your wrong answers do not change with gram[0][1]")) << depends(result);
}

// It would be a process of the student's that asks: a crash or an endless loop with other arguments tells nothing, and
// harms nothing.
TEST_F(DependenceOfProducts, survives_what_the_code_does_with_other_arguments)
{
    for (const char* const harm : {"__builtin_trap();", "for (;;) { static volatile int n; ++n; }", "throw 7;"}) {
        const UnitResult result =
            grade("return static_cast<float>(dot(glm::dvec3(a), glm::dmat3(gram) * glm::dvec3(b)));",
                  "if (gram[0][0] == 17.0F / 16) { " + std::string(harm) +
                      " }\n    return static_cast<float>(dot(glm::dvec3(b), glm::dvec3(a)));");
        EXPECT_EQ(result.verdict, Verdict::partial) << harm;
        EXPECT_LT(result.score, result.max_score) << harm;
    }
}

class DependenceOfErrors : public SpoiltReference {
protected:
    DependenceOfErrors() : SpoiltReference("projections/fit-frustum") {}
};

// Near and far plane of a call stand in two rows; the second is not the right one times anything.
TEST_F(DependenceOfErrors, names_the_only_argument_that_they_depend_on)
{
    const UnitResult result = grade("std::tan(fovy_degrees * (std::numbers::pi / 360))",
                                    "(2 * std::tan(fovy_degrees * (std::numbers::pi / 720)))");
    const std::string told = depends(result);
    const std::string begin =
        "in number 1 of 2 your wrong answers are multiples of the right ones, and which depends on fovy_degrees alone "
        "(";
    EXPECT_TRUE(told.starts_with(begin)) << told;
    EXPECT_NE(told.find(" times where it is "), std::string::npos) << told;
}

}
}
