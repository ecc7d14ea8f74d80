#include "manifest/units.hpp"

#include <gtest/gtest.h>

#include <set>

#include "manifest_json.hpp"
#include "message_of.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

/// Writes a unit with every file that it needs.
void write_unit(const umbral::test::TemporaryFolder& folder, const std::string& id, std::optional<double> order = {})
{
    json manifest = test::manifest();
    manifest["id"] = id;
    manifest["files"] = {"stub.cpp"};
    manifest["uses"] = json::array();
    manifest.erase("order");
    if (order) manifest["order"] = *order;
    folder.write(id + "/exercise.json", manifest.dump());
    folder.write(id + "/stub.cpp", "// TODO\n");
    folder.write(id + "/driver.cpp", "// cases\n");
}

TEST(LoadExercise, finds_the_unit_and_its_folder)
{
    const umbral::test::TemporaryFolder folder;
    write_unit(folder, "meshes/normals", 3);
    const Exercise unit = load_exercise(folder.path() / "meshes/normals");
    EXPECT_EQ(unit.id, "meshes/normals");
    EXPECT_EQ(unit.folder, std::filesystem::canonical(folder.path() / "meshes/normals"));
    EXPECT_EQ(load_exercise(folder.path() / "meshes/../meshes/normals/").digest, unit.digest);
}

TEST(LoadExercise, refuses_a_unit_that_is_not_whole)
{
    const umbral::test::TemporaryFolder folder;
    const auto message = [&] {
        return test::message_of([&] { (void)load_exercise(folder.path() / "meshes/normals"); });
    };
    EXPECT_NE(message().find("exercise.json: expected a readable regular file"), std::string::npos) << message();
    write_unit(folder, "meshes/normals");
    EXPECT_EQ(message(), "nothing was thrown");
    for (const char* file : {"driver.cpp", "stub.cpp"}) {
        std::filesystem::remove(folder.path() / "meshes/normals" / file);
        EXPECT_NE(message().find(std::string(file) + ": expected a readable regular file"), std::string::npos)
            << message();
        write_unit(folder, "meshes/normals");
    }
    std::filesystem::rename(folder.path() / "meshes/normals", folder.path() / "meshes/other");
    EXPECT_NE(test::message_of([&] {
                  (void)load_exercise(folder.path() / "meshes/other");
              }).find("expected \"meshes/other\""),
              std::string::npos);
    folder.write("meshes/other/exercise.json", std::string((1 << 20) + 1, ' '));
    EXPECT_NE(
        test::message_of([&] { (void)load_exercise(folder.path() / "meshes/other"); }).find("at most 1048576 bytes"),
        std::string::npos);
}

TEST(LoadExercise, the_digest_changes_with_what_decides_the_score_and_nothing_else)
{
    const umbral::test::TemporaryFolder folder;
    write_unit(folder, "meshes/normals");
    std::filesystem::create_directories(folder.path() / "exercises");
    std::filesystem::rename(folder.path() / "meshes", folder.path() / "exercises/meshes");
    folder.write("exercises/meshes/normals/driver.cpp",
                 "#include \"shapes.hpp\"\n  #  include <kit/stage.hpp>\n#include <umbral/meshes/mesh.hpp>\n#include "
                 "<vector>\n#include \"lost.hpp\"\n");
    const auto digest = [&] { return load_exercise(folder.path() / "exercises/meshes/normals").digest; };
    std::set<std::string> seen{digest()};
    EXPECT_EQ(seen.begin()->size(), 64U);
    // Each ingredient once, also those that only others include, and those that come in a circle.
    for (const auto& [file, text] : std::vector<std::pair<const char*, const char*>>{
             {"exercises/meshes/normals/shapes.hpp", "#include \"../stage.hpp\"\n"},
             {"exercises/meshes/stage.hpp", "#include \"normals/shapes.hpp\"\n"},
             {"exercises/kit/stage.hpp", "#include \"color.hpp\"\n"},
             {"exercises/kit/color.hpp", "int color;\n"},
             {"framework/umbral/meshes/mesh.hpp", "#include <umbral/core/ray.hpp>\n"},
             {"framework/umbral/core/ray.hpp", "struct Ray;\n"},
             {"reference/meshes/normals.cpp", "#include \"render/depth.hpp\"\n"},
             {"reference/render/depth.hpp", "int depth;\n"},
             {"reference/meshes/normals_oracle.cpp", "int oracle;\n"},
             {"exercises/meshes/normals/stub.cpp", "// another TODO\n"}}) {
        folder.write(file, text);
        EXPECT_TRUE(seen.insert(digest()).second) << "made: " << file;
        folder.write(file, std::string(text) + "// changed\n");
        EXPECT_TRUE(seen.insert(digest()).second) << "changed: " << file;
    }
    json manifest = test::manifest();
    manifest["id"] = "meshes/normals";
    manifest["files"] = {"stub.cpp"};
    manifest["limits"]["wall_seconds"] = 6;
    folder.write("exercises/meshes/normals/exercise.json", manifest.dump());
    EXPECT_TRUE(seen.insert(digest()).second);

    const std::string before = digest();
    for (const char* other :
         {"exercises/meshes/normals/README.md", "exercises/meshes/normals/mistakes/one.cpp",
          "exercises/meshes/unused.hpp", "framework/umbral/meshes/unused.hpp", "reference/meshes/other.cpp"})
        folder.write(other, "text");
    EXPECT_EQ(digest(), before);
    // What is installed has no sources.
    std::filesystem::remove(folder.path() / "exercises/meshes/normals/driver.cpp");
    folder.write("exercises/meshes/normals/packaged.json", R"({"digest": "0123"})");
    EXPECT_EQ(digest(), "0123");
}

