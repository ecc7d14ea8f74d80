#include <gtest/gtest.h>

#include <limits>

#include "judge/cost/cost.hpp"
#include "judge/parameters.hpp"
#include "judge/trace/trace_counts.hpp"
#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"
#include "model/forbidden_families.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

Exercise parse(const json& manifest) { return parse_exercise(manifest, "here.json"); }

TEST(Manifest, reads_every_field)
{
    const Exercise unit = parse(test::manifest());
    EXPECT_EQ(unit.id, "lighting/phong-2");
    EXPECT_EQ(unit.topic, "lighting");
    EXPECT_EQ(unit.name, "phong-2");
    EXPECT_EQ(unit.files, (std::vector<std::string>{"phong.vert", "phong_2.cpp"}));
    EXPECT_EQ(unit.points, 4875);
    EXPECT_EQ(unit.uses, (std::vector<std::string>{"transforms/rotation", "lighting/lambert"}));
    EXPECT_EQ(unit.forbid, (std::vector<std::string>{"glm::lookAt", "operator new"}));
    EXPECT_TRUE(unit.gl);
    EXPECT_EQ(unit.title.at("es"), "Sombreado de Phong");
    EXPECT_EQ(unit.course, std::vector<std::string>{"problem 4.1"});
    EXPECT_EQ(unit.order, 12.5);
    EXPECT_EQ(unit.limits.wall_seconds, 7.5);
    EXPECT_EQ(unit.limits.memory_mib, 1024);
    EXPECT_TRUE(unit.digest.empty());
    EXPECT_TRUE(unit.is_cpp());
    EXPECT_TRUE(unit.has_oracle());
    EXPECT_EQ(unit.cases(), (std::vector<std::string>{"head-on", "views", "picture", "frames", "growth"}));

    ASSERT_EQ(unit.checks.size(), 6U);
    const Check& first = unit.checks[0];
    EXPECT_EQ(first.name, "head-on/t");
    EXPECT_EQ(first.judge, JudgeKind{"numbers"});
    EXPECT_EQ(first.points, 2005);
    EXPECT_TRUE(first.hard && first.pairs && !first.hidden);
    EXPECT_EQ(first.tolerance.absolute, 1e-6);
    EXPECT_EQ(first.tolerance.relative, 2e-6);
    EXPECT_EQ(first.tolerance.ulps, 4);
    EXPECT_EQ(first.tolerance.band_ulps, 2);
    EXPECT_EQ(first.full, 0.9);
    EXPECT_EQ(first.zero, 0.5);
    EXPECT_EQ(first.why, "one root rounds");
    EXPECT_FALSE(unit.checks[1].tolerance.absolute.has_value());
    EXPECT_EQ(unit.checks[1].tolerance.ulps, 0) << "a bound of 0 is a bound";
    EXPECT_EQ(unit.checks[2].judge, JudgeKind{"buffer"});
    EXPECT_TRUE(unit.checks[2].hidden);
    EXPECT_EQ(unit.checks[3].range_low, -1);
    EXPECT_EQ(unit.checks[3].range_high, 1);
    EXPECT_EQ(unit.checks[4].judge, JudgeKind{"trace"});
    EXPECT_EQ(parameters_of<TraceParameters>(unit.checks[4]).rules,
              (std::vector<std::string>{"draw calls", "uploaded bytes"}));
    EXPECT_EQ(unit.checks[5].judge, JudgeKind{"cost"});
    EXPECT_EQ(parameters_of<CostParameters>(unit.checks[5]).growth, 1.5);
    EXPECT_TRUE(unit.counts_work);
}

TEST(Manifest, fills_in_what_may_be_left_out)
{
    json manifest = test::manifest();
    for (const char* name : {"uses", "forbid", "gl", "course", "order", "limits"}) manifest.erase(name);
    const Exercise unit = parse(manifest);
    EXPECT_TRUE(unit.uses.empty() && unit.forbid.empty() && unit.course.empty() && !unit.gl && !unit.order);
    EXPECT_EQ(unit.limits.wall_seconds, 5);
    EXPECT_EQ(unit.limits.memory_mib, 512);
    EXPECT_EQ(unit.checks[1].full, 1);
    EXPECT_EQ(unit.checks[1].zero, 0);
}

TEST(Manifest, a_unit_of_shaders_is_not_cpp)
{
    json manifest = test::manifest();
    manifest["files"] = {"a.vert", "b.frag", "c.geom", "d.comp", "e.glsl"};
    manifest.erase("knob");  // units in C++ have some
    EXPECT_FALSE(parse(manifest).is_cpp());
}

TEST(Manifest, keeps_points_of_three_places_exact)
{
    for (int thousandths = 1; thousandths < 100000; thousandths += 7) {
        json manifest = test::manifest();
        manifest["checks"] = json::array({manifest["checks"][3]});
        manifest.erase("knob");
        const std::string digits = std::to_string(1000000 + thousandths);
        manifest["points"] = manifest["checks"][0]["points"] =
            json::parse(std::to_string(thousandths / 1000) + "." + digits.substr(4));
        ASSERT_EQ(parse(manifest).points, thousandths);
    }
}

