#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/hidden.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

// The line of the student's own file where wrong answers part from right ones.
namespace umbral::grader {
namespace {

CheckResult with_place(CheckResult check)
{
    check.code_place =
        CodePlace{"sphere.cpp", 17, 5, "if (t < 0) return t0;",
                  "all 41 calls with wrong answers come through here, and none of the 359 with right ones"};
    return check;
}

std::string printed(const std::vector<CheckResult>& checks)
{
    const UnitResult unit = unit_result("a/b", Verdict::partial, checks);
    return terminal_report(without_hidden_values(submission_result("ana", {unit})), {});
}

TEST(CodePlace, is_shown_with_its_line_and_a_mark_below)
{
    EXPECT_TRUE(
        has(printed({with_place(check_result("open/t", 0, 1000))}),
            "code      sphere.cpp:17\n"
            "                if (t < 0) return t0;\n"
            "                    ^\n"
            "              all 41 calls with wrong answers come through here, and none of the 359 with right ones\n"));
}

TEST(CodePlace, says_which_check_it_is_of_if_another_is_shown)
{
    const std::string report = printed({check_result("open/t", 0, 1000), with_place(check_result("other/t", 0, 1000))});
    EXPECT_TRUE(has(report, "in other/t, all 41 calls with wrong answers come through here")) << report;
}

TEST(CodePlace, of_a_hidden_check_is_about_practice_inputs)
{
    const std::string report =
        printed({check_result("open/t", 1000, 1000), with_place(check_result("secret/t", 0, 1000, true))});
    EXPECT_TRUE(has(report, "on practice inputs, all 41 calls with wrong answers come through here")) << report;
}

// Control characters and what is too long may stand in anybody's file.
TEST(CodePlace, shows_any_line_in_one_line)
{
    CheckResult check = with_place(check_result("open/t", 0, 1000));
    check.code_place->text = std::string("x = \"\x1B[31m\";") + std::string(200, 'y');
    const std::string report = printed({check});
    EXPECT_FALSE(has(report, "\x1B")) << report;
    EXPECT_FALSE(has(report, std::string(100, 'y'))) << report;
}

}
}
