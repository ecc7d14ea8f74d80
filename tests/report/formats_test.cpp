#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "complaint.hpp"
#include "full_disk.hpp"
#include "report/formats.hpp"
#include "results.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

const Fingerprint fingerprint{"1", "c", "cpu", "cc", "gl", "libm", {"landlock 4"}};

SubmissionResult hostile()
{
    UnitResult unit =
        unit_result("a/b", Verdict::partial, {check_result("c/v", 1, 2), check_result("s/v", 0, 2, true)});
    unit.output = "\xFF\x1b[31m\u202E";
    unit.checks[0].metrics = {{"m", std::numeric_limits<double>::quiet_NaN()}};
    unit.checks[1].message = "LEAK";
    return submission_result("\xC0", {unit});
}

/// All files of a submission with hidden values and without.
std::map<std::string, std::string> reports_of(const SubmissionResult& submission,
                                              const std::vector<std::string>& sections, bool with_hidden)
{
    const umbral::test::TemporaryFolder folder;
    std::ofstream(folder / "report.instructor.html") << "of an earlier run";
    const std::map<std::string, std::string> titles;
    write_reports(folder.path(), SubmissionReport{submission, fingerprint, titles, with_hidden, sections, sections});
    std::map<std::string, std::string> texts;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        texts[entry.path().filename()] = umbral::test::read(entry.path());
    return texts;
}

TEST(ReportFiles, hold_what_the_model_says)
{
    const SubmissionResult submission = hostile();
    const auto files = reports_of(submission, {"a section"}, true);
    ASSERT_EQ(files.size(), submission_files().size());
    const std::string& report = files.at("report.json");
    EXPECT_EQ(nlohmann::json::parse(report), to_json(submission, fingerprint));
    EXPECT_TRUE(report.starts_with("{\n  \""));
    EXPECT_TRUE(report.ends_with("}\n"));
    EXPECT_NE(report.find("LEAK"), std::string::npos);
    EXPECT_EQ(files, reports_of(submission, {"a section"}, true));

    const umbral::test::TemporaryFolder folder;
    const ClassResult all{fingerprint, {submission, submission}};
    write_reports(folder.path(), ClassReport{all, {}});
    EXPECT_EQ(nlohmann::json::parse(umbral::test::read(folder / "class.json")), to_json(all));
    EXPECT_EQ(folder.count(), class_files().size());
}

TEST(ReportFiles, show_hidden_values_on_pages_only_where_they_were_asked_for)
{
    const auto files = reports_of(hostile(), {"a section"}, false);
    EXPECT_EQ(files.count("report.instructor.html"), 0U);
    for (const char* const name : {"report.student.json", "report.html"})
        EXPECT_EQ(files.at(name).find("LEAK"), std::string::npos) << name;
    const SubmissionResult nothing = submission_result("nothing", {});
    EXPECT_EQ(reports_of(nothing, {}, true).count("report.instructor.html"), 1U);
}

TEST(ReportFiles, a_full_disk_is_an_exception_and_leaves_the_old_file)
{
    const umbral::test::TemporaryFolder folder;
    std::ofstream(folder / "report.json") << "old";
    SubmissionResult submission = hostile();
    submission.units[0].output = std::string(200000, 'x');
    const std::map<std::string, std::string> titles;
    const SubmissionReport report{submission, fingerprint, titles, false, {"a section"}};
    {
        const SmallFiles limit(1000);
        const std::string said = complaint([&] { write_reports(folder.path(), report); });
        EXPECT_NE(said.find("report.json: cannot write it: File too large"), std::string::npos) << said;
        EXPECT_NE(complaint([&] {
                      write_reports(folder.path(), ClassReport{ClassResult{fingerprint, {submission}}, {}});
                  }),
                  "");
    }
    EXPECT_EQ(umbral::test::read(folder / "report.json"), "old");
    EXPECT_EQ(folder.count(), 1);

    const FullDisk outcome =
        on_full_disk(folder, [&](const umbral::test::TemporaryFolder& disk) { write_reports(disk.path(), report); });
    EXPECT_NE(outcome, FullDisk::failed);
    if (outcome == FullDisk::cannot_mount) GTEST_SKIP() << "a real full disk needs root";
}

}
}