TEST(LoadUnits, have_the_digests_of_units_that_are_loaded_alone)
{
    const umbral::test::TemporaryFolder folder;
    write_unit(folder, "meshes/normals");
    write_unit(folder, "meshes/torus");
    std::filesystem::create_directories(folder.path() / "exercises");
    std::filesystem::rename(folder.path() / "meshes", folder.path() / "exercises/meshes");
    folder.write("exercises/meshes/shared.hpp", "#include \"umbral/core/ray.hpp\"\n");
    folder.write("framework/umbral/core/ray.hpp", "struct Ray;\n");
    for (const char* unit : {"normals", "torus"})
        folder.write(std::string("exercises/meshes/") + unit + "/driver.cpp", "#include \"../shared.hpp\"\n");
    const Units units = load_units(folder / "exercises");
    ASSERT_EQ(units.exercises.size(), 2U);
    for (const Exercise& unit : units.exercises) EXPECT_EQ(load_exercise(unit.folder).digest, unit.digest) << unit.id;
    EXPECT_NE(units.exercises[0].digest, units.exercises[1].digest);
}

TEST(LoadUnits, come_in_the_order_of_the_course)
{
    const umbral::test::TemporaryFolder folder;
    for (const char* topic : {"zoo", "raytracing", "interaction", "texturing", "lighting", "projections", "transforms",
                              "meshes", "pipeline", "animals"})
        write_unit(folder, std::string(topic) + "/unit");
    write_unit(folder, "lighting/a", 20);
    write_unit(folder, "lighting/c", 10);
    write_unit(folder, "lighting/b", 10);
    write_unit(folder, "lighting/aa");
    folder.write(
        "topics.txt",
        "# The "
        "order.\npipeline\nmeshes\ntransforms\n\nprojections\nlighting\ntexturing\ninteraction\nraytracing\nnone\n");
    folder.write("lighting/support.hpp", "");
    folder.write("CMakeLists.txt", "");
    folder.write("lighting/draft/notes.txt", "");
    std::vector<std::string> ids;
    for (const Exercise& unit : load_units(folder.path()).exercises) ids.push_back(unit.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"pipeline/unit", "meshes/unit", "transforms/unit", "projections/unit",
                                             "lighting/b", "lighting/c", "lighting/a", "lighting/aa", "lighting/unit",
                                             "texturing/unit", "interaction/unit", "raytracing/unit", "animals/unit",
                                             "zoo/unit"}));
}

TEST(LoadUnits, a_broken_one_keeps_no_other_from_being_loaded)
{
    const umbral::test::TemporaryFolder folder;
    write_unit(folder, "meshes/whole");
    folder.write("meshes/half/exercise.json", "{\"format\": \"umbral-ex");
    folder.write("animals/renamed/exercise.json", test::manifest().dump());
    std::filesystem::create_symlink("loop", folder / "loop");
    const Units units = load_units(folder.path());
    ASSERT_EQ(units.exercises.size(), 1U);
    EXPECT_EQ(units.exercises.front().id, "meshes/whole");
    ASSERT_EQ(units.broken.size(), 2U);
    EXPECT_EQ(units.broken[0].id, "animals/renamed");
    EXPECT_NE(units.broken[0].reason.find("id: expected \"animals/renamed\""), std::string::npos)
        << units.broken[0].reason;
    EXPECT_EQ(units.broken[1].id, "meshes/half");
    EXPECT_NE(units.broken[1].reason.find("half/exercise.json: expected JSON"), std::string::npos)
        << units.broken[1].reason;
}

TEST(LoadUnits, says_where_there_are_none)
{
    const umbral::test::TemporaryFolder folder;
    EXPECT_TRUE(load_units(folder.path()).exercises.empty());
    EXPECT_NE(
        test::message_of([&] { (void)load_units(folder.path() / "nowhere"); }).find("nowhere: expected a directory"),
        std::string::npos);
}

TEST(LimitsFor, leave_a_busy_machine_its_time_and_never_more_than_the_unit_has)
{
    const Limits unit{5, 256};
    EXPECT_DOUBLE_EQ(limits_for(unit, 0).wall_seconds, 1);
    EXPECT_DOUBLE_EQ(limits_for(unit, 0.25).wall_seconds, 3);
    EXPECT_DOUBLE_EQ(limits_for(unit, 60).wall_seconds, 5);
    EXPECT_EQ(limits_for(unit, 0.25).memory_mib, 256);
}

}
}
