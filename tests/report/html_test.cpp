#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "hostile.hpp"
#include "page_text.hpp"
#include "report/html/base64.hpp"
#include "text/utf8.hpp"

namespace umbral::grader::html {
namespace {

/// The page without its styles and scripts, which are ours.
std::string body_of(const std::string& page)
{
    const std::size_t begin = page.find("<body>");
    return page.substr(begin, page.rfind("<script>") - begin);
}

TEST(Report, nothing_from_outside_becomes_markup)
{
    const std::string harmless = body_of(hostile_page("x"));
    for (const char* text : {"</script><script>alert(1)</script>", "<img src=x onerror=alert(1)>", "\"><b>",
                             "' onmouseover='alert(1)", "<!--", "]]>", "{{script}}", "&lt;", "</style>"}) {
        const std::string body = body_of(hostile_page(text));
        EXPECT_EQ(count_of(body, "<"), count_of(harmless, "<"))
            << "no element more than with a harmless text: " << text;
        EXPECT_EQ(count_of(body, "\""), count_of(harmless, "\"")) << text;
        EXPECT_FALSE(has(body, "<script")) << text;
        EXPECT_FALSE(has(body, "<img src=x")) << text;
    }
}

TEST(Report, any_bytes_give_a_valid_page)
{
    const unsigned seed = 11;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 60; ++round) {
        std::string bytes(1 + random() % 30, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        const std::string page = hostile_page(bytes);
        for (std::string_view rest = page; !rest.empty(); rest.remove_prefix(first_character(rest).size)) {
            const Character character = first_character(rest);
            ASSERT_TRUE(character.valid);
            ASSERT_TRUE(character.code == '\n' || (character.code >= 0x20 && character.code != 0x7F &&
                                                   !(character.code >= 0x80 && character.code < 0xA0)));
        }
        ASSERT_EQ(count_of(body_of(page), "<"), count_of(body_of(hostile_page("x")), "<"));
    }
}

TEST(Report, the_policy_allows_its_own_style_and_script_and_nothing_else)
{
    const std::string page = hostile_page("x");
    EXPECT_TRUE(has(page, "default-src 'none'; img-src data:; style-src 'sha256-"));
    for (const char* element : {"style", "script"}) {
        const std::string open = std::string("<") + element + ">";
        const std::size_t begin = page.find(open) + open.size();
        const std::string text = page.substr(begin, page.find(std::string("</") + element, begin) - begin);
        EXPECT_TRUE(has(page, std::string(element) + "-src '" + source_hash(text) + "'")) << element;
    }
    // Inline styles and handlers would be refused by that policy; addresses would not be fetched.
    EXPECT_FALSE(has(body_of(page), " style="));
    EXPECT_FALSE(has(body_of(page), " onclick="));
    for (const char* scheme : {"http:", "https:", "//www", "url(", "@import"})
        EXPECT_FALSE(has(page.substr(0, page.rfind("<script>")), scheme)) << scheme;
}

TEST(Report, buffers_stand_before_pictures_and_numbers_before_buffers)
{
    std::vector<CheckResult> checks = {check_result("a/colour", 0, 1000), check_result("b/ids", 0, 1000),
                                       check_result("c/right", 1000, 1000), check_result("d/numbers", 0, 1000),
                                       check_result("e/list", 0, 1000)};
    const std::vector<JudgeKind> kinds = {JudgeKind{"image"}, JudgeKind{"buffer"}, JudgeKind{"fragments"},
                                          JudgeKind{"numbers"}, JudgeKind{"events"}};
    for (std::size_t i = 0; i < checks.size(); ++i) checks[i].kind = kinds[i];
    const UnitResult unit = unit_result("t/u", Verdict::partial, checks);
    UnitDetails details;
    PictureEvidence picture;
    picture.yours = Image(2, 2);
    details["t/u"].checks["a/colour"].evidence = picture;
    const std::string page = report_html(submission_result("s", {unit}), {}, details, {});
    std::size_t last = 0;
    for (const char* name : {"e/list</h3>", "d/numbers</h3>", "b/ids</h3>", "a/colour</h3>"}) {
        const std::size_t at = page.find(name);
        ASSERT_NE(at, std::string::npos) << name;
        EXPECT_GT(at, last) << name;
        last = at;
    }
    EXPECT_FALSE(has(page, "c/right</h3>"));
}

TEST(Report, what_was_not_judged_is_not_called_wrong)
{
    UnitResult unit = unit_result("t/u", Verdict::timeout, {check_result("a/x", 0, 1000)});
    const auto page = [&] { return report_html(submission_result("s", {unit}), {}, {}, {}); };
    EXPECT_TRUE(has(page(), "class=\"points\">wrong, 0"));
    unit.checks[0].unjudged = Unjudged::not_run;
    EXPECT_TRUE(has(page(), "class=\"points\">not run, 0"));
}

TEST(Report, a_students_edition_holds_nothing_of_hidden_checks)
{
    CheckResult hidden = check_result("random/t", 0, 2000, true);
    hidden.message = "secret-message";
    hidden.error = 12345.678;
    hidden.first_difference = Difference{"secret-where", "secret-yours", "secret-expected"};
    UnitResult unit =
        unit_result("raytracing/sphere", Verdict::partial, {check_result("head-on/t", 1000, 1000), hidden});
    unit.explanations = {{"far", "You return the far root.", 1}};
    UnitDetails details;
    details[unit.id].checks["random/t"].why = "as measured";
    RowsEvidence rows;
    rows.first = {{"row 1", {"secret-value"}, {"secret-truth"}, {true}, ""}};
    details[unit.id].checks["random/t"].evidence = rows;

    const std::string student = report_html(submission_result("ana", {unit}), {}, details);
    EXPECT_FALSE(has(student, "secret-"));
    EXPECT_FALSE(has(student, "12345"));
    EXPECT_FALSE(has(student, "1.23e+04"));
    EXPECT_TRUE(has(student, "random/t")) << "its name is shown";
    EXPECT_TRUE(has(student, "You return the far root."));
    EXPECT_FALSE(has(student, "All 1 units"));

    const std::string instructor =
        report_html(submission_result("ana", {unit}), {}, details, {Edition::instructor, ""});
    for (const char* text : {"secret-message", "secret-value", "secret-truth", "instructor"})
        EXPECT_TRUE(has(instructor, text)) << text;
}

TEST(Report, of_long_questions_the_first_is_seen_and_the_others_unfold)
{
    const UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("one/x", 0, 1000)});
    for (const int side : {0, 3}) {
        RowsEvidence rows;
        rows.side = side;
        for (const char* row : {"row 1", "row 2", "row 3"}) {
            rows.first.push_back({row, {"1"}, {"2"}, {true}, ""});
            rows.first.back().question = "ask(" + std::string(400, '9') + ")";
        }
        rows.first[1].question = "ask(9)";
        UnitDetails details;
        details["a/b"].checks["one/x"].evidence = rows;
        const std::string page = report_html(submission_result("s", {unit}), {}, details);
        const std::size_t folded = page.find("<summary>what was asked</summary>");
        EXPECT_GT(folded, page.find("row 3")) << side;
        EXPECT_NE(folded, std::string::npos) << side;
        EXPECT_EQ(page.find("<summary>what was asked</summary>", folded + 1), std::string::npos) << side;
    }
}

