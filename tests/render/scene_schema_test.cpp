#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene_json_text.hpp"
#include "support/schema.hpp"

namespace umbral::scene::test {
namespace {

using nlohmann::json;

/// Pointers to every value below `value`.
void find_values(const json& value, const json::json_pointer& here, std::vector<json::json_pointer>& found)
{
    if (!here.empty()) found.push_back(here);
    if (value.is_structured())
        for (const auto& [key, item] : value.items())
            find_values(item, value.is_array() ? here / std::stoul(key) : here / key, found);
}

/// What a schema cannot say: comparison with other fields or names, lengths of vectors, sums.
bool is_beyond_a_schema(const std::string& message)
{
    for (const char* beyond :
         {"1.01 times near", "another place than the eye", "a direction of length", "stands twice", "of size 0.0001",
          "texels in all", "triangles in all", "expected one of \"", "no name: none", "without a texture", "no index",
          "a whole number from 0 to 2", "deep, and none within itself", "a distance from the axis",
          "in its place for a light", "a list of 3 to 3 items, got a list"})
        if (message.find(beyond) != std::string::npos) return true;
    return message.find(".uvs: expected a list of") != std::string::npos;
}

TEST(SceneSchema, agrees_with_the_program_on_variants_of_a_scene)
{
    const umbral::test::Schema schema("scene");
    ASSERT_EQ(schema.complaints(document()), "");
    ASSERT_EQ(message_of(document().dump()), "nothing was thrown");
    std::vector<json::json_pointer> places;
    find_values(document(), json::json_pointer(), places);
    const std::vector<json> values = {nullptr,   true,          0,         1,          -1,
                                      2,         0.5,           200,       5000,       1e9,
                                      "",        "checker",     "flat",    "a\nb",     json::array(),
                                      {0, 0, 0}, {1, 2},        {1, 2, 3}, {-1, 2, 3}, {1, 2, 3, 4},
                                      {"a"},     json::object()};
    int refused = 0;
    int compared = 0;
    const auto compare = [&](const json& variant, const std::string& what) {
        const std::string message = message_of(variant.dump());
        if (is_beyond_a_schema(message)) return;
        ++compared;
        refused += message == "nothing was thrown" ? 0 : 1;
        EXPECT_EQ(message == "nothing was thrown", schema.complaints(variant).empty())
            << what << "\nprogram: " << message << "\nschema: " << schema.complaints(variant);
    };
    for (const json::json_pointer& place : places) {
        json variant = document();
        if (variant[place].is_object()) {
            variant[place]["unknown"] = 1;
            compare(variant, place.to_string() + "/unknown");
            variant = document();
        }
        if (variant[place.parent_pointer()].is_object()) {
            variant[place.parent_pointer()].erase(place.back());
            compare(variant, "without " + place.to_string());
        }
        for (const json& value : values) {
            variant = document();
            variant[place] = value;
            compare(variant, place.to_string() + " = " + value.dump());
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(compared - refused, 100);
}

/// Every named field has a description.
void expect_described(const json& schema, const json::json_pointer& here)
{
    if (schema.contains("properties")) {
        for (const auto& [key, value] : schema["properties"].items())
            EXPECT_TRUE(value.contains("description") || value.contains("$ref")) << here / key;
    }
    if (schema.is_structured())
        for (const auto& [key, value] : schema.items())
            expect_described(value, schema.is_array() ? here / std::stoul(key) : here / key);
}

TEST(SceneSchema, describes_every_field) { expect_described(umbral::test::read_schema("scene"), json::json_pointer()); }

TEST(SceneSchema, accepts_the_scenes_of_the_course)
{
    const umbral::test::Schema schema("scene");
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(UMBRAL_SOURCE_DIR "/reference/scenes")) {
        if (entry.path().extension() != ".json") continue;
        ++scenes;
        std::ifstream file(entry.path());
        EXPECT_EQ(schema.complaints(json::parse(file)), "") << entry.path();
        EXPECT_NO_THROW((void)read_scene(entry.path()));
    }
    EXPECT_GT(scenes, 0);
}

}
}
