#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

TEST(Terminal, a_pattern_of_another_check_is_shown_where_no_reason_is_known)
{
    UnitResult unit = unit_result("projections/view-matrix", Verdict::partial,
                                  {check_result("axes/m", 0, 4000), check_result("far away/m", 0, 2500)});
    const auto printed = [&] { return terminal_report(submission_result("ana", {unit}), {}); };
    unit.checks[1].common = "every wrong answer is l";
    EXPECT_TRUE(has(printed(), "in far away/m: every wrong answer is l"));
    unit.explanations = {{"transposed", "Your matrix is the transpose of the expected one.", 0.95}};
    EXPECT_FALSE(has(printed(), "every wrong answer"));
    unit.checks[0].common = "every wrong answer is v";
    EXPECT_TRUE(has(printed(), "pattern   every wrong answer is v"));
    unit.explanations = {{"scaled", "Your values are 2 times the expected ones.", 0.95}};
    unit.checks[0].common = "every wrong answer is 2 times the right one";
    unit.checks[0].common_tells = CommonTells::multiple;
    EXPECT_FALSE(has(printed(), "pattern")) << "the reason says the same";
    unit.checks[0].common = "every wrong answer is ln 2 (as ln is of log2) times the right one";
    unit.checks[0].common_tells = CommonTells::other;
    EXPECT_TRUE(has(printed(), "pattern"));
    unit.checks[0].common = "every wrong answer is larger than the right one";
    unit.checks[0].common_tells = CommonTells::side;
    EXPECT_FALSE(has(printed(), "pattern")) << "a reason says more";
    unit.explanations.clear();
    EXPECT_TRUE(has(printed(), "in far away/m: every wrong answer is l"));
    EXPECT_TRUE(has(printed(), "pattern   every wrong answer is larger")) << "and what is known of the one shown";
    unit.checks[1].common_tells = CommonTells::nearly;
    EXPECT_TRUE(has(printed(), "pattern   every wrong answer is larger")) << "of the check that is shown";
    unit.checks[0].common.clear();
    EXPECT_FALSE(has(printed(), "pattern")) << "where wrong ones lie may be another place in another check";
}

}
}
