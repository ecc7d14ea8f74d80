#include <gtest/gtest.h>

#include <filesystem>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "manifest/units.hpp"
#include "model/nearest.hpp"
#include "support/temporary_folder.hpp"

// Commands on a course of their own, in which one unit is whole and another is half written.
namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct Course {
    test::TemporaryFolder folder;
    Application application = make_application();

    Course()
    {
        const fs::path sphere = application.tools.exercises / "raytracing/sphere";
        fs::create_directories(folder / "exercises/raytracing");
        fs::copy(sphere, folder / "exercises/raytracing/sphere", fs::copy_options::recursive);
        fs::remove(folder / "exercises/raytracing/sphere/README.es.md");
        folder.write("exercises/raytracing/half/exercise.json", "{\"format\": \"umbral-exercise\",");
        Units units = load_units(folder / "exercises");
        application.exercises = std::move(units.exercises);
        application.broken = std::move(units.broken);
    }

    std::string complaint_about(const std::vector<std::string>& names) const
    {
        try {
            (void)application.chosen(names);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "none";
    }
};

/// What a command printed on both streams, behind it the complaint if it threw one.
std::string printed_by(Course& course, void (*add)(Command, Application&), const std::string& line)
{
    CommandLine program("umbral", "", "");
    add(program.program().command(line.substr(0, line.find(' ')), ""), course.application);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string complaint;
    try {
        EXPECT_EQ(program.run(line), "");
    } catch (const UsageError& error) {
        complaint = error.what();
    }
    std::string text = testing::internal::GetCapturedStdout();
    return text + testing::internal::GetCapturedStderr() + complaint;
}

TEST(HalfWrittenUnit, stops_only_what_needs_it)
{
    const Course course;
    ASSERT_EQ(course.application.chosen({"sphere"}).size(), 1U);
    EXPECT_NE(course.complaint_about({"half"}).find("the unit raytracing/half cannot be read: "), std::string::npos)
        << course.complaint_about({"half"});
    EXPECT_NE(course.complaint_about({"sphere", "raytracing/half/"}).find("expected JSON"), std::string::npos);
    EXPECT_NE(course.complaint_about({}).find("name the units that you mean"), std::string::npos)
        << "a class graded without it would lose its points";
    EXPECT_NE(course.complaint_about({"hlaf"}).find("there is no unit"), std::string::npos);
}

TEST(Units, are_told_from_folders)
{
    Course course;
    const std::string folder = std::filesystem::temp_directory_path().string();
    EXPECT_NE(course.complaint_about({"sphere", folder}).find("is a folder, not a unit"), std::string::npos);
    for (const char* const line : {"new raytracing/sphere", "new sphere work"})
        EXPECT_NE(printed_by(course, add_new, line).find("expected a folder for the workspace before the units"),
                  std::string::npos)
            << line;
}

TEST(Units, count_once_however_often_they_are_named)
{
    const Course course;
    EXPECT_EQ(course.application.chosen({"sphere", "raytracing/sphere", "sphere/"}).size(), 1U);
}

TEST(HalfWrittenUnit, is_warned_of_by_what_gets_along_without_it)
{
    Course course;
    testing::internal::CaptureStderr();
    EXPECT_EQ(course.application.readable().size(), 1U);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("warning: the unit raytracing/half cannot be read"),
              std::string::npos);
    const std::string listed = printed_by(course, add_list, "list");
    EXPECT_NE(listed.find("raytracing/sphere"), std::string::npos) << listed;
    EXPECT_NE(listed.find("warning: the unit raytracing/half"), std::string::npos) << listed;
    const std::string hint = printed_by(course, add_hint, "hint sphere");
    EXPECT_NE(hint.find("Hint 1 of 3"), std::string::npos) << hint;
    EXPECT_EQ(hint.find("half"), std::string::npos) << hint;
}

TEST(Languages, without_a_spanish_statement_english_is_offered)
{
    Course course;
    const std::string hint = printed_by(course, add_hint, "hint sphere 2 --language es");
    EXPECT_NE(hint.find("has no statement in that language; in English: umbral hint sphere 2"), std::string::npos)
        << hint;
    course.application.exercises.front().title.erase("es");
    EXPECT_NE(printed_by(course, add_list, "list --language es").find("Where a ray meets a sphere"), std::string::npos);
}

TEST(Nearest, counts_mistyped_letters)
{
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("chekc", "check"), 1U) << "two swapped";
    EXPECT_EQ(edit_distance("ca", "abc"), 3U) << "no letter is changed twice";
    EXPECT_EQ(edit_distance("SPHERE", "sphere"), 0U);
    for (const std::string a : {"weld", "welt", "wled", "", "ply"})
        for (const std::string b : {"weld", "area", "w", ""})
            EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
}

TEST(Nearest, finds_what_may_have_been_meant_and_nothing_else)
{
    const std::vector<std::string> known{"sphere",        "weld",         "ply",           "view-matrix",
                                         "normal-matrix", "matrix-stack", "basic-matrices"};
    EXPECT_EQ(nearest("spher", known), (std::vector<std::string>{"sphere"}));
    EXPECT_EQ(nearest("matrix", known).size(), 3U);
    EXPECT_TRUE(nearest("x", known).empty());
    EXPECT_TRUE(nearest("", known).empty());
    EXPECT_TRUE(nearest("zzzzzz", known).empty());
    EXPECT_TRUE(nearest(std::string(100000, 's'), known).empty());
    EXPECT_EQ(did_you_mean(std::vector<std::string>{"a", "b", "c"}), "; did you mean `a`, `b` or `c`?");
}

}
}
