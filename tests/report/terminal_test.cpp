#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "page_text.hpp"
#include "report/details.hpp"
#include "report/hidden.hpp"
#include "report/layout.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

/// The text without our own colours: an ESC that is left is somebody else's.
std::string without_colour(std::string text)
{
    for (std::size_t at = 0; (at = text.find("\x1b[", at)) != std::string::npos;)
        text.erase(at, text.find('m', at) - at + 1);
    return text;
}

UnitResult transposed()
{
    UnitResult unit = unit_result("projections/view-matrix", Verdict::partial,
                                  {check_result("axes/m", 4000, 4000), check_result("far away/m", 0, 2500)});
    unit.checks[1].first_difference =
        Difference{"matrix 3, entry (row 0, column 1)", "5 in [1 5; 0 1]", "0 in [1 0; 5 1]"};
    unit.checks[1].message = "1 of 4 matrices is wrong; the worst is matrix 3: yours 5 in [1 5; 0 1], expected 0";
    unit.explanations = {{"transposed", "Your matrix is the transpose of the expected one.", 0.75},
                         {"other", "Something less likely.", 0.1}};
    unit.output = "hello\nworld\n";
    unit.seconds = 0.25;
    unit.reference_seconds = 0.002;
    return unit;
}

TEST(Terminal, says_what_a_student_needs)
{
    const std::string report = terminal_report(submission_result("ana", {transposed()}), {});
    EXPECT_TRUE(has(report, "4/6.5"));
    EXPECT_TRUE(has(report, "partly right, 4 of 6.5 points"));
    EXPECT_TRUE(has(report, "250 ms / 2.0 ms"));
    EXPECT_TRUE(has(report, "far away/m  wrong, 0 of 2.5 points"));
    EXPECT_TRUE(has(report, "⎡  1 ▸5 ⎤"));
    EXPECT_TRUE(has(report, "⎡  1 ▸0 ⎤"));
    EXPECT_TRUE(has(report, "⎣ ▸5  1 ⎦"));
    EXPECT_TRUE(has(report, "the transpose of the expected one. (probably)"));
    EXPECT_FALSE(has(report, "less likely"));
    EXPECT_TRUE(has(report, "│ hello\n"));
    EXPECT_TRUE(has(report, "umbral debug projections/view-matrix 'far away'"));
    EXPECT_TRUE(has(report, "1 of 1 unit is not right yet."));
}

TEST(Terminal, what_a_check_says_keeps_its_lines_and_is_not_told_twice)
{
    UnitResult unit = transposed();
    unit.checks[1].message = "does not compile:\na.frag:5: error: unexpected '{'";
    const auto report = [&] { return terminal_report(submission_result("ana", {unit}), {}); };
    EXPECT_TRUE(has(report(), "  a.frag:5: error: unexpected '{'\n"));
    unit.message = "far away: " + unit.checks[1].message + "\n";
    EXPECT_EQ(report().find("a.frag:5"), report().rfind("a.frag:5"));
}

TEST(Terminal, a_hint_is_no_markdown)
{
    UnitResult unit = transposed();
    unit.explanations = {{"mistake: a", "Red is the **least** significant: 2 * 3 = 6.", 0.95}};
    const std::string report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_TRUE(has(report, "Red is the least significant: 2 * 3 = 6.")) << report;
}

TEST(Terminal, a_rubric_stands_line_by_line)
{
    UnitResult unit = transposed();
    unit.rubric = {{"Materiales", 1500, 2000}, {"Texturas", 2500, 2500}};
    const std::string text = unit_details(unit, 100, Paint({}));
    EXPECT_TRUE(has(text, "1.5 / 2  Materiales")) << text;
    EXPECT_TRUE(has(text, "2.5 / 2.5  Texturas")) << text;
}

TEST(Terminal, an_ambiguous_reason_is_said_to_be_one_of_several)
{
    UnitResult unit = transposed();
    unit.explanations = {{"mistake: a", "The first.", 0.95, 1, true},
                         {"mistake: b", "The second.", 0.95, 1, true},
                         {"c", "The third.", 0.9}};
    const std::string report = without_colour(terminal_report(submission_result("ana", {unit}), {}));
    EXPECT_TRUE(has(report, "why       Either: The first.\n")) << report;
    EXPECT_TRUE(has(report, " or: The second. (very likely one of these)\n")) << report;
    EXPECT_FALSE(has(report, "The third."));
}

TEST(Terminal, work_without_a_name_begins_with_its_table)
{
    const auto first_lines = [](const std::string& id) {
        return without_colour(terminal_report(submission_result(id, {transposed()}), {})).substr(0, 12);
    };
    EXPECT_TRUE(first_lines("ana").starts_with("\n  ana\n\n ")) << first_lines("ana");
    EXPECT_TRUE(first_lines("").starts_with("\n    unit")) << first_lines("");
}

