#include <gtest/gtest.h>

#include "explain/asked_alone.hpp"
#include "spoilt_reference.hpp"

// Code that keeps an answer for the next call is right as long as nobody asks anything else of the same size.
namespace umbral::grader::test {
namespace {

class BesideItself : public SpoiltReference {
protected:
    BesideItself() : SpoiltReference("transforms/rotation-identities") {}

    /// after_turns() returns the last answer again if `same` holds.
    UnitResult keeping(const std::string& same)
    {
        const std::string body =
            "glm::dvec3 v(vector);\n"
            "    for (const ElementaryTurn& turn : turns) v = turned(v, turn);\n"
            "    return glm::vec3(v);";
        return grade(body,
                     "static glm::vec3 last(0), answer(0);\n"
                     "    static std::vector<ElementaryTurn> before;\n"
                     "    const auto alike = [](const ElementaryTurn& a, const ElementaryTurn& b) {\n"
                     "        return a.axis == b.axis && a.degrees == b.degrees;\n"
                     "    };\n"
                     "    (void)alike;\n"
                     "    if (vector == last && " +
                         same +
                         ") return answer;\n"
                         "    last = vector;\n"
                         "    before.assign(turns.begin(), turns.end());\n"
                         "    glm::dvec3 v(vector);\n"
                         "    for (const ElementaryTurn& turn : turns) v = turned(v, turn);\n"
                         "    return answer = glm::vec3(v);");
    }
};

TEST_F(BesideItself, what_is_kept_for_another_question_is_found)
{
    const UnitResult result = keeping("before.size() == turns.size()");
    EXPECT_LT(result.score, result.max_score);
    const auto found = std::ranges::find_if(result.checks, &CheckResult::beside);
    ASSERT_NE(found, result.checks.end()) << "each case alone is right";
    EXPECT_LT(found->score, found->max_score);
    EXPECT_EQ(found->common, right_without_others);
}

// All but the angles is compared: nearly the same question has its own answer.
TEST_F(BesideItself, what_is_kept_for_nearly_the_same_question_is_found)
{
    const UnitResult result = keeping(
        "before.size() == turns.size() && std::equal(turns.begin(), turns.end(), before.begin(),"
        " [](const ElementaryTurn& a, const ElementaryTurn& b) { return a.axis == b.axis; })");
    EXPECT_LT(result.score, result.max_score);
    EXPECT_NE(std::ranges::find_if(result.checks, &CheckResult::beside), result.checks.end());
}

// What is kept, and looked up by all that it depends on, is a cache.
TEST_F(BesideItself, whoever_compares_all_may_keep_answers)
{
    const UnitResult result =
        keeping("before.size() == turns.size() && std::equal(turns.begin(), turns.end(), before.begin(), alike)");
    EXPECT_EQ(result.score, result.max_score) << result.message;
}

// Nor does it help to end the program rather than to answer.
TEST_F(BesideItself, what_crashes_with_other_questions_in_between_is_found)
{
    const UnitResult result = keeping("before.size() == turns.size() && ([] { throw 1; }(), true)");
    const auto found = std::ranges::find_if(result.checks, &CheckResult::beside);
    ASSERT_NE(found, result.checks.end());
    EXPECT_EQ(found->score, found->max_score * 8 / 10);
    EXPECT_EQ(found->common, crashes_beside_others);
}

}
}
