#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/temporary_folder.hpp"
#include "support/without_times.hpp"

// The sample class, graded by the real program: every kind of submission gets the verdict a teacher would give.
namespace umbral::test {
namespace {

using nlohmann::json;

const std::string sample = UMBRAL_SOURCE "/tests/class";

Printed grade(const std::string& folder, const TemporaryFolder& out, const std::string& before = "",
              const std::string& units = "")
{
    out.write("secret", "the same secret gives the same hidden cases");
    return umbral("grade " + folder + units + " --jobs 2 --out " + (out / "out").string() + " --secret-file " +
                      (out / "secret").string(),
                  before);
}

/// Graded once for all tests of this file.
const json& graded()
{
    static const json result = [] {
        const TemporaryFolder out;
        const Printed printed = grade(sample, out, "", " --handed-in");
        EXPECT_EQ(printed.status, 0) << printed.text;
        json all = json::parse(read(out / "out/class.json"));
        for (const auto& submission : all.at("submissions"))
            EXPECT_TRUE(
                std::filesystem::exists(out / ("out/" + submission.at("id").get<std::string>() + "/report.json")));
        return all;
    }();
    return result;
}

const json& unit_of(const std::string& submission, const std::string& unit)
{
    for (const auto& one : graded().at("submissions"))
        if (one.at("id") == submission)
            for (const auto& candidate : one.at("units"))
                if (candidate.at("id") == unit) return candidate;
    throw std::runtime_error("no " + unit + " of " + submission);
}

struct Expected {
    const char* submission;
    const char* sphere;
    const char* view_matrix;
    const char* shaders;
};

class SampleClass : public testing::TestWithParam<Expected> {};

TEST_P(SampleClass, gets_its_verdicts)
{
    const Expected& expected = GetParam();
    EXPECT_EQ(unit_of(expected.submission, "raytracing/sphere").at("verdict"), expected.sphere);
    EXPECT_EQ(unit_of(expected.submission, "projections/view-matrix").at("verdict"), expected.view_matrix);
    EXPECT_EQ(unit_of(expected.submission, "lighting/shaders").at("verdict"), expected.shaders);
}

INSTANTIATE_TEST_SUITE_P(
    Everyone, SampleClass,
    testing::Values(Expected{"ana-all-right", "ok", "ok", "ok"},
                    Expected{"bruno-untouched", "not_implemented", "not_implemented", "not_implemented"},
                    Expected{"carla-typical-mistakes", "partial", "partial", "partial"},
                    Expected{"diego-different", "ok", "ok", "ok"},
                    Expected{"elena-does-not-compile", "compile_error", "interface_mismatch", "compile_error"},
                    Expected{"fede-endless-loop", "partial", "partial", "partial"},
                    Expected{"gema-crash", "crashed", "crashed", "interface_mismatch"},
                    Expected{"hugo-eats-memory", "out_of_memory", "out_of_memory", "partial"},
                    Expected{"irene-half-finished", "partial", "partial", "missing"},
                    Expected{"mallory-hostile", "blocked", "forbidden", "timeout"}),
    [](const auto& instance) {
        std::string name = instance.param.submission;
        for (char& c : name) c = c == '-' ? '_' : c;
        return name;
    });

TEST(Class, typical_mistakes_are_explained)
{
    for (const char* unit : {"raytracing/sphere", "projections/view-matrix", "lighting/shaders"}) {
        const json& why = unit_of("carla-typical-mistakes", unit).at("explanation");
        ASSERT_FALSE(why.empty()) << unit;
        EXPECT_TRUE(why.at(0).at("name").get<std::string>().starts_with("mistake: ")) << why;
    }
}

TEST(Class, an_endless_loop_costs_only_its_case)
{
    const json& unit = unit_of("fede-endless-loop", "raytracing/sphere");
    EXPECT_GT(unit.at("score"), 6000);
    for (const auto& check : unit.at("checks"))
        EXPECT_EQ(check.at("message").get<std::string>().find("never ends") != std::string::npos,
                  check.at("name") == "long direction/t")
            << check;
}

TEST(Class, a_crash_names_its_text_and_place)
{
    const std::string message = unit_of("gema-crash", "raytracing/sphere").at("message");
    EXPECT_NE(message.find("sphere.cpp:9"), std::string::npos) << message;
    EXPECT_NE(message.find("direction must be shorter than 1"), std::string::npos) << message;
}

TEST(Class, no_attack_of_the_hostile_one_worked)
{
    const json& unit = unit_of("mallory-hostile", "raytracing/sphere");
    const std::string printed = unit.at("stdout");
    EXPECT_EQ(unit.at("score"), 0);
    EXPECT_EQ(printed.find("WORKED"), std::string::npos) << printed;
    EXPECT_EQ(printed.find("REPLACED"), std::string::npos) << printed;
    for (const char* attack : {"read /etc/passwd", "read the reference", "read /proc/self/maps",
                               "write through /proc/self/mem", "write a report of its own", "open a socket", "fork",
                               "run a shell", "kill its parent", "trace its parent", "read its parent's memory"})
        EXPECT_NE(printed.find(attack), std::string::npos) << attack << " was not even tried";
    for (const char* word : {"ana-", "secret", "millipoints", "oracle", "carla-"})
        EXPECT_NE(printed.find("heap: the word '" + std::string(word) + "' occurs 0 times"), std::string::npos)
            << printed;
    EXPECT_NE(unit_of("mallory-hostile", "projections/view-matrix").at("message").get<std::string>().find("lookAt"),
              std::string::npos);
}

TEST(Class, a_second_grading_agrees_but_for_times)
{
    // A unit of each kind: numbers, pictures of OpenGL, traces of its calls, counted work, events.
    const TemporaryFolder out;
    ASSERT_EQ(grade(sample, out, "",
                    " --unit sphere --unit shaders --unit draw-deferred --unit vertex-normals --unit callbacks")
                  .status,
              0);
    const json second = json::parse(read(out / "out/class.json"));
    for (const auto& submission : second.at("submissions")) {
        ASSERT_EQ(submission.at("units").size(), 5U);
        for (const auto& unit : submission.at("units"))
            EXPECT_EQ(without_times(unit), without_times(unit_of(submission.at("id"), unit.at("id"))));
    }
}

TEST(Grade, handed_in_means_units_of_which_there_is_a_file)
{
    const TemporaryFolder folder;
    for (const char* const who : {"a", "b", "mallory"})
        folder.write(std::string("class/") + who + "/sphere.cpp", "// nothing yet");
    // What hardly anybody handed in is in nobody's sum, whoever did.
    folder.write("class/mallory/meshes/vertex-normals/vertex_normals.cpp", "// nothing yet");
    const Printed printed = grade((folder / "class").string(), folder, "", " --handed-in");
    EXPECT_EQ(printed.status, 0);
    EXPECT_NE(printed.text.find("1 unit is in no sum"), std::string::npos) << printed.text;
    EXPECT_NE(printed.text.find("mallory: meshes/vertex-normals"), std::string::npos) << printed.text;
    const json graded = json::parse(read(folder / "out/class.json"));
    ASSERT_EQ(graded.at("submissions").size(), 3U);
    for (const json& submission : graded.at("submissions")) {
        ASSERT_EQ(submission.at("units").size(), 1U);
        EXPECT_EQ(submission.at("units").at(0).at("id"), "raytracing/sphere");
    }
    EXPECT_EQ(graded.at("left_out").at(0).at("submissions"), json::array({"mallory"}));
    std::filesystem::create_directories(folder / "idle/c");
    const Printed idle = grade((folder / "idle").string(), folder, "", " --handed-in");
    EXPECT_EQ(idle.status, 2);
    EXPECT_NE(idle.text.find("nobody handed in"), std::string::npos) << idle.text;
}

TEST(Grade, bad_input_is_a_usage_error_that_says_what_to_do)
{
    const TemporaryFolder folder;
    EXPECT_EQ(grade((folder / "nowhere").string(), folder).status, 2);
    std::filesystem::create_directories(folder / "class/José Pérez");
    // A name that is no id gets one; the report says both.
    EXPECT_EQ(grade((folder / "class").string(), folder, "", " --unit sphere").status, 0);
    const json odd = json::parse(read(folder / "out/class.json")).at("submissions").at(0);
    EXPECT_EQ(odd.at("folder"), "José Pérez");
    EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + odd.at("id").get<std::string>() + "/report.html")));
    std::filesystem::create_directories(folder / "empty");
    const Printed empty = grade((folder / "empty").string(), folder);
    EXPECT_EQ(empty.status, 2);
    EXPECT_NE(empty.text.find("no submission"), std::string::npos) << empty.text;
    const std::string one = "grade " + (folder / "class").string() + " --out " + (folder / "out2").string();
    EXPECT_EQ(umbral(one + " --roster /dev/zero").status, 2) << "of no end";
    EXPECT_EQ(umbral(one + " --secret-file " + (folder / "class/secret").string()).status, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "class/secret"));
    folder.write("short", "abc");
    std::filesystem::create_directories(folder / "one/a");
    EXPECT_EQ(umbral("grade " + (folder / "one").string() + " --out " + (folder / "out").string() + " --secret-file " +
                     (folder / "short").string())
                  .status,
              2);
}

TEST(Grade, a_full_disk_is_a_fault_that_leaves_no_half_report)
{
    const TemporaryFolder folder;
    folder.write("class/a/sphere.cpp", read(UMBRAL_SOURCE "/exercises/raytracing/sphere/sphere.cpp"));
    // No file may grow beyond 1 KiB: a report does not fit. SIGXFSZ is ignored, so that writing fails as on a full
    // disk.
    const Printed printed = grade((folder / "class").string(), folder, "trap '' XFSZ; ulimit -f 1;");
    EXPECT_EQ(printed.status, 3) << printed.text;
    EXPECT_FALSE(std::filesystem::exists(folder / "out/class.json"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out/a/report.json"));
}

}
}