TEST(Terminal, a_sketch_stands_line_by_line)
{
    UnitResult unit = transposed();
    unit.checks[1].first_difference = Difference{"pixel (1, 0) of triangle 3", "no fragment", "(0.5)"};
    unit.checks[1].sketch = "#-..\n##..\nx 0..3, y 0..1; # right - missing . empty";
    const std::string report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_TRUE(has(report, " #-..\n              ##..\n              x 0..3, y 0..1; # right - missing . empty\n"))
        << report;
    EXPECT_TRUE(has(report, "pixel (1, 0) of triangle 3"));
    EXPECT_TRUE(has(report, "no fragment"));
}

TEST(Terminal, a_difference_of_calls_stands_side_by_side)
{
    UnitResult unit = transposed();
    unit.checks[1].first_difference = Difference{"draw call 2", "glDrawArrays(GL_TRIANGLES, 3, 3)", "nothing"};
    const std::string report = terminal_report(submission_result("ana", {unit}), {.width = 100});
    EXPECT_TRUE(has(report, "yours                               expected\n")) << report;
    EXPECT_TRUE(has(report, "glDrawArrays(GL_TRIANGLES, 3, 3)    nothing\n")) << report;
}

TEST(Terminal, equal_results_give_equal_reports_and_ascii_is_ascii)
{
    const SubmissionResult submission = submission_result("ñandú", {transposed()});
    EXPECT_EQ(terminal_report(submission, {}), terminal_report(submission, {}));
    for (const char c : terminal_report(submission, {.unicode = false}))
        ASSERT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7F)) << int{c};
}

TEST(Terminal, colour_adds_nothing_but_colour)
{
    const SubmissionResult submission = submission_result("ana", {transposed()});
    const std::string coloured = terminal_report(submission, {.color = true});
    EXPECT_TRUE(has(coloured, "\x1b["));
    EXPECT_EQ(without_colour(coloured), terminal_report(submission, {.color = false}));
}

TEST(Terminal, no_line_is_wider_than_asked)
{
    std::vector<UnitResult> units = {transposed(),
                                     unit_result("raytracing/a-unit-with-a-name-that-is-far-too-long-for-any-table",
                                                 Verdict::interface_mismatch, {})};
    units[1].message = std::string(500, 'x') + " " + std::string(30, 'y');
    units[0].checks[1].name = std::string(300, 'c') + "/m";
    units[0].checks[1].artefacts = {{std::string(50, 'k'), std::string(300, 'p')}};
    units[0].checks[0].error = 1.25e-7;
    units[0].checks[0].reference_error = 1e-9;
    for (const int width : {60, 72, 80, 100, 160}) {
        const std::string report = terminal_report(submission_result(std::string(300, 'n'), units), {.width = width});
        for (const std::string_view line : lines_of(report)) {
            const bool command = line.find("umbral ") != std::string_view::npos;
            EXPECT_TRUE(command || display_width(line) <= width) << width << ": " << line;
        }
    }
}

TEST(Terminal, hidden_checks_show_no_value)
{
    CheckResult hidden = check_result("secret/t", 0, 1000, true);
    hidden.message = "LEAK-message";
    hidden.error = 77771;
    hidden.reference_error = 77772;
    hidden.metrics = {{"LEAK-metric", 77773}};
    hidden.first_difference = Difference{"LEAK-where", "LEAK-yours", "LEAK-expected"};
    hidden.artefacts = {{"triptych", "LEAK-path"}};
    hidden.sketch = "LEAK-sketch";
    UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("open/t", 1000, 1000), hidden});
    unit.explanations = {{"sign", "The sign is wrong.", 1}};
    const SubmissionResult submission = submission_result("ana", {unit});
    for (const std::string& report : {terminal_report(submission, {}), class_table({{}, {submission}}, {})}) {
        EXPECT_FALSE(has(report, "LEAK"));
        EXPECT_FALSE(has(report, "7777"));
    }
    const std::string report = terminal_report(submission, {});
    EXPECT_TRUE(has(report, "secret/t: wrong, 0 of 1 points"));
    EXPECT_TRUE(has(report, "The sign is wrong."));
    EXPECT_TRUE(has(report, "Every check that you can see is right, but a hidden one is not."));
    EXPECT_TRUE(has(report, "1 hidden check fails"));
    EXPECT_FALSE(has(report, "umbral debug")) << "no call that can be shown is answered wrongly";
}

