#include "model/relation.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/schema.hpp>

#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

constexpr const char* picture = "/checks/3";
constexpr const char* relation = "/checks/3/relation";

/// The manifest of all tests with a relation of its picture.
json manifest()
{
    json all = test::manifest();
    all[json::json_pointer(relation)] =
        json::parse(R"({"to": "upright", "unlike": "turned", "shift": [3, -5], "scale": 2, )"
                    R"("what": "rotating both must not change the picture"})");
    return all;
}

TEST(RelationManifest, is_read_field_by_field)
{
    const Exercise unit = parse_exercise(manifest(), "here.json");
    ASSERT_TRUE(unit.checks[3].relation.has_value());
    const Relation& found = *unit.checks[3].relation;
    EXPECT_EQ(found.to, "upright");
    EXPECT_EQ(found.unlike, "turned");
    EXPECT_EQ(found.shift, (std::array{3, -5}));
    EXPECT_EQ(found.scale, 2);
    EXPECT_EQ(found.what, "rotating both must not change the picture");
    EXPECT_TRUE(found.moves() && found.scales());
    EXPECT_FALSE(unit.checks[0].relation.has_value());
}

TEST(RelationManifest, may_leave_out_what_does_nothing)
{
    json all = manifest();
    all[json::json_pointer(relation)] =
        json::parse(R"({"to": "upright", "scale": 0.5, "what": "half the light is half as bright"})");
    const Relation half = *parse_exercise(all, "here.json").checks[3].relation;
    EXPECT_TRUE(half.scales() && !half.moves() && half.unlike.empty());
    all[json::json_pointer(relation)] = json::parse(R"({"to": "upright", "unlike": "turned", "what": "the same"})");
    const Relation same = *parse_exercise(all, "here.json").checks[3].relation;
    EXPECT_FALSE(same.scales() || same.moves());
}

TEST(RelationManifest, each_wrong_field_is_refused_by_name_by_the_program_and_the_schema)
{
    struct Wrong {
        const char* pointer;
        const char* value;  ///< null: taken away
        const char* message;
        bool schema_sees = true;
    };
    const umbral::test::Schema schema("exercise");
    ASSERT_EQ(schema.complaints(manifest()), "");
    for (const Wrong& wrong : {
             Wrong{"/checks/3/relation", "true", "relation: expected an object"},
             Wrong{"/checks/3/relation/too", "1", "relation.too: expected no field of this name"},
             Wrong{"/checks/3/relation/to", nullptr, "relation.to: "},
             Wrong{"/checks/3/relation/to", "\"a/b\"", "relation.to: expected a recorded name"},
             Wrong{"/checks/3/relation/to", "\"a.margin\"", "relation.to: expected a recorded name"},
             Wrong{"/checks/3/relation/to", "\"normals\"",
                   "relation.to: expected another value of the case than the check's own, 'normals'", false},
             Wrong{"/checks/3/relation/unlike", "\"upright\"", "relation.unlike: expected a third value", false},
             Wrong{"/checks/3/relation/unlike", "\"normals\"", "relation.unlike: expected a third value", false},
             Wrong{"/checks/3/relation/unlike", "7", "relation.unlike: "},
             Wrong{"/checks/3/relation/shift", "[0, 0]", "relation.shift: ", false},
             Wrong{"/checks/3/relation/shift", "[1]", "relation.shift: "},
             Wrong{"/checks/3/relation/shift", "[0.5, 1]", "relation.shift[0]: "},
             Wrong{"/checks/3/relation/shift", "[9999, 1]", "relation.shift[0]: "},
             Wrong{"/checks/3/relation/scale", "0", "relation.scale: "},
             Wrong{"/checks/3/relation/scale", "1", "relation.scale: "},
             Wrong{"/checks/3/relation/scale", "-2", "relation.scale: "},
             Wrong{"/checks/3/relation/what", nullptr, "relation.what: "},
             Wrong{"/checks/3/relation/what", "\"The same.\"", "relation.what: expected the law"},
         }) {
        json all = manifest();
        const json::json_pointer pointer(wrong.pointer);
        if (wrong.value != nullptr)
            all[pointer] = json::parse(wrong.value);
        else
            all[pointer.parent_pointer()].erase(pointer.back());
        const std::string message = test::message_of([&] { (void)parse_exercise(all, "here.json"); });
        EXPECT_NE(message.find(std::string("here.json: checks[3].") + wrong.message), std::string::npos) << message;
        if (wrong.schema_sees) {
            EXPECT_NE(schema.complaints(all), "")
                << wrong.pointer << " " << (wrong.value != nullptr ? wrong.value : "taken away");
        }
    }
}

TEST(RelationManifest, fits_judges_that_compare_values)
{
    const auto refused = [](int check, const char* text) {
        json all = manifest();
        all[json::json_pointer(picture)].erase("relation");
        all["checks"][static_cast<std::size_t>(check)]["relation"] = json::parse(text);
        EXPECT_NE(umbral::test::Schema("exercise").complaints(all), "") << check << text;
        return test::message_of([&] { (void)parse_exercise(all, "here.json"); });
    };
    const char* same = R"({"to": "a", "unlike": "b", "what": "the same"})";
    EXPECT_NE(refused(4, same).find("checks[4].relation: expected no relation, since the judge is \"trace\""),
              std::string::npos);
    EXPECT_NE(refused(5, same).find("since the judge is \"cost\""), std::string::npos);
    EXPECT_NE(refused(0, same).find("since the check is \"hard\""), std::string::npos);
    EXPECT_NE(refused(1, R"({"to": "a", "shift": [1, 1], "what": "moved"})")
                  .find("checks[1].relation.shift: expected no shift"),
              std::string::npos);
    EXPECT_NE(refused(2, R"({"to": "a", "what": "the same"})")
                  .find("checks[2].relation.unlike: expected a value that must differ"),
              std::string::npos);
    json rows = manifest();
    rows[json::json_pointer(picture)].erase("range");
    rows[json::json_pointer(picture)]["judge"] = "fragments";
    EXPECT_NE(
        test::message_of([&] { (void)parse_exercise(rows, "here.json"); }).find("relation.scale: expected no scale"),
        std::string::npos);
}

}
}
