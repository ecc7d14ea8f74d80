#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/authors/unit_template.hpp"
#include "manifest/units.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"
#include "validate/validate.hpp"
#include "worker/known_solutions.hpp"

// umbral new-unit, in a checkout that holds the templates, the framework's headers and one unit.
namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct Checkout {
    test::TemporaryFolder folder;
    Application application = make_application();

    Checkout()
    {
        const fs::path source = application.layout.data;
        const fs::path templates = "grader/cli/authors/templates";
        fs::create_directories((folder / templates).parent_path());
        fs::copy(source / templates, folder / templates, fs::copy_options::recursive);
        fs::copy(source / "framework", folder / "framework", fs::copy_options::recursive);
        fs::create_directories(folder / "exercises/raytracing");
        fs::create_directories(folder / "reference/bench");
        fs::copy(source / "exercises/raytracing/sphere", folder / "exercises/raytracing/sphere",
                 fs::copy_options::recursive);
        application.layout.data = folder.path();
    }

    /// What the command printed, or its complaint.
    std::string new_unit(const std::string& id)
    {
        CommandLine program("umbral", "", "");
        add_new_unit(program.program().command("new-unit", ""), application);
        testing::internal::CaptureStdout();
        std::string complaint;
        try {
            EXPECT_EQ(program.run("new-unit " + id), "");
        } catch (const UsageError& error) {
            complaint = error.what();
        }
        return testing::internal::GetCapturedStdout() + complaint;
    }

    [[nodiscard]] std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
            if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder.path()).string());
        std::ranges::sort(names);
        return names;
    }

    /// Does g++ take it, with all warnings, as it takes the project's own files?
    [[nodiscard]] test::Printed compiles(const std::string& file) const
    {
        return test::run("g++ -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow -Werror -I" +
                         (folder / "framework").string() + " " + (folder / file).string());
    }
};

void expect_whole_unit(const Checkout& checkout, const std::string& topic)
{
    const std::string unit = "exercises/" + topic + "/two-words/";
    for (const std::string& file :
         {"reference/" + topic + "/two_words.cpp", unit + "two_words.cpp", unit + "driver.cpp",
          unit + "alternatives/in_double.cpp", "tests/units/" + topic + "/two_words_test.cpp"}) {
        const test::Printed printed = checkout.compiles(file);
        EXPECT_EQ(printed.status, 0) << file << "\n" << printed.text;
    }
    const Exercise exercise = load_exercise(checkout.folder / unit);
    EXPECT_EQ(exercise.id, topic + "/two-words");
    EXPECT_TRUE(expect_statements(exercise, 1).holds);
    EXPECT_EQ(mistakes_of(checkout.folder / "reference", exercise).size(), 1U) << "the change fits the reference";
    EXPECT_EQ(alternatives_of(checkout.folder / "reference", exercise).size(), 1U);
    for (const char* const statement : {"README.md", "README.es.md"})
        EXPECT_NE(test::read(checkout.folder / unit / statement).find("[[nodiscard]] glm::vec3 two_words_point("),
                  std::string::npos)
            << statement;
    for (const std::string& file : checkout.files())
        if (file.find("two") != std::string::npos) {
            EXPECT_EQ(test::read(checkout.folder / file).find('@'), std::string::npos)
                << file << ": a mark was not filled in";
        }
}

TEST(NewUnit, is_whole_in_a_topic_that_there_is)
{
    Checkout checkout;
    const std::size_t before = checkout.files().size();
    const std::string printed = checkout.new_unit("raytracing/two-words");
    EXPECT_NE(printed.find("./umbral validate raytracing/two-words\n"), std::string::npos) << printed;
    EXPECT_EQ(checkout.files().size(), before + 10) << printed;
    expect_whole_unit(checkout, "raytracing");
}

TEST(NewUnit, is_whole_in_a_new_topic)
{
    // On both sides of "record", which its headers are sorted among.
    for (const std::string topic : {"animation", "shadows"}) {
        Checkout checkout;
        EXPECT_NE(checkout.new_unit(topic + "/two-words").find("Made the unit"), std::string::npos);
        expect_whole_unit(checkout, topic);
        EXPECT_NE(checkout.new_unit(topic + "/other").find("Made the unit"), std::string::npos) << "beside the first";
    }
}

