#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/hidden.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

// What students are shown of practice inputs.
namespace umbral::grader {
namespace {

// Where a visible check fails, its first wrong value is the example.
TEST(Practice, shows_a_practice_question_where_only_hidden_checks_fail)
{
    CheckResult hidden = check_result("secret/t", 0, 1000, true);
    hidden.practice_example = Difference{"y", "2", "3", {}, "square_root(9)"};
    const auto printed = [&](const CheckResult& visible) {
        const UnitResult unit = unit_result("a/b", Verdict::partial, {visible, hidden});
        return terminal_report(without_hidden_values(submission_result("ana", {unit})), {});
    };
    const std::string report = printed(check_result("open/t", 1000, 1000));
    EXPECT_TRUE(has(report, "practice  square_root(9)\n              y\n")) << report;
    EXPECT_FALSE(has(printed(check_result("open/t", 0, 1000)), "square_root"));
}

TEST(Practice, names_the_picture_of_practice_inputs_where_only_hidden_checks_fail)
{
    CheckResult hidden = check_result("secret/picture", 0, 1000, true);
    hidden.artefacts = {{"triptych", "pictures/graded.png"}, {practice_picture, "pictures/practice.png"}};
    const UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("open/t", 1000, 1000), hidden});
    const std::string report = terminal_report(without_hidden_values(submission_result("ana", {unit})), {});
    EXPECT_TRUE(has(report, "practice  pictures/practice.png")) << report;
    EXPECT_FALSE(has(report, "graded.png"));
}

}
}
