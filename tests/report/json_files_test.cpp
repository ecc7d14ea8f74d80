#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "complaint.hpp"
#include "full_disk.hpp"
#include "report/hidden.hpp"
#include "report/json_files.hpp"
#include "results.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

SubmissionResult hostile()
{
    UnitResult unit = unit_result("a/b", Verdict::partial, {check_result("c/v", 1, 2), check_result("s/v", 0, 2, true)});
    unit.output = "\xFF\x1b[31m\u202E";
    unit.checks[0].metrics = {{"m", std::numeric_limits<double>::quiet_NaN()}};
    unit.checks[1].message = "LEAK";
    return submission_result("\xC0", {unit});
}

TEST(JsonFiles, HoldWhatTheModelSays)
{
    const umbral::test::TemporaryFolder folder;
    const SubmissionResult submission = hostile();
    const Fingerprint fingerprint{"1", "c", "cpu", "cc", "gl", "libm", {"landlock 4"}};
    write_report_json(folder / "report.json", submission, fingerprint);
    write_class_json(folder / "class.json", {fingerprint, {submission, submission}});
    const std::string report = text_of(folder / "report.json");
    EXPECT_EQ(nlohmann::json::parse(report), to_json(submission, fingerprint));
    EXPECT_EQ(nlohmann::json::parse(text_of(folder / "class.json")), to_json(ClassResult{fingerprint, {submission, submission}}));
    EXPECT_TRUE(report.starts_with("{\n  \""));
    EXPECT_TRUE(report.ends_with("}\n"));
    EXPECT_EQ(folder.count(), 2);

    write_report_json(folder / "again.json", submission, fingerprint);
    EXPECT_EQ(text_of(folder / "again.json"), report);
    EXPECT_NE(report.find("LEAK"), std::string::npos);
    write_report_json(folder / "student.json", without_hidden_values(submission), fingerprint);
    EXPECT_EQ(text_of(folder / "student.json").find("LEAK"), std::string::npos);
}

TEST(JsonFiles, AFullDiskIsAnExceptionAndLeavesTheOldFile)
{
    const umbral::test::TemporaryFolder folder;
    std::ofstream(folder / "report.json") << "old";
    SubmissionResult submission = hostile();
    submission.units[0].output = std::string(200000, 'x');
    {
        const SmallFiles limit(1000);
        const std::string said = complaint([&] { write_report_json(folder / "report.json", submission, {}); });
        EXPECT_NE(said.find("report.json: cannot write it: File too large"), std::string::npos) << said;
        EXPECT_NE(complaint([&] { write_class_json(folder / "report.json", {{}, {submission}}); }), "");
    }
    EXPECT_EQ(text_of(folder / "report.json"), "old");
    EXPECT_EQ(folder.count(), 1);

    const FullDisk outcome = on_full_disk(folder, [&](const umbral::test::TemporaryFolder& disk) { write_report_json(disk / "b.json", submission, {}); });
    EXPECT_NE(outcome, FullDisk::failed);
    if (outcome == FullDisk::cannot_mount) GTEST_SKIP() << "a real full disk needs root";
}

}
}