TEST(Report, why_comes_first_then_what_was_printed_then_checks)
{
    UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("one/x", 0, 1000)});
    unit.explanations = {{"e", "EXPLAINED", 1}};
    unit.message = "DIAGNOSED";
    unit.output = "PRINTED";
    const std::string page = report_html(submission_result("s", {unit}), {}, {});
    const std::size_t section = page.find("id=\"u1\"");
    const std::size_t why = page.find("EXPLAINED", section);
    EXPECT_LT(why, page.find("DIAGNOSED", section));
    EXPECT_LT(page.find("PRINTED", section), page.find("one/x", section));
    EXPECT_LT(why, page.find("PRINTED", section));
}

TEST(Report, a_unit_that_never_ran_lists_no_checks)
{
    UnitResult unit = unit_result("a/b", Verdict::compile_error, {check_result("one/x", 0, 1000)});
    unit.message = "b.cpp:3: error: expected ';'";
    const std::string page = report_html(submission_result("s", {unit}), {}, {});
    EXPECT_TRUE(has(page, "What the compiler says"));
    EXPECT_TRUE(has(page, "expected &#39;;&#39;"));
    EXPECT_FALSE(has(page, "one/x"));
}

TEST(Report, empty_and_huge_submissions_give_pages)
{
    EXPECT_TRUE(has(report_html({}, {}, {}), "No unit was graded."));
    std::vector<UnitResult> units(200, unit_result("topic/unit", Verdict::wrong, {check_result("c/v", 0, 1)}));
    for (UnitResult& unit : units) unit.output = std::string(10000, '<');
    EXPECT_TRUE(has(report_html(submission_result(std::string(10000, 'x'), units), {}, {}), "id=\"u200\""));
    UnitResult odd = unit_result("a/b", Verdict::partial, {check_result("c/v", 0, 0)});
    odd.seconds = odd.reference_seconds = std::numeric_limits<double>::quiet_NaN();
    odd.checks[0].error = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(has(report_html(submission_result("x", {odd}), {}, {}), "width=\"nan"));
}

TEST(Report, equal_results_give_equal_pages) { EXPECT_EQ(hostile_page("same"), hostile_page("same")); }

TEST(Report, an_ambiguous_reason_is_said_to_be_one_of_several)
{
    UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("one/x", 0, 1000)});
    unit.explanations = {
        {"mistake: a", "FIRST.", 0.95, 1, true}, {"mistake: b", "SECOND.", 0.95, 1, true}, {"c", "THIRD.", 0.7}};
    const std::string page = report_html(submission_result("s", {unit}), {}, {});
    EXPECT_TRUE(has(page, "FIRST. Or: SECOND.")) << "in the table of units";
    EXPECT_TRUE(has(page, "Either:</span> FIRST."));
    EXPECT_TRUE(has(page, "Or:</span> SECOND."));
    EXPECT_TRUE(has(page, "very likely one of these"));
    EXPECT_TRUE(has(page, "THIRD. <span class=\"sure\">(probably)"));
    unit.explanations.resize(1);
    unit.explanations[0].ambiguous = false;
    EXPECT_TRUE(has(report_html(submission_result("s", {unit}), {}, {}), "That is very likely the reason."));
}

}
}
