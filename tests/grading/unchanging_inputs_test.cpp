#include <gtest/gtest.h>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

// A unit of which four of ten points stand on inputs that never change: tests/fixtures/exercises/inputs/cubes.
namespace umbral::grader::test {
namespace {

class UnchangingInputs : public testing::Test {
protected:
    UnitResult grade(const std::string& body, bool other_inputs = true)
    {
        GradeOptions options;
        options.seeds.secret = "a secret of the test's";
        options.explain = false;
        options.other_inputs = other_inputs;
        const std::string text =
            "#include <cmath>\n#include <cstdio>\n"
            "namespace umbral::inputs {\nfloat cube(float number)\n{\n" +
            body + "\n}\n}\n";
        return grade_unit(worker, exercise, {{{"cubes.cpp", text}}, {}, ""}, options);
    }
    /// The first question of the case whose numbers are drawn, as the student's code prints it: everybody can find it
    /// out at a desk.
    std::string first_drawn_number()
    {
        const std::string body =
            "    static int calls = 0;\n"
            "    if (calls++ == 0 && number > 20) std::printf(\"%.9gF\\n\", number);\n"
            "    return number;";
        const std::string printed = grade(body, false).output;
        return printed.substr(0, printed.find('F') + 1);
    }

    Workbench bench;
    Toolchain tools = bench.fixture_tools();
    Exercise exercise = load_exercise(tools.exercises / "inputs/cubes");
    Worker worker{tools};
};

/// Right for the integers, and for the first `known` others of each run.
std::string right_for_integers_and(int known)
{
    return "    static int others = 0;\n"
           "    if (number == std::floor(number) || others++ < " +
           std::to_string(known) +
           ") return number * number * number;\n"
           "    return 1;";
}

TEST_F(UnchangingInputs, earn_all_for_right_work)
{
    EXPECT_EQ(grade("    return number * number * number;").score, exercise.points);
}

// Nobody can tell whether the table was written down, while the other check earns half of its points or more.
TEST_F(UnchangingInputs, keep_their_points_beside_what_is_mostly_right_with_other_inputs)
{
    const UnitResult result = grade(right_for_integers_and(150));
    EXPECT_EQ(result.checks.at(0).score, result.checks.at(0).max_score) << result.checks.at(0).message;
    EXPECT_GT(result.checks.at(1).score, result.checks.at(1).max_score * 2 / 3) << result.checks.at(1).message;
}

TEST_F(UnchangingInputs, keep_their_points_beside_what_was_never_right)
{
    const UnitResult result = grade(right_for_integers_and(0));
    EXPECT_EQ(result.checks.at(0).score, result.checks.at(0).max_score) << result.checks.at(0).message;
    EXPECT_EQ(result.checks.at(1).score, 0);
}

// Right for the numbers that a desk asks, which are the public seed's, and for no others: not believed about the table.
TEST_F(UnchangingInputs, lose_their_share_where_known_answers_were_all_else)
{
    const UnitResult result = grade(
        "    static int calls = 0;\n"
        "    static bool known = false;\n"
        "    if (calls++ == 0) known = number == " +
        first_drawn_number() +
        ";\n"
        "    if (number == std::floor(number) || known) return number * number * number;\n"
        "    return 1;");
    EXPECT_EQ(result.checks.at(1).score, 0) << result.checks.at(1).message;
    EXPECT_NE(result.checks.at(1).message.find("not with others"), std::string::npos) << result.checks.at(1).message;
    EXPECT_EQ(result.checks.at(0).score, 0) << result.checks.at(0).message;
    EXPECT_NE(result.checks.at(0).message.find("never change"), std::string::npos) << result.checks.at(0).message;
}

}
}
