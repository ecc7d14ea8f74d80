#include <gtest/gtest.h>

#include "judge/make.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

using test::floats;

RunOutcome run_of(Recorder::Tensors tensors)
{
    RunOutcome run;
    run.verdict = Verdict::ok;
    run.recording.tensors = std::move(tensors);
    return run;
}

CheckResult graded(const std::string& refusals)
{
    Check check = test::check_of(JudgeKind{"numbers"}, test::ulps(1));
    check.value = "value";
    const RunOutcome expected = run_of({{"value", floats({1, 2, 3})}});
    CaseResult one;
    one.student = run_of({{"value", floats({1, NAN, NAN})}, {"value.refusals", test::text(refusals)}});
    return judge_check(check, one, expected, expected);
}

TEST(Refusals, are_shown_instead_of_what_stands_for_them)
{
    const CheckResult result = graded("0\tnothing\n1\texpected a number\n");
    EXPECT_EQ(result.first_difference->yours, "refused: expected a number");
    EXPECT_TRUE(result.message.ends_with("; yours refused: expected a number")) << result.message;
    EXPECT_TRUE(result.headline.ends_with("; yours refused: expected a number")) << result.headline;
}

TEST(Refusals, of_other_rows_or_forged_ones_do_no_harm)
{
    EXPECT_EQ(graded("2\tlater\n10\tlater\nno tab\n\t\n").first_difference->yours, "nan");
    EXPECT_EQ(graded("1\t\x1b[2Jcommand\n").first_difference->yours.find('\x1b'), std::string::npos);
}

}
}
