#include <gtest/gtest.h>

#include "spoilt_reference.hpp"

// One edge case that crashes does not cost what has nothing to do with it.
namespace umbral::grader::test {
namespace {

class PastCrashes : public SpoiltReference {
protected:
    /// The reference, which does this where `condition` holds.
    UnitResult grade(const std::string& condition, const std::string& statement)
    {
        const std::string begin = "const float a = dot(";
        return SpoiltReference::grade(begin, "if (" + condition + ") " + statement + "\n    " + begin);
    }
};

constexpr const char* null_write = "*static_cast<volatile int*>(nullptr) = 1;";
/// Some rays of the case "ends", that hit nothing: which is what an answer that is missing looks like, and still wrong.
constexpr const char* seldom = "ray.t_min == 4";

TEST_F(PastCrashes, what_has_nothing_to_do_with_them_is_judged)
{
    const UnitResult result = grade(seldom, null_write);
    const CheckResult& ends = check(result, "ends/t");
    EXPECT_GT(ends.score, 0);
    EXPECT_LT(ends.score, ends.max_score);
    EXPECT_NE(ends.message.find(" rows have no answer: crashed: signal 11"), std::string::npos) << ends.message;
    EXPECT_EQ(check(result, "inside/t").score, check(result, "inside/t").max_score);
    EXPECT_EQ(result.verdict, Verdict::partial);
}

TEST_F(PastCrashes, are_told_with_the_question_that_led_to_them)
{
    const UnitResult result = grade(seldom, null_write);
    EXPECT_TRUE(check(result, "ends/t").last_question.starts_with("intersect(Ray{"));
    EXPECT_EQ(check(result, "inside/t").last_question, "");
}

// One cause is told once, with all cases that it stopped.
TEST_F(PastCrashes, of_several_cases_are_told_together)
{
    const UnitResult result = grade("ray.t_min == 4 || ray.origin == sphere.centre", "throw 1;");
    std::size_t told = 0;
    for (std::size_t at = 0; (at = result.message.find("uncaught exception", at)) != std::string::npos; ++at) ++told;
    EXPECT_EQ(told, 1U) << result.message;
    EXPECT_NE(result.message.find("ends, inside"), std::string::npos) << result.message;
}

TEST_F(PastCrashes, exceptions_are_no_different)
{
    const UnitResult result = grade(seldom, "throw 1;");
    EXPECT_GT(check(result, "ends/t").score, 0);
    EXPECT_LT(check(result, "ends/t").score, check(result, "ends/t").max_score);
}

TEST_F(PastCrashes, neither_is_memory_that_is_not_there)
{
    const UnitResult result = grade(seldom, "return std::vector<float>(std::size_t{1} << 40)[0];");
    EXPECT_EQ(check(result, "inside/t").score, check(result, "inside/t").max_score);
    EXPECT_GT(check(result, "ends/t").score, 0);
    EXPECT_LT(check(result, "ends/t").score, check(result, "ends/t").max_score);
    EXPECT_NE(result.message.find("your code asked for more than"), std::string::npos) << result.message;
    EXPECT_TRUE(check(result, "ends/t").last_question.starts_with("intersect(Ray{"));
}

TEST_F(PastCrashes, an_endless_loop_costs_what_comes_after_it)
{
    exercise.limits.wall_seconds = 3;
    // Late in the case: as many answers as half of its pairs hold earn nothing.
    const UnitResult result = grade("ray.t_min == 2 && ray.t_max == 4 && [] { static int n = 0; return ++n > 4; }()",
                                    "for (volatile int i = 0; i == 0;) {}");
    const CheckResult& ends = check(result, "ends/t");
    EXPECT_GT(ends.score, 0);
    EXPECT_LT(ends.score, ends.max_score);
}

// Two cases that hang are enough: what was not run is not called wrong, and stands behind what was.
TEST_F(PastCrashes, cases_that_were_not_run_are_told_from_those_that_were)
{
    exercise.limits.wall_seconds = 1;
    const UnitResult result = grade("true", "for (volatile int i = 0; i == 0;) {}");
    const auto with = [&](Unjudged unjudged) {
        return std::ranges::count(result.checks, unjudged, &CheckResult::unjudged);
    };
    EXPECT_GT(with(Unjudged::stopped), 0);
    EXPECT_GT(with(Unjudged::not_run), 0);
    EXPECT_EQ(with(Unjudged::stopped) + with(Unjudged::not_run), static_cast<std::ptrdiff_t>(result.checks.size()));
}

TEST_F(PastCrashes, code_that_always_crashes_gets_nothing)
{
    const UnitResult result = grade("true", null_write);
    EXPECT_EQ(result.score, 0);
    EXPECT_EQ(result.verdict, Verdict::crashed);
    for (const CheckResult& one : result.checks) EXPECT_EQ(one.unjudged, Unjudged::stopped) << one.name;
}

class PastCrashesOfOneFunction : public SpoiltReference {
protected:
    PastCrashesOfOneFunction() : SpoiltReference("lighting/color") {}
};

// The case asks two functions in turn, two hundred times.
TEST_F(PastCrashesOfOneFunction, cost_nothing_of_another)
{
    const UnitResult result = grade("float encode_srgb(float light) { return",
                                    "float encode_srgb(float light) { if (light > 0) throw 1; return");
    const CheckResult& other = check(result, "to the last digit/decoded");
    EXPECT_EQ(other.score, other.max_score) << other.message;
    EXPECT_EQ(check(result, "to the last digit/encoded").score, 0);
}

// A list without end: how long it takes to fill the memory is up to the machine, what is run and judged is not.
TEST_F(PastCrashesOfOneFunction, that_fills_its_memory_is_asked_no_more)
{
    const UnitResult result = grade("float encode_srgb(float light) { return",
                                    "float encode_srgb(float light) { std::vector<float> all; while (light < 2) "
                                    "all.push_back(light); return");
    EXPECT_EQ(result.verdict, Verdict::partial);
    for (const CheckResult& one : result.checks) {
        EXPECT_TRUE(one.score == 0 || !one.name.ends_with("/encoded")) << one.name;
        EXPECT_TRUE(one.score == one.max_score || !one.name.ends_with("/decoded")) << one.name << one.message;
    }
    EXPECT_NE(result.message.find("2 cases used up their time or memory"), std::string::npos) << result.message;
}

// Every case that asks both hangs; what the other function answers is right in all of them.
TEST_F(PastCrashesOfOneFunction, that_always_hangs_cost_nothing_of_another_where_it_was_not_reached)
{
    exercise.limits.wall_seconds = 3;
    const UnitResult result = grade("float encode_srgb(float light) { return",
                                    "float encode_srgb(float light) { for (volatile int i = 0; i == 0;) {} return");
    std::ptrdiff_t right = 0;
    for (const CheckResult& one : result.checks) {
        const bool other = one.name.ends_with("/decoded") || one.name.ends_with("/sums");
        right += other && one.score == one.max_score ? 1 : 0;
        EXPECT_TRUE(one.score == 0 || !one.name.ends_with("/encoded")) << one.name;
    }
    EXPECT_GE(right, 8);
}

class PastCrashesOfFunctionsThatCallIt : public SpoiltReference {
protected:
    PastCrashesOfFunctionsThatCallIt() : SpoiltReference("transforms/perpendicular") {}
};

// rotate_in_plane calls turn_left, so both hang; six other functions do not.
TEST_F(PastCrashesOfFunctionsThatCallIt, cost_nothing_of_others)
{
    exercise.limits.wall_seconds = 3;
    const std::string begin = "glm::vec2 turn_left(const glm::vec2& u) { ";
    const UnitResult result = grade(begin, begin + "for (volatile int i = 0; u.x > 0.5F && i == 0;) {} ");
    for (const char* const right : {"known/right", "known/point", "known/across", "random/across matrix"})
        EXPECT_EQ(check(result, right).score, check(result, right).max_score) << right << ": " << result.message;
    EXPECT_EQ(check(result, "known/left").score, 0);
}

TEST_F(PastCrashes, of_hidden_cases_only_the_kind_is_told)
{
    const UnitResult result = grade("ray.t_min == 0 && ray.origin.x > 5 && ray.origin.y > 5", null_write);
    EXPECT_EQ(check(result, "random/t").last_question, "");
    EXPECT_EQ(check(result, "random/t").message.find("intersect"), std::string::npos);
}

}
}
