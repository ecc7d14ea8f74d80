#include <gtest/gtest.h>
#include <sys/stat.h>

#include "../model/message_of.hpp"
#include "store/distinct_folders.hpp"
#include "store/refused_folder.hpp"
#include "store/report_folder.hpp"
#include "store/reports_folder.hpp"
#include "store/temporaries.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using umbral::test::TemporaryFolder;

const Grading grading{"cg", 1, "0123456789abcdef"};

unsigned mode_of(const fs::path& path)
{
    struct stat status {};
    return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(DistinctFolders, reports_never_lie_among_the_submissions)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "class/ana");
    fs::create_directories(folder / "beside");
    fs::create_directory_symlink(folder / "class", folder / "link");
    fs::create_directory_symlink(folder / "class/ana", folder / "beside/deep");
    const auto refusal = [&](const char* submissions, const fs::path& out) {
        return message_of([&] { expect_distinct(folder / submissions, folder / out); });
    };
    const std::string real = fs::canonical(folder.path()).string();
    for (const char* out : {"class", "class/", "class/.", "class/../class", "link", "link/", "beside/../link"}) {
        EXPECT_TRUE(has(refusal("class", out), "is the folder of the submissions"))
            << out << ": " << refusal("class", out);
        EXPECT_TRUE(has(refusal("class", out), real + "/class")) << "the paths themselves are named";
        EXPECT_TRUE(has(refusal("link", out), "is the folder of the submissions")) << out;
    }
    for (const char* out :
         {"class/out", "class/ana", "class/not/yet/there", "link/out", "beside/deep", "beside/deep/out"})
        EXPECT_TRUE(has(refusal("class", out), "lies in the folder of the submissions"))
            << out << ": " << refusal("class", out);
    for (const char* out : {"", ".", "class/..", "beside/.."})
        EXPECT_TRUE(has(refusal("class", out), "holds the folder of the submissions")) << out;
    for (const char* out : {"out", "class2", "beside", "beside/out", "clas", "class/../out"})
        EXPECT_EQ(refusal("class", out), "nothing was thrown") << out;
}

TEST(DistinctFolders, no_secret_lies_where_students_read)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "class/ana");
    fs::create_directory_symlink(folder / "class/ana", folder / "link");
    for (const char* file : {"class/secret", "class/ana/secret", "link/secret"})
        EXPECT_THROW(expect_outside("the submissions", folder / "class", "--secret-file", folder / file), RefusedFolder)
            << file;
    for (const char* file : {"secret", "classes/secret", "class/../secret"})
        EXPECT_NO_THROW(expect_outside("the submissions", folder / "class", "--secret-file", folder / file)) << file;
}

TEST(ReportsFolder, is_made_for_this_user_only_marked_and_locked)
{
    const TemporaryFolder folder;
    const fs::path out = folder / "a/b/out";
    {
        const ReportsFolder first(out, grading);
        EXPECT_EQ(first.path(), fs::canonical(out));
        EXPECT_EQ(first.grading(), grading);
        EXPECT_EQ(mode_of(out / mark_name), 0600U);
        EXPECT_TRUE(has(message_of([&] { const ReportsFolder second(out, grading); }), "another `umbral grade`"));
    }
    const ReportsFolder again(out, {"other", 2, "x"});
    EXPECT_EQ(again.grading(), grading) << "what is there stays until somebody says otherwise";
}

TEST(ReportsFolder, becomes_that_of_another_grading_and_stays_locked)
{
    const TemporaryFolder folder;
    const Grading other{"other course", 2, "fedcba9876543210"};
    ReportsFolder out(folder / "out", grading);
    out.set_grading(other);
    EXPECT_TRUE(
        has(message_of([&] { const ReportsFolder second(folder / "out", grading); }), "another `umbral grade`"));
    EXPECT_EQ(read_mark(folder / "out")->grading, other);
}