TEST(NewUnit, overwrites_nothing)
{
    Checkout checkout;
    checkout.folder.write("reference/raytracing/mine.cpp", "my answer");
    checkout.folder.write("tests/units/raytracing/mine_test.cpp", "my test");
    const std::vector<std::string> before = checkout.files();
    const std::string complaint = checkout.new_unit("raytracing/mine");
    EXPECT_NE(complaint.find("nothing was written"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("reference/raytracing/mine.cpp, tests/units/raytracing/mine_test.cpp"), std::string::npos)
        << complaint;
    EXPECT_NE(checkout.new_unit("raytracing/sphere").find("in the way: exercises/raytracing/sphere"),
              std::string::npos);
    EXPECT_EQ(checkout.files(), before);
    EXPECT_EQ(test::read(checkout.folder / "reference/raytracing/mine.cpp"), "my answer");
}

TEST(NewUnit, refuses_names_that_cannot_be)
{
    Checkout checkout;
    const std::vector<std::string> before = checkout.files();
    for (const std::string id : {"sphere", "raytracing/", "/sphere", "a/b/c", "Raytracing/one", "raytracing/One",
                                 "raytracing/1", "raytracing/a--b", "raytracing/a-", "raytracing/a_b", "two-words/unit",
                                 "../unit", "raytracing/..", "raytracing/.a", "raytracing/ñ"}) {
        const std::string complaint = checkout.new_unit(id);
        EXPECT_NE(complaint.find("cannot be a unit's name: expected TOPIC/NAME"), std::string::npos)
            << id << ": " << complaint;
    }
    EXPECT_NE(checkout.new_unit("union/one").find("a topic that can be a namespace"), std::string::npos);
    EXPECT_NE(checkout.new_unit("raytracing/driver").find("driver.cpp"), std::string::npos);
    EXPECT_NE(checkout.new_unit("raytracing/sphere-oracle").find("another unit's oracle"), std::string::npos);
    EXPECT_NE(checkout.new_unit("record/one").find("framework/umbral/record is something else"), std::string::npos);
    EXPECT_NE(checkout.new_unit("bench/one").find("reference/bench is something else"), std::string::npos);
    EXPECT_EQ(checkout.files(), before);
    checkout.application.layout.installed = true;
    EXPECT_NE(checkout.new_unit("raytracing/one").find("in a checkout"), std::string::npos);
}

TEST(NewUnit, is_spelled_as_its_files_need_it)
{
    const UnitName name = read_unit_name("transforms/two-frames-2");
    EXPECT_EQ(filled_in("@topic@ @unit@ @file@ @title@ @test@ @other@", name),
              "transforms two-frames-2 two_frames_2 Two frames 2 TwoFrames2 @other@");
}

TEST(NewUnit, without_its_reference_is_an_error_that_names_the_file)
{
    Checkout checkout;
    checkout.new_unit("shadows/one");
    fs::remove(checkout.folder / "reference/shadows/one.cpp");
    checkout.application.tools.reference = checkout.folder / "reference";
    checkout.application.exercises = {load_exercise(checkout.folder / "exercises/shadows/one")};
    CommandLine program("umbral", "", "");
    add_validate(program.program().command("validate", ""), checkout.application);
    testing::internal::CaptureStdout();
    EXPECT_EQ(program.run("validate shadows/one"), "");
    const std::string printed = testing::internal::GetCapturedStdout();
    EXPECT_NE(
        printed.find("expected " + (checkout.folder / "reference/shadows/one.cpp").string() + ", which is not there"),
        std::string::npos)
        << printed;
    EXPECT_EQ(checkout.application.exit_status, exit_not_right);
}

// The real thing in a copy of the sources: the build and the grader's own verdict. It builds for minutes.
TEST(NewUnit, validates_at_once)
{
    if (std::getenv("UMBRAL_TEST_ALL") == nullptr)
        GTEST_SKIP() << "set UMBRAL_TEST_ALL: A NEW UNIT WAS NOT BUILT AND VALIDATED";
    const test::TemporaryFolder folder;
    const fs::path source = make_application().layout.data;
    for (const char* const part : {"CMakeLists.txt", "CMakePresets.json", "umbral", "cmake", "framework", "reference",
                                   "exercises", "grader", "docs", "LICENSE"})
        fs::copy(source / part, folder / part, fs::copy_options::recursive);
    const std::string umbral = "cd " + folder.path().string() + " && ./umbral --no-install ";
    for (const char* const unit : {"raytracing/two-words", "shadows/two-words"}) {
        const test::Printed made = test::run(umbral + "new-unit " + unit);
        ASSERT_EQ(made.status, 0) << made.text;
        const test::Printed validated = test::run(umbral + "validate " + unit);
        EXPECT_EQ(validated.status, 0) << validated.text;
    }
}

}
}