TEST(Manifest, knows_families_of_forbidden_functions)
{
    json manifest = test::manifest();
    manifest["forbid"] = {"@transforms", "@vector-products", "glm::rotate*", "operator new"};
    EXPECT_EQ(parse(manifest).forbid.size(), 4U);
    for (const ForbiddenFamily& family : forbidden_families()) EXPECT_TRUE(is_forbid_entry(family.name));
    manifest["forbid"] = {"@transfroms"};
    const std::string message = test::message_of([&] { (void)parse(manifest); });
    EXPECT_NE(message.find("@transforms, @vector-products"), std::string::npos) << message;
}

TEST(Manifest, calls_opengl_only_where_there_is_opengl)
{
    json manifest = test::manifest();
    manifest["gl"] = false;
    manifest["gl_calls"] = true;
    EXPECT_NE(test::message_of([&] { (void)parse(manifest); }).find("gl_calls"), std::string::npos);
    manifest["gl"] = true;
    EXPECT_TRUE(parse(manifest).gl_calls);
}

/// One thing made wrong, and what the message must hold.
struct Wrong {
    const char* pointer;
    const char* value;  ///< JSON; null pointer: the field is taken away
    const char* message;
};

class WrongManifest : public testing::TestWithParam<Wrong> {};

TEST_P(WrongManifest, is_refused_by_name)
{
    json manifest = test::manifest();
    const json::json_pointer pointer(GetParam().pointer);
    if (GetParam().value != nullptr)
        manifest[pointer] = json::parse(GetParam().value);
    else
        manifest[pointer.parent_pointer()].erase(pointer.back());
    const std::string message = test::message_of([&] { (void)parse(manifest); });
    EXPECT_EQ(message.rfind("here.json: ", 0), 0U) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
    EXPECT_NE(message.find("expected "), std::string::npos) << message;
    EXPECT_NE(message.find(", got "), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Fields, WrongManifest,
    testing::Values(
        Wrong{"", "[]", "expected an object"}, Wrong{"", "null", "got null"},
        Wrong{"/format", "\"umbral-class\"", "format: expected \"umbral-exercise\""},
        Wrong{"/version", "2", "version: "}, Wrong{"/version", "1.0", "version: "},
        Wrong{"/version", nullptr, "got nothing"}, Wrong{"/id", "\"Lighting/phong\"", "id: "},
        Wrong{"/id", "\"lighting\"", "id: "}, Wrong{"/id", "\"a/b/c\"", "id: "}, Wrong{"/id", "\"/b\"", "id: "},
        Wrong{"/id", "\"../b\"", "id: "}, Wrong{"/id", "\"a/b_c\"", "id: "}, Wrong{"/id", "7", "id: "},
        Wrong{"/files", "[]", "files: "}, Wrong{"/files/0", "\"../x.cpp\"", "'../x.cpp'"},
        Wrong{"/files/0", "\".cpp\"", "files: "}, Wrong{"/files/0", "\"-o.cpp\"", "files: "},
        Wrong{"/files/0", "\"a.so\"", "'a.so'"}, Wrong{"/files/0", "\"driver.cpp\"", "'driver.cpp'"},
        Wrong{"/files/0", "\"phong_2.cpp\"", "files[1]: "}, Wrong{"/files/0", "\"a\\u0000.cpp\"", "files[0]: "},
        Wrong{"/points", "\"10\"", "points: "}, Wrong{"/points", "5", "sum of the checks' points, 4.875"},
        Wrong{"/points", "-4.125", "points: "}, Wrong{"/points", "1e300", "points: "},
        Wrong{"/uses/0", "\"lighting/phong-2\"", "uses[0]: "}, Wrong{"/uses/0", "\"lighting/lambert\"", "uses[1]: "},
        Wrong{"/uses", "\"lighting/lambert\"", "uses: "}, Wrong{"/forbid/1", "\"\"", "forbid[1]: "},
        Wrong{"/gl", "1", "gl: expected true or false, got 1"}, Wrong{"/title", "\"Phong\"", "title: "},
        Wrong{"/title/en", nullptr, "title.en: "}, Wrong{"/title/english", "\"Phong\"", "title.english: "},
        Wrong{"/title/en", "\"a\\nb\"", "title.en: "}, Wrong{"/course/0", "5.2", "course[0]: "},
        Wrong{"/order", "\"first\"", "order: "}, Wrong{"/limits/wall_seconds", "0", "limits.wall_seconds: "},
        Wrong{"/limits/wall_seconds", "1e9", "limits.wall_seconds: "},
        Wrong{"/limits/memory_mib", "256", "limits.memory_mib: expected a whole number from 512"},
        Wrong{"/limits/memory_mib", "512.5", "limits.memory_mib: "}, Wrong{"/limits/cpu", "1", "limits.cpu: "},
        Wrong{"/colour", "\"red\"", "colour: expected no field of this name"}, Wrong{"/checks", "[]", "checks: "}));

INSTANTIATE_TEST_SUITE_P(
    Checks, WrongManifest,
    testing::Values(
        Wrong{"/checks/0", "[]", "checks[0]: expected an object"},
        Wrong{"/checks/0/tolerence", "{}", "checks[0].tolerence: expected no field"},
        Wrong{"/checks/0/case", "\"a/b\"", "checks[0].case: "}, Wrong{"/checks/0/case", "\" a\"", "checks[0].case: "},
        Wrong{"/checks/0/case", nullptr, "got nothing"}, Wrong{"/checks/0/value", "\"t.margin\"", "checks[0].value: "},
        Wrong{"/checks/0/value", "\"a/b\"", "checks[0].value: "},
        Wrong{"/checks/0/judge", "\"ssim\"", "checks[0].judge: expected \"matrices\", \"numbers\""},
        Wrong{"/checks/0/points", "0", "checks[0].points: expected points above 0"},
        Wrong{"/checks/0/points", "2.0005", "checks[0].points: "},
        Wrong{"/checks/0/points", "null", "checks[0].points: "}, Wrong{"/checks/0/hard", "\"yes\"", "checks[0].hard: "},
        Wrong{"/checks/0/tolerance", nullptr, "checks[0].tolerance: expected a tolerance"},
        Wrong{"/checks/1/tolerance", nullptr, "checks[1].tolerance: "},
        Wrong{"/checks/0/tolerance", "{}", "checks[0].tolerance: expected at least one"},
        Wrong{"/checks/0/tolerance", "{\"band_ulps\": 1}", "checks[0].tolerance: "},
        Wrong{"/checks/0/tolerance/ulp", "4", "checks[0].tolerance.ulp: "},
        Wrong{"/checks/0/tolerance/ulps", "-1", "checks[0].tolerance.ulps: "},
        Wrong{"/checks/0/why", nullptr, "checks[0].why: expected where the tolerance comes from"},
        Wrong{"/checks/0/why", "\"\"", "checks[0].why: "}, Wrong{"/checks/0/full", "1.5", "checks[0].full: "},
        Wrong{"/checks/0/zero", "0.9", "checks[0].zero: expected less than"},
        Wrong{"/checks/0/zero", "-0.1", "checks[0].zero: "},
        Wrong{"/checks/0/range", "[0, 1]", "checks[0].range: expected no range"},
        Wrong{"/checks/3/range", "[1, 1]", "checks[3].range: "},
        Wrong{"/checks/3/range", "[0, 1, 2]", "checks[3].range: "},
        Wrong{"/checks/3/range", "[0, \"1\"]", "checks[3].range[1]: "},
        Wrong{"/checks/3/pairs", "true", "checks[3].pairs: "},
        Wrong{"/checks/4/rules", nullptr, "checks[4].rules: expected rules if"},
        Wrong{"/checks/4/rules", "[]", "checks[4].rules: "},
        Wrong{"/checks/4/rules/1", "\"draw calls\"", "checks[4].rules[1]: expected an item not in the list before"},
        Wrong{"/checks/4/rules/1", "\"colours\"", "not 'colours'"},
        Wrong{"/checks/0/rules", "[\"vertices\"]", "checks[0].rules: expected rules if"},
        Wrong{"/checks/4/pairs", "true", "checks[4].pairs: expected no pairs"},
        Wrong{"/checks/5/growth", nullptr, "checks[5].growth: "}, Wrong{"/checks/5/growth", "-1", "checks[5].growth: "},
        Wrong{"/checks/4/growth", "1", "checks[4].growth: expected growth if"},
        Wrong{"/checks/4/judge", "\"events\"", "checks[4].rules: "},
        Wrong{"/checks/3/judge", "\"fragments\"", "checks[3].range: "},
        Wrong{"/checks/2/value", "\"t\"", "'head-on/t' is"}));

TEST(Manifest, refuses_numbers_that_are_none)
{
    json manifest = test::manifest();
    manifest["checks"][0]["tolerance"]["ulps"] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(test::message_of([&] { (void)parse(manifest); }).find("checks[0].tolerance.ulps: "), std::string::npos);
    manifest["checks"][0]["tolerance"]["ulps"] = std::numeric_limits<double>::infinity();
    EXPECT_NE(test::message_of([&] { (void)parse(manifest); }).find("checks[0].tolerance.ulps: "), std::string::npos);
}

TEST(Manifest, text_must_be_json_with_each_key_once)
{
    const auto message = [](const char* text) {
        return test::message_of([&] { (void)parse_json(text, "here.json"); });
    };
    EXPECT_NE(message(R"({"a": 1, "b": {"a": 2}, "a": 3})")
                  .find("here.json: expected each key once in an object, got \"a\" twice"),
              std::string::npos);
    EXPECT_EQ(message(R"({"a": 1, "b": [{"a": 2}, {"a": 3}]})"), "nothing was thrown");
    EXPECT_NE(message("{\"a\": 1,\n \"b\": }").find("line 2"), std::string::npos);
    for (const char* text : {"", "{", "{} {}", "// no\n{}", "{\"a\": \"\xFF\"}", "{\"a\": NaN}"})
        EXPECT_EQ(message(text).rfind("here.json: expected JSON", 0), 0U) << text;
}

}
}
