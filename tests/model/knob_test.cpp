#include "manifest/knob.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <support/schema.hpp>

#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"
#include "model/curve.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;
const std::filesystem::path checkout = UMBRAL_SOURCE_DIR;

std::string message(const json& manifest)
{
    return test::message_of([&] { (void)parse_exercise(manifest, "here.json"); });
}

json with_knob(const char* check, const char* case_name)
{
    json manifest = test::manifest();
    manifest["files"] = {"phong_2.cpp"};
    manifest["knob"] = {{"name", "ray-sphere"}, {"check", check}, {"case", case_name}};
    return manifest;
}

TEST(UnitKnob, is_read)
{
    const Exercise unit = parse_exercise(with_knob("views/matrix", "picture"), "here.json");
    ASSERT_TRUE(unit.knob);
    EXPECT_EQ(*unit.knob, (UnitKnob{"ray-sphere", "views/matrix", "picture"}));
    json none = test::manifest();
    none.erase("knob");
    EXPECT_FALSE(parse_exercise(none, "here.json").knob);
}

TEST(UnitKnob, that_names_what_has_no_error_or_is_hidden_is_refused)
{
    for (const char* check : {"views/other", "picture/normals", "growth/blocks", "head-on/ids"})
        EXPECT_NE(message(with_knob(check, "picture")).find("knob.check: "), std::string::npos) << check;
    // A check of "head-on" is hidden.
    for (const char* case_name : {"nowhere", "head-on"})
        EXPECT_NE(message(with_knob("views/matrix", case_name)).find("knob.case: "), std::string::npos) << case_name;
    json hidden = with_knob("views/matrix", "picture");
    hidden["checks"][1]["hidden"] = true;
    EXPECT_NE(message(hidden).find("knob.check: "), std::string::npos);
    json more = with_knob("views/matrix", "picture");
    more["knob"]["unknown"] = 1;
    EXPECT_NE(message(more).find("unknown"), std::string::npos);
    EXPECT_NE(umbral::test::Schema("exercise").complaints(more), "");
}

// The grader knows no knob of the engine: that one named in a manifest is there is seen here.
TEST(UnitKnob, of_every_unit_is_one_that_the_bench_has)
{
    std::ifstream file(checkout / "reference/bench/accuracy/knobs.cpp");
    std::ostringstream knobs;
    knobs << file.rdbuf();
    ASSERT_NE(knobs.str().find("KnobEntry{\"ray-sphere\""), std::string::npos);
    std::size_t count = 0;
    for (const Exercise& unit : load_units(checkout / "exercises").exercises) {
        if (!unit.knob) continue;
        ++count;
        EXPECT_NE(knobs.str().find("KnobEntry{\"" + unit.knob->name + "\""), std::string::npos) << unit.id;
    }
    EXPECT_GE(count, 1U);
}

TEST(UnitCurve, with_values_that_cannot_be_drawn_is_refused)
{
    const UnitCurve curve{"k", "c/v", "c", "ulp", {"", 1, 1}, {{"reference", 0, 2}}};
    const json written = to_json(curve);
    EXPECT_EQ(to_json(curve_from_json({written, "here"})), written);
    for (const auto& [pointer, value] : std::vector<std::pair<const char*, json>>{{"/yours/error", -1},
                                                                                  {"/yours/error", nullptr},
                                                                                  {"/yours/seconds", 0},
                                                                                  {"/others/0/seconds", "1"},
                                                                                  {"/others", json::array()},
                                                                                  {"/knob", 1}}) {
        json wrong = written;
        wrong[json::json_pointer(pointer)] = value;
        EXPECT_THROW((void)curve_from_json({wrong, "here"}), std::runtime_error) << pointer << " = " << value;
    }
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(is_drawable({"", bad, 1}));
        EXPECT_FALSE(is_drawable({"", 1, bad}));
    }
    EXPECT_FALSE(is_drawable({"", 1, 0}));
    EXPECT_TRUE(is_drawable({"", 0, 1}));
}

}
}
