#include <gtest/gtest.h>

#include <stdexcept>

#include "report/html/pages.hpp"
#include "results.hpp"

// A report put together from sections that were rendered, and kept, one by one.
namespace umbral::grader::html {
namespace {

SubmissionResult three_units()
{
    CheckResult hidden = check_result("random/t", 0, 2000, true);
    hidden.message = "secret-message";
    UnitResult first = unit_result("t/first", Verdict::partial, {check_result("a/b", 0, 1000), hidden});
    // What a text from outside could do to put itself where a number belongs.
    first.output = std::string("u\x01 u0 ") + '\x01';
    UnitResult second = unit_result("t/second", Verdict::wrong, {check_result("picture/x", 0, 1000)});
    return submission_result("ana",
                             {first, second, unit_result("t/third", Verdict::ok, {check_result("c/d", 1000, 1000)})});
}

UnitDetails pictures()
{
    UnitDetails details;
    PictureEvidence picture;
    picture.yours = picture.reference.emplace(Image(2, 2));
    details["t/second"].title = "The second";
    details["t/second"].checks["picture/x"].evidence = picture;
    return details;
}

TEST(Sections, give_the_page_that_the_whole_gives)
{
    const SubmissionResult submission = three_units();
    const UnitDetails details = pictures();
    for (const Edition edition : {Edition::student, Edition::instructor}) {
        std::vector<std::string> sections;
        for (const UnitResult& unit : submission.units) {
            const auto found = details.find(unit.id);
            sections.push_back(section_html(unit, found == details.end() ? UnitDetail{} : found->second, edition));
        }
        const std::string page =
            report_from_sections(submission, {}, sections, {edition, "", {{"t/second", "The second"}}});
        EXPECT_EQ(page, report_html(submission, {}, details, {edition, ""}));
        for (const char* part : {"id=\"u1\"", "id=\"u2-title\"", "id=\"u2-c1\"", "id=\"u2-c1-status\"", "href=\"#u3\""})
            EXPECT_NE(page.find(part), std::string::npos) << part;
        EXPECT_EQ(page.find('\x01'), std::string::npos);
        EXPECT_EQ(page.find("secret-message") == std::string::npos, edition == Edition::student);
    }
}

TEST(Sections, are_numbered_by_their_place)
{
    const SubmissionResult submission = three_units();
    const std::string section = section_html(submission.units[2], {}, Edition::student);
    const std::string page =
        report_from_sections(submission_result("ana", {submission.units[2]}), {}, std::vector{section});
    EXPECT_NE(page.find("id=\"u1\""), std::string::npos);
    EXPECT_THROW((void)report_from_sections(submission, {}, std::vector{section}), std::invalid_argument);
}

}
}