TEST(Terminal, says_once_what_hidden_checks_look_at)
{
    std::vector<CheckResult> checks{check_result("open/t", 1000, 1000)};
    for (const char* name : {"far/low", "far/high", "near/t"}) checks.push_back(check_result(name, 0, 1000, true));
    checks[1].about = checks[2].about = "boxes far away";
    checks[3].about = "rays from near";
    const std::string report =
        terminal_report(submission_result("ana", {unit_result("a/b", Verdict::partial, checks)}), {});
    const std::size_t low = report.find("far/low:");
    const std::size_t high = report.find("far/high:");
    const std::size_t told = report.find("Looks at: boxes far away");
    const std::size_t near = report.find("near/t:");
    EXPECT_TRUE(low < high && high < told && told < near) << report;
    EXPECT_EQ(report.find("boxes far away", told + 12), std::string::npos) << report;
    EXPECT_TRUE(has(report, "Looks at: rays from near"));
}

TEST(Terminal, never_says_all_right_while_a_hidden_check_fails)
{
    UnitResult unit = unit_result("a/b", Verdict::ok,
                                  {check_result("open/t", 1000, 1000), check_result("secret/t", 999, 1000, true)});
    EXPECT_FALSE(all_right(unit));
    EXPECT_EQ(shown_verdict(unit), Verdict::partial);
    std::string report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_FALSE(has(report, "all right"));
    EXPECT_FALSE(has(report, "Everything is right"));
    EXPECT_FALSE(has(report, "✓"));
    EXPECT_FALSE(has(report, "██████████"));

    unit.checks[1].score = 1000;
    unit.score = 2000;
    report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_TRUE(has(report, "Everything is right."));
    EXPECT_TRUE(has(report, "all right"));
    EXPECT_TRUE(has(report, "██████████"));
    EXPECT_FALSE(has(terminal_report(submission_result("ana", {}), {}), "Everything is right"));
    EXPECT_FALSE(all_right(unit_result("a/b", Verdict::ok, {}))) << "no check ran";
}

TEST(Terminal, hostile_texts_are_shown_and_do_nothing)
{
    const std::string attack = "\x1b[2J\x1b]0;owned\x07\u202E\xFF\r\n\x9b";
    UnitResult unit = transposed();
    unit.id = attack;
    unit.message = attack;
    unit.output = attack;
    unit.explanations[0].sentence = attack;
    unit.checks[1].name = attack + "/" + attack;
    unit.checks[1].first_difference = Difference{attack, attack, "[1 " + attack + "; 2 3]"};
    unit.checks[1].artefacts = {{attack, attack}};
    unit.checks[1].sketch = attack;
    for (const bool color : {false, true}) {
        const SubmissionResult submission = submission_result(attack, {unit, unit});
        for (const std::string& report :
             {terminal_report(submission, {.color = color}), class_table({{}, {submission}}, {.color = color})}) {
            const std::string rest = without_colour(report);
            EXPECT_FALSE(has(report, "\x1b[2J"));
            EXPECT_EQ(rest.find_first_of("\x1b\x07\r\x7f"), std::string::npos);
            EXPECT_FALSE(has(rest, "\u202E"));
            EXPECT_EQ(rest.find('\xFF'), std::string::npos);
        }
    }
}

TEST(Terminal, a_megabyte_of_output_stays_short)
{
    for (const std::string& flood : {std::string(1 << 20, 'x'), std::string(1 << 20, '\n'),
                                     std::string(1 << 20, '\xF0'), std::string(1 << 20, '\x1b')}) {
        UnitResult unit = transposed();
        unit.output = flood;
        unit.message = flood;
        const std::string report = terminal_report(submission_result("ana", {unit}), {});
        EXPECT_LT(report.size(), 16000U);
        EXPECT_TRUE(has(report, "1048576 bytes in all"));
    }
}

TEST(Terminal, numbers_that_are_none_do_no_harm)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    UnitResult unit = transposed();
    unit.seconds = nan;
    unit.reference_seconds = -INFINITY;
    unit.explanations[0].confidence = nan;
    unit.checks[1].error = nan;
    unit.checks[0].error = INFINITY;
    unit.checks[0].metrics = {{"m", nan}};
    const std::string report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_FALSE(has(report, "nan"));
    EXPECT_FALSE(has(report, "inf"));
    EXPECT_TRUE(has(report, "(perhaps)"));
}

TEST(Terminal, a_grader_fault_is_not_blamed_on_the_student)
{
    UnitResult unit = unit_result("a/b", Verdict::grader_fault, {});
    const std::string report = terminal_report(submission_result("ana", {unit}), {});
    EXPECT_TRUE(has(report, "the grader's fault, not yours"));
    EXPECT_FALSE(has(report, "umbral hint"));
}

}
}