TEST(ReportsFolder, refuses_what_umbral_did_not_make)
{
    const TemporaryFolder folder;
    folder.write("mine/thesis.tex", "years of work");
    folder.write("file", "no folder");
    folder.write("odd/umbral-reports.json", "{}");
    folder.write("newer/umbral-reports.json", R"({"format": "umbral-reports", "version": 2})");
    fs::create_directories(folder / "linked");
    folder.write("mark.json", to_text({.grading = grading}));
    fs::create_symlink(folder / "mark.json", folder / "linked/umbral-reports.json");
    for (const char* name : {"mine", "file", "odd", "newer", "linked"})
        EXPECT_THROW(ReportsFolder(folder / name, grading), RefusedFolder) << name;
    EXPECT_TRUE(fs::exists(folder / "mine/thesis.tex"));
    fs::create_directories(folder / "empty");
    folder.write("killed/umbral-reports.json.tmp-123-0", "{");
    for (const char* name : {"empty", "killed"}) EXPECT_NO_THROW(ReportsFolder(folder / name, grading)) << name;
    EXPECT_FALSE(fs::exists(folder / "killed/umbral-reports.json.tmp-123-0"));
}

TEST(ReportsFolder, removes_its_own_temporaries_and_nothing_else)
{
    const TemporaryFolder folder;
    {
        const ReportsFolder made(folder / "out", grading);
    }
    for (const char* name : {"class.json.tmp-1-0", "index.html.tmp-77-3"})
        folder.write(std::string("out/") + name, "half");
    for (const char* name : {"notes.tmp-1-0", "class.json.tmp-1", "class.json.old", "grades.csv"})
        folder.write(std::string("out/") + name, "mine");
    fs::create_directories(folder / "out/class.json.tmp-2-0");
    const ReportsFolder out(folder / "out", grading);
    for (const char* name : {"class.json", "index.html"}) out.tidy(name);
    EXPECT_FALSE(fs::exists(folder / "out/class.json.tmp-1-0"));
    EXPECT_FALSE(fs::exists(folder / "out/index.html.tmp-77-3"));
    for (const char* name : {"notes.tmp-1-0", "class.json.tmp-1", "class.json.old", "grades.csv", "class.json.tmp-2-0"})
        EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
}

TEST(ReportsFolder, lists_marked_folders_only)
{
    const TemporaryFolder folder;
    const ReportsFolder out(folder / "out", grading);
    for (const char* id : {"bo", "ana"}) {
        Mark mark = open_report_folder(out.folder_of(id), id);
        set_mark(out.folder_of(id), mark);
    }
    fs::create_directories(folder / "out/mine");
    folder.write("out/odd/umbral-reports.json", "not JSON");
    fs::copy(folder / "out/ana", folder / "out/copied", fs::copy_options::recursive);
    fs::create_directory_symlink(folder / "out/ana", folder / "out/linked");
    EXPECT_EQ(out.submissions(), (std::vector<std::string>{"ana", "bo"}));
}

// What lies there goes to one student.
TEST(ReportsFolder, is_no_submission_s)
{
    const TemporaryFolder folder;
    Mark mark = open_report_folder(folder / "ana", "ana");
    set_mark(folder / "ana", mark);
    EXPECT_THROW(ReportsFolder(folder / "ana", grading), RefusedFolder);
}

TEST(ReportFolder, is_for_one_submission_of_ours)
{
    const TemporaryFolder folder;
    Mark mark = open_report_folder(folder / "ana", "ana");
    EXPECT_EQ(mode_of(folder / "ana"), 0700U);
    EXPECT_EQ(mark.submission, "ana");
    EXPECT_EQ(mark.reports, "");
    EXPECT_NO_THROW((void)open_report_folder(folder / "ana", "ana")) << "killed before the mark was set";
    mark.grading = grading;
    mark.shown = "Ana \"Añ\x1b";
    mark.reports = "digest";
    set_mark(folder / "ana", mark);
    const Mark read = open_report_folder(folder / "ana", "ana");
    EXPECT_EQ(read.grading, grading);
    EXPECT_EQ(read.reports, "digest");
    EXPECT_THROW((void)open_report_folder(folder / "ana", "bo"), RefusedFolder);
    folder.write("mine/thesis.tex", "");
    folder.write("file", "");
    fs::create_directory_symlink(folder / "ana", folder / "link");
    for (const char* name : {"mine", "file", "link"})
        EXPECT_THROW((void)open_report_folder(folder / name, "ana"), RefusedFolder) << name;
}

