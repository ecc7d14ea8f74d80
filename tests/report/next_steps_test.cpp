#include "report/next_steps.hpp"

#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

TEST(NextSteps, name_the_workspace_that_was_checked)
{
    UnitResult unit = unit_result("projections/view-matrix", Verdict::partial,
                                  {check_result("axes/m", 4000, 4000), check_result("far away/m", 0, 2500)});
    unit.checks[1].first_difference = Difference{"matrix 3", "1", "2", std::nullopt, "view_matrix(eye)"};
    const SubmissionResult result = submission_result("ana", {unit});
    TerminalStyle style;
    style.folder = "my work";
    const std::string report = terminal_report(result, style);
    EXPECT_TRUE(has(report, "umbral debug projections/view-matrix 'far away' --dir 'my work'\n")) << report;
    EXPECT_TRUE(has(report, "umbral hint projections/view-matrix --dir 'my work'\n")) << report;
    style.folder = ".";
    EXPECT_EQ(terminal_report(result, style), terminal_report(result, {}));
}

}
}
