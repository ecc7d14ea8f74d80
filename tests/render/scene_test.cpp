#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene_json_text.hpp"
#include "scenes.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::scene::test {
namespace {

using nlohmann::json;

TEST(SceneFile, is_read_as_it_is_written)
{
    const Scene scene = parse_scene(document().dump(), "s.json");
    EXPECT_EQ(scene.title, "One of each");
    EXPECT_EQ(scene.camera.eye, glm::vec3(0, 1, 5));
    EXPECT_EQ(scene.camera.up, glm::vec3(0, 1, 0));
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_FALSE(scene.lights[0].positional);
    EXPECT_TRUE(scene.lights[1].positional);
    EXPECT_EQ(scene.lights[1].color, glm::vec3(1));
    ASSERT_EQ(scene.textures.size(), 4U);
    ASSERT_EQ(scene.geometries.size(), 10U);
    EXPECT_EQ(scene.geometries[7].name, "tri");
    EXPECT_EQ(std::get<Triangles>(scene.geometries[7].shape).triangles[0], glm::uvec3(0, 1, 2));
    ASSERT_EQ(scene.instances.size(), 6U) << "two things, and the four wheels of a train";
    EXPECT_EQ(scene.geometries[scene.instances[0].geometry].name, "ball");
    EXPECT_EQ(scene.materials[scene.instances[1].material].name, "shiny");
    EXPECT_EQ(scene.textures[*scene.materials[scene.instances[1].material].texture].name, "squares");
    ASSERT_EQ(scene.instances[0].transforms.size(), 3U);
    EXPECT_EQ(std::get<Rotate>(scene.instances[0].transforms[1]).degrees, 30);
    EXPECT_FALSE(scene.instances[0].smooth);
    EXPECT_EQ(scene.instances[0].sides, Sides::both);
}

struct Refusal {
    const char* pointer;
    json value;
    std::vector<std::string> says;
};

// Each names the file, the place, what was expected and what came.
TEST(SceneFile, is_refused_with_the_place_and_both_values)
{
    const std::vector<Refusal> refusals = {
        {"/format", "umbral-exercise", {"format", "\"umbral-scene\"", "\"umbral-exercise\""}},
        {"/version", 2, {"version", "from 1 to 1", "got 2"}},
        {"/colour", 1, {"colour", "no field of this name (known are: format, version", "got 1"}},
        {"/camera/fov", 40, {"camera.fov", "fovy_degrees"}},
        {"/camera/fovy_degrees", 180, {"camera.fovy_degrees", "from 1 to 170", "got 180"}},
        {"/camera/near", 0, {"camera.near", "got 0"}},
        {"/camera/far", 0.2, {"camera.far", "1.01 times near"}},
        {"/camera/target", {0, 1, 5}, {"camera.target", "another place than the eye"}},
        {"/camera/up", {0, 0, 0}, {"camera.up", "a direction", "[0,0,0]"}},
        {"/camera/eye", {0, 1}, {"camera.eye", "3 to 3 items"}},
        {"/camera/eye", {0, 1, "5"}, {"camera.eye[2]", "a number", "\"5\""}},
        {"/camera/eye", {0, 1, 1e7}, {"camera.eye[2]", "1000000"}},
        {"/lights/0/position", {0, 0, 0}, {"lights[0]", "either \"position\""}},
        {"/lights/1/name", "sun", {"lights", "\"sun\" stands twice"}},
        {"/lights/1/color", {0, -1, 0}, {"lights[1].color[1]", "from 0 to 1000", "-1"}},
        {"/textures/squares/kind", "granite", {"textures.squares.kind", "checker", "uv-grid", "\"granite\""}},
        {"/textures/squares/size", 4097, {"textures.squares.size", "4096"}},
        {"/textures/squares/size", 2.5, {"textures.squares.size", "a whole number"}},
        {"/textures/map/colors", {{0, 0, 0}, {1, 1, 1}}, {"textures.map.colors", "no colors"}},
        {"/materials/shiny/texture", "wood", {"materials.shiny.texture", "\"squares\"", "\"wood\""}},
        {"/materials/shiny/exponent", "high", {"materials.shiny.exponent", "a number", "\"high\""}},
        {"/materials/dull/bump", "oak", {"materials.dull", "\"bump\"", "\"bump_height\"", "together"}},
        {"/materials/shiny/bump", "bark", {"materials.shiny.bump", "\"oak\"", "\"bark\""}},
        {"/geometries/pot/subdivisions", 1, {"geometries.pot.subdivisions", "from 2 to 1024"}},
        {"/geometries/statue/field", "horse", {"geometries.statue.field", "\"mandelbulb\"", "\"horse\""}},
        {"/geometries/scan/file", "scan.stl", {"geometries.scan.file", "ends in .obj or .ply", "\"scan.stl\""}},
        {"/geometries/scan/package", "x; reboot", {"geometries.scan.package", "a Debian package's name"}},
        {"/geometries/statue/cells", 257, {"geometries.statue.cells", "from 8 to 256"}},
        {"/geometries/ball/rings", 1, {"geometries.ball.rings", "from 2 to 1024"}},
        {"/geometries/ball/tube", 0.2, {"geometries.ball.tube", "known are: kind, rings, sectors"}},
        {"/geometries/tri/triangles/0/2", 3, {"geometries.tri.triangles[0][2]", "from 0 to 2", "got 3"}},
        {"/geometries/tri/uvs", {{0, 0}}, {"geometries.tri.uvs", "3 to 3 items"}},
        {"/instances/0/geometry", "cube", {"instances[0].geometry", "\"ball\"", "\"cube\""}},
        {"/instances/0/geometry", 0, {"instances[0].geometry", "got 0"}},
        {"/instances/1/name", "first", {"instances", "\"first\" stands twice"}},
        {"/instances/1/geometry", "bare", {"instances[1].material", "without a texture", "\"bare\""}},
        {"/instances/0/transforms/0", {{"shear", 1}}, {"instances[0].transforms[0].shear", "translate, rotate, scale"}},
        {"/instances/0/transforms/0", json::object(), {"instances[0].transforms[0]", "exactly one"}},
        {"/instances/0/transforms/0", {{"scale", {1, 0, 1}}}, {"instances[0].transforms[0].scale", "0.0001"}},
        {"/instances/0/transforms/0",
         {{"rotate", {{"axis", {0, 0, 0}}, {"degrees", 1}}}},
         {"instances[0].transforms[0].rotate.axis", "a direction"}},
        {"/geometries/vase/profile/1", {-1, 0}, {"geometries.vase.profile[1]", "from the axis", "[-1,0]"}},
        {"/geometries/vase/profile", json::array(), {"geometries.vase.profile", "2 to 4096 items"}},
        {"/instances/0/transforms/0",
         {{"swing", {{"axis", {0, 1, 0}}, {"degrees", 1}, {"period", 0}}}},
         {"instances[0].transforms[0].swing.period", "got 0"}},
        {"/instances/0/transforms/0", {{"spin", 1}, {"move", 1}}, {"instances[0].transforms[0]", "exactly one"}},
        {"/instances/0/shading", "gouraud", {"instances[0].shading", "\"flat\", \"smooth\""}},
        {"/instances", "none", {"instances", "a list", "\"none\""}},
        {"/materials/a~1b", 5, {"materials[\"a/b\"]", "an object", "got 5"}},
    };
    for (const Refusal& refusal : refusals) {
        json root = document();
        root[json::json_pointer(refusal.pointer)] = refusal.value;
        const std::string message = message_of(root.dump());
        EXPECT_TRUE(message.starts_with("s.json: " + refusal.says.front() + ": expected ")) << message;
        EXPECT_NE(message.find(", got "), std::string::npos) << message;
        for (const std::string& part : refusal.says)
            EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
    }
}

TEST(SceneFile, must_be_json)
{
    for (const char* text : {"", "{", "[1,]", "{\"format\": nan}", "\xFF\xFE", "{} {}", "// scene\n{}"}) {
        const std::string message = message_of(text);
        EXPECT_TRUE(message.starts_with("s.json: expected JSON, got text that is not: ")) << message;
    }
    for (const char* text : {"null", "[]", "3", "\"umbral-scene\"", "{}"})
        EXPECT_TRUE(message_of(text).starts_with("s.json: ")) << text;
    EXPECT_NE(message_of(R"({"format": "umbral-scene", "format": "umbral-scene"})").find("\"format\" twice"),
              std::string::npos);
    EXPECT_NE(message_of(std::string(100000, '[')).find("at most 16 deep"), std::string::npos);
    EXPECT_NE(message_of("{\"version\": 1e999}").find("s.json: "), std::string::npos);
}

TEST(SceneFile, has_limits)
{
    json many = document();
    for (int i = 0; i < 17; ++i) many["lights"].push_back({{"name", "l" + std::to_string(i)}, {"towards", {0, 1, 0}}});
    EXPECT_NE(message_of(many.dump()).find("lights: expected a list of 0 to 16"), std::string::npos);

    many = document();
    for (int i = 0; i < 3; ++i)
        many["textures"]["t" + std::to_string(i)] = {{"kind", "uv-grid"}, {"size", 4096}, {"cells", 4}};
    EXPECT_NE(message_of(many.dump()).find("texels in all"), std::string::npos);

    many = document();
    many["geometries"]["huge"] = {{"kind", "plane"}, {"rows", 1024}, {"columns", 1024}};
    EXPECT_EQ(message_of(many.dump()), "nothing was thrown");
    for (int i = 0; i < 4; ++i)
        many["instances"].push_back({{"name", "h" + std::to_string(i)}, {"geometry", "huge"}, {"material", "dull"}});
    EXPECT_NE(message_of(many.dump()).find("instances: expected at most 8388608 triangles in all"), std::string::npos);
}

TEST(SceneFile, must_be_a_readable_file)
{
    const umbral::test::TemporaryFolder folder;
    const auto says = [](const std::filesystem::path& file) {
        try {
            (void)read_scene(file);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(says(folder / "none.json").find("none.json: expected a readable regular file, got nothing"),
              std::string::npos);
    EXPECT_NE(says(folder.path()).find("expected a readable regular file"), std::string::npos);
    EXPECT_NE(says("/dev/zero").find("expected a readable regular file"), std::string::npos);
    folder.write("large.json", std::string(maximum_file_bytes + 1, ' '));
    EXPECT_NE(says(folder / "large.json").find("expected at most 16777216 bytes"), std::string::npos);
}

TEST(SceneFile, first_light_is_one) { EXPECT_EQ(render::test::first_light().instances.size(), 5U); }

}
}
