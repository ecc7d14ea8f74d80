#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// What a student types, with the real program.
namespace umbral::test {
namespace {

const std::filesystem::path source = UMBRAL_SOURCE;

TEST(Commands, without_one_there_is_help_and_a_usage_error)
{
    const Printed printed = umbral("");
    EXPECT_EQ(printed.status, 2);
    EXPECT_NE(printed.text.find("--help"), std::string::npos) << printed.text;
}

TEST(Commands, help_names_every_command_and_the_exit_statuses)
{
    const Printed printed = umbral("--help");
    EXPECT_EQ(printed.status, 0);
    for (const char* word : {"list", "new", "check", "ask", "locate", "debug", "grade", "validate", "refresh", "doctor",
                             "demo", "hint", "reset", "Exit status"})
        EXPECT_NE(printed.text.find(word), std::string::npos) << word;
}

TEST(List, shows_the_units_in_both_languages_and_as_json)
{
    EXPECT_NE(umbral("list").text.find("Where a ray meets a sphere"), std::string::npos);
    EXPECT_NE(umbral("list --language es").text.find("Dónde corta un rayo a una esfera"), std::string::npos);
    const auto json = nlohmann::json::parse(umbral("list --json").text);
    EXPECT_EQ(json.at("format"), "umbral-list");
    EXPECT_GE(json.at("units").size(), 3U);
}

TEST(List, the_page_of_the_units_is_up_to_date)
{
    EXPECT_EQ(umbral("list --markdown").text, read(UMBRAL_SOURCE "/docs/units.md"))
        << "run: umbral list --markdown > docs/units.md";
}

TEST(New, makes_a_workspace_and_never_overwrites_work)
{
    const TemporaryFolder folder;
    ASSERT_EQ(umbral("new " + folder.path().string() + " sphere").status, 0);
    for (const char* file : {"sphere.cpp", "README.md", "README.es.md", "goal.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / "raytracing/sphere" / file)) << file;
    folder.write("raytracing/sphere/sphere.cpp", "// mine");
    ASSERT_EQ(umbral("new " + folder.path().string() + " sphere").status, 0);
    EXPECT_EQ(read(folder / "raytracing/sphere/sphere.cpp"), "// mine");
}

// A laboratory's machine draws each goal picture once, and the first check finds there what the reference gave.
TEST(New, goal_pictures_are_drawn_once)
{
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const std::string own_cache = "UMBRAL_CACHE='" + (folder / "cache").string() + "'";
    const auto make = [&](const std::string& name) {
        ASSERT_EQ(umbral("new '" + (folder / name).string() + "' sphere disc", own_cache).status, 0);
    };
    const auto kept_runs = [&] {
        std::map<std::string, fs::file_time_type> runs;
        for (const fs::directory_entry& one : fs::recursive_directory_iterator(folder / "cache/runs"))
            if (one.is_regular_file()) runs.emplace(one.path().string(), one.last_write_time());
        return runs;
    };
    make("first");
    const auto runs = kept_runs();
    EXPECT_GE(runs.size(), 2U);
    make("second");
    EXPECT_EQ(kept_runs(), runs);
    for (const fs::path goal : {"raytracing/sphere/goal.png", "raytracing/disc/goal.png"})
        EXPECT_EQ(read(folder / "second" / goal), read(folder / "first" / goal)) << goal;
}

TEST(New, puts_what_editors_need_at_the_root)
{
    const TemporaryFolder folder;
    ASSERT_EQ(umbral("new " + folder.path().string() + " sphere").status, 0);
    EXPECT_EQ(read(folder / "include/umbral/raytracing/intersect.hpp"),
              read(source / "framework/umbral/raytracing/intersect.hpp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "include/umbral/meshes")) << "no other unit's interface";
    EXPECT_FALSE(std::filesystem::exists(folder / "raytracing/sphere/intersect.hpp"))
        << "what lies beside the stub is handed in";
    const std::string compile =
        "cd " + folder.path().string() + " && c++ $(cat compile_flags.txt) -fsyntax-only raytracing/sphere/sphere.cpp";
    EXPECT_EQ(std::system(compile.c_str()), 0) << "as an editor compiles it";
    folder.write("compile_flags.txt", "-Wall\n");
    ASSERT_EQ(umbral("new " + folder.path().string() + " edge-table").status, 0);
    EXPECT_EQ(read(folder / "compile_flags.txt"), "-Wall\n");
    EXPECT_TRUE(std::filesystem::exists(folder / "include/umbral/meshes/mesh.hpp"))
        << "what the unit's header includes";
}

TEST(New, refuses_a_file_in_the_way)
{
    const TemporaryFolder folder;
    folder.write("taken", "");
    const Printed printed = umbral("new " + (folder / "taken").string());
    EXPECT_EQ(printed.status, 2);
    EXPECT_NE(printed.text.find("not a folder"), std::string::npos) << printed.text;
}

TEST(Check, status_says_right_short_or_misused)
{
    const TemporaryFolder folder;
    ASSERT_EQ(umbral("new " + folder.path().string() + " sphere").status, 0);
    EXPECT_EQ(umbral("check sphere --dir " + folder.path().string()).status, 1) << "the stub falls short";
    std::filesystem::copy_file(source / "reference/raytracing/sphere.cpp", folder / "raytracing/sphere/sphere.cpp",
                               std::filesystem::copy_options::overwrite_existing);
    const Printed right = umbral("check sphere --dir " + folder.path().string());
    EXPECT_EQ(right.status, 0) << right.text;
    EXPECT_NE(right.text.find("10/10"), std::string::npos) << right.text;
    // A path of a unit's folder says which workspace is meant.
    const Printed by_path = umbral("check " + (folder / "raytracing/sphere/").string());
    EXPECT_NE(by_path.text.find("10/10"), std::string::npos) << by_path.text;
    const TemporaryFolder other;
    other.write("raytracing/disc/disc.cpp", "// not yet");
    const Printed both =
        umbral("check " + (folder / "raytracing/sphere").string() + " " + (other / "raytracing/disc").string());
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.text.find("two workspaces"), std::string::npos) << both.text;
    EXPECT_EQ(umbral("check no-such-unit --dir " + folder.path().string()).status, 2);
    EXPECT_EQ(umbral("check --dir " + folder.path().string() + "/nowhere").status, 2);
    EXPECT_EQ(umbral("check --no-such-option").status, 2);
}

TEST(Check, an_unknown_back_end_is_a_usage_error_that_names_the_right_ones)
{
    const Printed printed = umbral("validate sphere", "UMBRAL_GL=vulkan");
    EXPECT_EQ(printed.status, 2) << printed.text;
    EXPECT_NE(printed.text.find("expected osmesa or egl"), std::string::npos) << printed.text;
}

TEST(Check, an_empty_folder_says_how_to_begin)
{
    const TemporaryFolder folder;
    const Printed printed = umbral("check --dir " + folder.path().string());
    EXPECT_EQ(printed.status, 2);
    EXPECT_NE(printed.text.find("umbral new"), std::string::npos) << printed.text;
}

TEST(Check, shows_the_first_failure_why_and_what_was_printed)
{
    const TemporaryFolder folder;
    const std::string mistake = read(source / "tests/class/carla-typical-mistakes/raytracing/sphere/sphere.cpp");
    const std::size_t body = mistake.find("    const glm");
    ASSERT_NE(body, std::string::npos);
    folder.write("raytracing/sphere/sphere.cpp",
                 mistake.substr(0, body) + "    std::puts(\"my debugging line\");\n" + mistake.substr(body));
    const Printed printed = umbral("check --dir " + folder.path().string());
    EXPECT_EQ(printed.status, 1);
    for (const char* word : {"yours", "expected", "why", "you return where it comes out", "my debugging line",
                             "umbral debug raytracing/sphere head-on"})
        EXPECT_NE(printed.text.find(word), std::string::npos) << word << "\n" << printed.text;
    EXPECT_TRUE(std::filesystem::exists(folder / "umbral-pictures")) << "pictures of what is wrong";
}

TEST(Check, json_is_a_report)
{
    const TemporaryFolder folder;
    folder.write("sphere.cpp", "");
    const Printed printed = umbral("check --json --dir " + folder.path().string());
    const auto json = nlohmann::json::parse(printed.text, nullptr, false);
    ASSERT_TRUE(json.is_object()) << printed.text;
    EXPECT_EQ(json.at("format"), "umbral-report");
    EXPECT_EQ(json.at("submission").at("units").at(0).at("verdict"), "interface_mismatch")
        << "an empty file defines nothing";
}

TEST(Check, what_has_not_changed_is_not_run_again)
{
    const TemporaryFolder folder;
    const std::string here = " --dir " + folder.path().string();
    const auto sphere = [&](const std::string& more) {
        std::ifstream reference(source / "reference/raytracing/sphere.cpp");
        folder.write("sphere.cpp", std::string(std::istreambuf_iterator<char>(reference), {}) + more);
    };
    constexpr const char* unchanged = "1 of 1 unit unchanged since the last check";
    sphere("// first\n");
    const Printed first = umbral("check sphere" + here);
    EXPECT_EQ(first.status, 0) << first.text;
    EXPECT_EQ(first.text.find(unchanged), std::string::npos);
    const Printed second = umbral("check sphere" + here);
    EXPECT_EQ(second.status, 0);
    EXPECT_NE(second.text.find(unchanged), std::string::npos) << second.text;
    EXPECT_EQ(second.text.find(first.text), 0U) << "the same, and one line more:\n" << second.text;
    // Whatever decides the result, or is missing of it, asks again.
    EXPECT_EQ(umbral("check sphere --fresh" + here).text.find(unchanged), std::string::npos);
    EXPECT_EQ(umbral("check sphere --attempt 7" + here).text.find(unchanged), std::string::npos);
    EXPECT_NE(umbral("check sphere --attempt 7" + here).text.find(unchanged), std::string::npos);
    std::filesystem::remove_all(folder.path() / "umbral-pictures");
    EXPECT_EQ(umbral("check sphere --attempt 7" + here).text.find(unchanged), std::string::npos)
        << "its picture was gone";
    sphere("// second\n");
    EXPECT_EQ(umbral("check sphere" + here).text.find(unchanged), std::string::npos);
    // A page needs more than a result.
    const std::string page = (folder.path() / "page.html").string();
    EXPECT_EQ(umbral("check sphere --html " + page + here).text.find(unchanged), std::string::npos);
    EXPECT_NE(umbral("check sphere --html " + page + here).text.find(unchanged), std::string::npos);
    EXPECT_GT(std::filesystem::file_size(page), 10000U);
    // A wrong result is kept as a right one is.
    folder.write("sphere.cpp", "int nothing;\n");
    const Printed wrong = umbral("check sphere" + here);
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(umbral("check sphere" + here).text.find(wrong.text), 0U);
}

TEST(Hint, goes_step_by_step)
{
    EXPECT_NE(umbral("hint sphere").text.find("Hint 1 of 3"), std::string::npos);
    EXPECT_NE(umbral("hint sphere 3").text.find("Hint 3 of 3"), std::string::npos);
    EXPECT_EQ(umbral("hint sphere 4").status, 2);
    const std::string spanish = umbral("hint sphere --language es").text;
    EXPECT_NE(spanish.find("Pista 1 de 3: Traslada"), std::string::npos) << spanish;
    EXPECT_NE(spanish.find("umbral hint sphere 2 --language es"), std::string::npos) << spanish;
}

TEST(Hint, takes_a_workspace_as_other_commands_do) { EXPECT_EQ(umbral("hint sphere --dir /tmp").status, 0); }

TEST(Reset, keeps_what_was_written)
{
    const TemporaryFolder folder;
    folder.write("raytracing/sphere/sphere.cpp", "// mine");
    ASSERT_EQ(umbral("reset sphere --dir " + folder.path().string()).status, 0);
    EXPECT_EQ(read(folder / "raytracing/sphere/sphere.cpp"), read(source / "exercises/raytracing/sphere/sphere.cpp"));
    EXPECT_EQ(read(folder / "raytracing/sphere/sphere.cpp.1.bak"), "// mine");
}

TEST(Debug, runs_one_case_as_an_ordinary_program)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "raytracing/sphere");
    std::filesystem::copy_file(source / "reference/raytracing/sphere.cpp", folder / "raytracing/sphere/sphere.cpp");
    const Printed printed = umbral("debug sphere random --no-debugger --dir " + folder.path().string());
    EXPECT_EQ(printed.status, 0) << printed.text;
    EXPECT_NE(printed.text.find("recorded t: 4000"), std::string::npos) << printed.text;
    EXPECT_EQ(umbral("debug sphere no-such-case --dir " + folder.path().string()).status, 2);
}

// The library of a unit whose work is counted calls the framework.
TEST(Debug, runs_a_unit_whose_work_is_counted)
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "meshes/weld");
    std::filesystem::copy_file(source / "reference/meshes/weld.cpp", folder / "meshes/weld/weld.cpp");
    const Printed printed = umbral("debug weld --no-debugger --dir " + folder.path().string());
    EXPECT_EQ(printed.status, 0) << printed.text;
    EXPECT_NE(printed.text.find("recorded "), std::string::npos) << printed.text;
}

TEST(Doctor, finds_what_a_graded_run_needs)
{
    const Printed printed = umbral("doctor --json");
    const auto json = nlohmann::json::parse(printed.text, nullptr, false);
    ASSERT_TRUE(json.is_object()) << printed.text;
    EXPECT_EQ(printed.status, 0) << printed.text;
    EXPECT_GE(json.at("symptoms").size(), 8U);
    for (const auto& symptom : json.at("symptoms"))
        EXPECT_TRUE(symptom.at("present").get<bool>() || !symptom.at("remedy").get<std::string>().empty());
}

}
}
