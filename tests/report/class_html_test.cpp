#include <gtest/gtest.h>

#include <array>

#include "hostile.hpp"
#include "page_text.hpp"
#include "report/html/class_statistics.hpp"

namespace umbral::grader::html {
namespace {

ClassResult small_class()
{
    ClassResult result;
    const auto unit = [](Millipoints score, const char* why) {
        UnitResult one = unit_result("raytracing/sphere",
                                     score == 1000 ? Verdict::ok
                                     : score > 0   ? Verdict::partial
                                                   : Verdict::wrong,
                                     {check_result("a/b", score, 1000)});
        if (*why != '\0') one.explanations = {{why, "the sentence", 1}};
        return one;
    };
    result.submissions = {
        submission_result("ana", {unit(1000, "")}), submission_result("bruno", {unit(300, "mistake: far_root")}),
        submission_result("carla", {unit(500, "mistake: far_root")}), submission_result("diego", {unit(0, "scaled")})};
    UnitResult fault = unit_result("raytracing/sphere", Verdict::grader_fault, {});
    result.submissions.push_back(submission_result("elena", {fault}));
    return result;
}

TEST(Class, statistics_leave_out_our_faults)
{
    const std::vector<UnitStatistics> units = unit_statistics(small_class());
    ASSERT_EQ(units.size(), 1U);
    EXPECT_EQ(units[0].graded, 4U);
    EXPECT_EQ(units[0].right, 1U);
    EXPECT_DOUBLE_EQ(units[0].median, 0.4);
    EXPECT_EQ(units[0].by_share, (std::array<std::size_t, 11>{1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1}));
}

TEST(Class, almost_nothing_is_not_nothing_and_almost_all_is_not_all)
{
    ClassResult result;
    for (const Millipoints score : {1, 999999})
        result.submissions.push_back(
            submission_result("x", {unit_result("a/b", Verdict::partial, {check_result("c/d", score, 1000000)})}));
    EXPECT_EQ(unit_statistics(result)[0].by_share, (std::array<std::size_t, 11>{0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(Class, the_page_says_who_shares_a_reason)
{
    ClassResult result = small_class();
    UnitResult either = unit_result("raytracing/sphere", Verdict::partial, {check_result("a/b", 300, 1000)});
    either.explanations = {{"mistake: one", "This one.", 0.95, 1, true}, {"mistake: two", "That one.", 0.95, 1, true}};
    result.submissions.push_back(submission_result("fede", {either}));
    result.submissions.push_back(
        submission_result("gema", {unit_result("raytracing/sphere", Verdict::wrong, {check_result("a/b", 0, 1000)})}));
    const std::string page = class_html(result, {{{"raytracing/sphere", "The sphere"}}, false});
    for (const char* text : {"2 of 6", "far root<span class=\"sure\"> (very likely)", "bruno/report.html",
                             "carla/report.html", "class.json", "ana/report.student.json", "The sphere",
                             "one or two<span class=\"sure\"> (very likely one of these)", "Either: This one.",
                             "Or: That one.", "no explanation"})
        EXPECT_TRUE(has(page, text)) << text;
    EXPECT_LT(page.find("far root<"), page.find("one or two<"));
    EXPECT_LT(page.find("one or two<"), page.find("no explanation<"));
    EXPECT_FALSE(has(page, "report.instructor.html"));
    EXPECT_TRUE(has(class_html(small_class(), {{}, true}), "elena/report.instructor.html"));
}

TEST(Class, names_from_outside_become_no_links)
{
    ClassResult result;
    result.submissions = {hostile_submission("javascript:alert(1)//<script>"), hostile_submission("../../etc/passwd")};
    const std::string page = class_html(result);
    EXPECT_FALSE(has(page, "href=\"javascript"));
    EXPECT_FALSE(has(page, "href=\"../"));
    EXPECT_TRUE(has(class_html({}), "0 submissions"));
}

}
}
