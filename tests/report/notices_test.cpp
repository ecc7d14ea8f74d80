#include "report/notices.hpp"

#include <gtest/gtest.h>

#include "page_text.hpp"
#include "report/html/pages.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

UnitResult fault(const std::string& unit, const std::string& cause)
{
    UnitResult result = unit_result(unit, Verdict::grader_fault, {});
    result.message = std::string(fault_preface) + cause;
    result.unscored = 10000;
    return result;
}

/// Thirty submissions whose builds met a full disk, and one of which more is wrong.
ClassResult full_disk()
{
    ClassResult result;
    for (int i = 0; i < 30; ++i)
        result.submissions.push_back(
            submission_result("s" + std::to_string(i),
                              {fault("t/one", "/cache/work-" + std::to_string(i) + ": No space left on device")}));
    result.submissions[3].units.push_back(fault("t/two", "the spawner <died>\x1b[31m"));
    return result;
}

TEST(Notices, say_each_cause_once_with_points_and_remedy)
{
    const std::vector<Notice> found = notices(full_disk());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].headline, "30 units of 30 submissions are not scored: 300 points are in no sum.");
    EXPECT_EQ(found[0].cause, "/cache/work-0: No space left on device.");
    EXPECT_TRUE(has(found[0].remedy, "Free some space")) << found[0].remedy;
    EXPECT_TRUE(has(found[0].remedy, "only what is missing is graded.")) << found[0].remedy;
    EXPECT_TRUE(has(who_in_words(found[0]), "s0: t/one; s1: t/one; ")) << who_in_words(found[0]);
    EXPECT_TRUE(has(who_in_words(found[0]), " and 18 more")) << who_in_words(found[0]);
    EXPECT_EQ(found[1].headline, "1 unit of 1 submission is not scored: 10 points are in no sum.");
    EXPECT_TRUE(notices({}).empty());
}

TEST(Notices, stand_above_the_table_on_terminal_and_page)
{
    const ClassResult result = full_disk();
    const std::string terminal = class_notices(result, {.width = 80});
    EXPECT_EQ(count_of(terminal, "No space left on device"), 1U) << terminal;
    EXPECT_FALSE(has(terminal, "\x1b[31m")) << "what a submission caused to be said is escaped";
    EXPECT_EQ(class_notices({}, {}), "");
    const std::string page = html::class_html(result);
    EXPECT_EQ(count_of(page, "No space left on device"), 1U);
    EXPECT_LT(page.find("300 points are in no sum"), page.find("<table class=\"class\""));
    EXPECT_TRUE(has(page, "The spawner &lt;died&gt;"));
    EXPECT_FALSE(has(html::class_html({}), "<ul class=\"notices\""));
}

TEST(Notices, tell_of_what_is_unfinished_unwritten_or_graded_elsewhere)
{
    ClassResult result;
    result.unfinished = {"ana", "bo", "dan"};
    result.elsewhere = {"cy"};
    result.left_out = {{"lighting/phong", {"mallory"}}, {"raytracing/disc", {"mallory"}}};
    result.unwritten = {{"ana", "/out/ana: the reports of ana belong here, but Umbral did not make this folder"},
                        {"", "/out/class.json: cannot write it: Disk quota exceeded"}};
    const std::vector<Notice> found = notices(result);
    ASSERT_EQ(found.size(), 5U);
    EXPECT_EQ(found[0].headline, "The reports of 1 submission could not be written.");
    EXPECT_TRUE(has(found[0].remedy, "Move that away")) << found[0].remedy;
    EXPECT_EQ(found[1].headline, "class.json and index.html could not be written.");
    EXPECT_EQ(found[1].who.size(), 0U);
    EXPECT_EQ(who_in_words(found[2]), "bo; dan") << "ana's trouble is told already";
    EXPECT_TRUE(found[2].fault);
    EXPECT_EQ(found[3].headline, "2 units are in no sum: hardly anybody handed them in.");
    EXPECT_EQ(who_in_words(found[3]), "mallory: lighting/phong, raytracing/disc");
    EXPECT_FALSE(found[3].fault);
    EXPECT_EQ(who_in_words(found[4]), "cy");
    EXPECT_FALSE(found[4].fault);
}

TEST(Class, the_median_leaves_out_who_was_not_scored)
{
    ClassResult result;
    result.submissions = {
        submission_result("ana", {unit_result("t/one", Verdict::ok, {check_result("a/b", 1000, 1000)})}),
        submission_result("bo", {fault("t/one", "x")}), submission_result("cy", {fault("t/one", "x")})};
    EXPECT_TRUE(has(html::class_html(result), "median credit 100 %"));
}

TEST(Class, missing_work_stands_among_the_reasons)
{
    ClassResult result;
    result.submissions = {
        submission_result("ana", {unit_result("t/one", Verdict::missing, {}),
                                  unit_result("t/two", Verdict::wrong, {check_result("a/b", 0, 1000)})}),
        submission_result("bo", {unit_result("t/one", Verdict::ok, {check_result("a/b", 1000, 1000)})})};
    const std::string page = html::class_html(result);
    const std::size_t list = page.find("Not handed in</h3>");
    ASSERT_NE(list, std::string::npos);
    EXPECT_LT(page.find("no explanation"), list) << "what fails comes first";
    EXPECT_NE(page.find("1 of 2", list), std::string::npos);
    EXPECT_NE(page.find("ana/report.html", list), std::string::npos);
}

}
}