// Whoever had the folder before may have left anything in it.
TEST(ReportFolder, touches_nothing_behind_a_link)
{
    const TemporaryFolder folder;
    set_mark(folder / "ana", open_report_folder(folder / "ana", "ana"));
    for (const char* const name : {"pictures", "units"}) {
        folder.write("mine/thesis.txt", "years of work");
        folder.write("mine/sphere.unit", "no result");
        folder.write("mine/a.json.tmp-1-0", "mine as well");
        fs::create_directories(folder / "mine/empty");
        fs::remove(folder / "ana" / name);
        fs::create_directory_symlink(folder / "mine", folder / "ana" / name);
        remove_pictures(folder / "ana", {"pictures/thesis.txt", "pictures/../../mine/thesis.txt"});
        tidy_temporaries(folder / "ana");
        EXPECT_TRUE(kept_units(folder / "ana").empty());
        forget_units(folder / "ana");
        const std::string refusal = message_of([&] { (void)open_report_folder(folder / "ana", "ana"); });
        EXPECT_TRUE(has(refusal, name) && has(refusal, "it is a link or a file")) << refusal;
        for (const char* const mine : {"thesis.txt", "sphere.unit", "a.json.tmp-1-0", "empty"})
            EXPECT_TRUE(fs::exists(folder / "mine" / mine)) << mine;
        fs::remove(folder / "ana" / name);
    }
    EXPECT_NO_THROW((void)open_report_folder(folder / "ana", "ana"));
}

TEST(ReportFolder, knows_its_units_and_sweeps_its_pictures)
{
    const TemporaryFolder folder;
    for (const auto& file :
         {unit_file(folder.path(), "a/two-words"), fault_file(folder.path(), "a/b"), unit_file(folder.path(), "a/b")})
        folder.write(fs::relative(file, folder.path()), "x");
    EXPECT_EQ(kept_units(folder.path()), (std::vector<std::string>{"a/b", "a/two-words"}));
    for (const char* name : {"pictures/old.png", "pictures/new.png", "pictures/new.png.tmp-5-0",
                             "units/a_b.unit.tmp-5-0", "report.html.tmp-5-0"})
        folder.write(name, "x");
    tidy_temporaries(folder.path());
    folder.write("notes.txt", "mine");
    remove_pictures(folder.path(), {"pictures/old.png", "pictures/never.png", "notes.txt", "pictures/../notes.txt"});
    EXPECT_TRUE(fs::exists(folder / "pictures/new.png"));
    EXPECT_TRUE(fs::exists(folder / "notes.txt"));
    for (const char* name :
         {"pictures/old.png", "pictures/new.png.tmp-5-0", "units/a_b.unit.tmp-5-0", "report.html.tmp-5-0"})
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    forget_units(folder.path());
    EXPECT_TRUE(kept_units(folder.path()).empty());
    remove_pictures(folder.path(), {"pictures/new.png"});
    EXPECT_FALSE(fs::exists(folder / "pictures"));
    EXPECT_NO_THROW(remove_pictures(folder.path(), {"pictures/new.png"}));
}

TEST(Temporaries, are_told_from_other_names)
{
    for (const char* name : {"class.json.tmp-1-0", "a.tmp-123-45", "a.tmp-x.tmp-1-2"})
        EXPECT_TRUE(is_temporary(name)) << name;
    for (const char* name : {"", ".tmp-1-0", "class.json", "class.json.tmp-", "class.json.tmp-1", "class.json.tmp-1-",
                             "class.json.tmp--1", "class.json.tmp-1-0a", "class.json.tmp-1-0-1"})
        EXPECT_FALSE(is_temporary(name)) << name;
    EXPECT_TRUE(is_temporary("class.json.tmp-1-0", "class.json"));
    EXPECT_FALSE(is_temporary("xclass.json.tmp-1-0", "class.json"));
}

}
}
