#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

// Which failing check a student is shown first.
namespace umbral::grader {
namespace {

TEST(FailingOrder, the_first_failing_check_is_the_most_exact_one_and_not_the_manifests_first)
{
    // From vague to exact, as a manifest might list them.
    const std::vector<std::pair<JudgeKind, std::string>> kinds = {
        {JudgeKind{"image"}, "colours/image"}, {JudgeKind{"cost"}, "work/blocks"}, {JudgeKind{"buffer"}, "ids/ids"},
        {JudgeKind{"numbers"}, "dot/x"},       {JudgeKind{"matrices"}, "view/m"},  {JudgeKind{"trace"}, "calls/calls"}};
    UnitResult unit = unit_result("a/b", Verdict::wrong, {});
    for (const auto& [kind, name] : kinds) {
        unit.checks.push_back(check_result(name, 0, 1000));
        unit.checks.back().kind = kind;
        unit.max_score += 1000;
    }
    const auto first = [&] {
        const std::string report = terminal_report(submission_result("ana", {unit}), {.width = 160});
        const std::size_t at = report.find("check     ") + 10;
        return report.substr(at, report.find(' ', at) - at);
    };
    EXPECT_EQ(first(), "calls/calls");
    EXPECT_TRUE(has(terminal_report(submission_result("ana", {unit}), {.width = 160}),
                    "also      dot/x, view/m, ids/ids, work/blocks, colours/image not right"));
    unit.checks.pop_back();
    EXPECT_EQ(first(), "dot/x") << "of two as exact as each other, the manifest's first";
    unit.checks.resize(3);
    EXPECT_EQ(first(), "ids/ids");
    unit.checks[2].score = 1000;
    EXPECT_EQ(first(), "work/blocks") << "what is right is no failure";
    unit.checks[1].hidden = true;
    EXPECT_EQ(first(), "colours/image");
    unit.checks[1].hidden = false;
    unit.checks[1].held_back = true;
    EXPECT_EQ(first(), "colours/image") << "what is held back by another check has nothing wrong to show";
}

// A call of one line can be worked out; a page of them, of which nearly all is right, passes on what is wrong
// elsewhere.
TEST(FailingOrder, short_questions_stand_before_long_ones)
{
    UnitResult unit = unit_result("a/b", Verdict::wrong, {});
    for (const auto& [name, score, question] :
         {std::tuple("graph/x", 950, 300), {"any/x", 0, 300}, {"hand/x", 950, 40}, {"other/x", 0, 90}}) {
        unit.checks.push_back(check_result(name, score, 1000));
        unit.checks.back().first_difference =
            Difference{"row 0", "1", "2", std::nullopt, std::string(static_cast<std::size_t>(question), 'f')};
    }
    const std::string report = terminal_report(submission_result("ana", {unit}), {.width = 160});
    EXPECT_TRUE(has(report, "check     hand/x")) << report;
    EXPECT_TRUE(has(report, "also      other/x, any/x, graph/x not right")) << report;
}

// The last digits of a hard case have a question that leads somewhere; a pixel has thirty.
TEST(FailingOrder, hard_numbers_stand_behind_others_and_before_pictures)
{
    UnitResult unit = unit_result("a/b", Verdict::wrong, {});
    for (const auto& [name, kind, hard] :
         {std::tuple("far/x", "numbers", true), {"ids/ids", "buffer", false}, {"near/x", "matrices", false}}) {
        unit.checks.push_back(check_result(name, 0, 1000));
        unit.checks.back().kind = JudgeKind{kind};
        unit.checks.back().hard = hard;
    }
    const std::string report = terminal_report(submission_result("ana", {unit}), {.width = 160});
    EXPECT_TRUE(has(report, "check     near/x")) << report;
    EXPECT_TRUE(has(report, "also      far/x, ids/ids not right")) << report;
}

TEST(FailingOrder, what_was_not_judged_is_not_called_wrong_and_waits_for_what_was)
{
    UnitResult unit =
        unit_result("a/b", Verdict::wrong, {check_result("dot/x", 0, 1000), check_result("dot/y", 0, 1000)});
    const auto report = [&] { return terminal_report(submission_result("ana", {unit}), {.width = 160}); };
    EXPECT_TRUE(has(report(), "check     dot/x  wrong, 0 of 1 points"));
    unit.checks[0].unjudged = Unjudged::not_run;
    EXPECT_TRUE(has(report(), "check     dot/y  wrong, 0 of 1 points"));
    unit.checks[1].unjudged = Unjudged::stopped;
    EXPECT_TRUE(has(report(), "check     dot/y  no result, 0 of 1 points"));
    unit.checks[1].unjudged = Unjudged::unwritten;
    EXPECT_TRUE(has(report(), "check     dot/x  not run, 0 of 1 points"));
}

TEST(FailingOrder, a_question_that_can_be_read_whole_comes_before_one_that_was_shortened)
{
    CheckResult shortened = check_result("odd/index", 500, 1000);
    shortened.first_difference = Difference{"row 4", "1", "2", 4, "first_hit(std::vector<float>{1, 2, 3, … 297 more})"};
    CheckResult whole = check_result("few/index", 950, 1000);
    whole.first_difference = Difference{"row 4", "1", "2", 4, "first_hit(" + std::string(700, '1') + ")"};
    const UnitResult unit = unit_result("a/b", Verdict::partial, {shortened, whole});
    EXPECT_TRUE(has(terminal_report(submission_result("ana", {unit}), {}), "check     few/index"));
}

}
}
