#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/schema.hpp>

#include "judge/judges.hpp"
#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"
#include "results.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;
using umbral::test::read_schema;
using umbral::test::Schema;
const std::filesystem::path source = UMBRAL_SOURCE_DIR;

json class_json()
{
    SubmissionResult result = test::submission();
    add_up(result);
    return to_json(ClassResult{test::fingerprint(), {result, SubmissionResult{"nobody", 0, 0, {}}}});
}

json report_json()
{
    SubmissionResult result = test::submission();
    add_up(result);
    return to_json(result, test::fingerprint());
}

/// Pointers to every object in `value`, `value` itself first.
void find_objects(const json& value, const json::json_pointer& here, std::vector<json::json_pointer>& found)
{
    if (value.is_object()) found.push_back(here);
    if (value.is_structured())
        for (const auto& [key, item] : value.items())
            find_objects(item, value.is_array() ? here / std::stoul(key) : here / key, found);
}

/// Every object must refuse each of its fields missing, but for a curve, or of another type, and an unknown field.
/// `free` are maps with keys of any name.
void expect_strict(const Schema& schema, const json& document, const std::vector<std::string>& free)
{
    std::vector<json::json_pointer> objects;
    find_objects(document, json::json_pointer(), objects);
    int variants = 0;
    for (const json::json_pointer& object : objects) {
        if (!object.empty() && std::find(free.begin(), free.end(), object.back()) != free.end()) continue;
        json more = document;
        more[object]["unknown"] = 1;
        EXPECT_NE(schema.complaints(more), "") << object << " with an unknown field";
        for (const auto& [key, value] : document[object].items()) {
            json less = document;
            less[object].erase(key);
            EXPECT_EQ(schema.complaints(less) == "", key == "curve") << object << " without " << key;
            json other = document;
            other[object][key] = value.is_boolean() ? json("true") : json(true);
            EXPECT_NE(schema.complaints(other), "") << object / key << " of another type";
            variants += 2;
        }
    }
    EXPECT_GT(variants, 50);
}

TEST(ResultSchemas, accept_what_the_grader_writes)
{
    EXPECT_EQ(Schema("class").complaints(class_json()), "");
    EXPECT_EQ(Schema("report").complaints(report_json()), "");
    EXPECT_EQ(Schema("class").complaints(to_json(ClassResult{})), "");
    EXPECT_NE(Schema("class").complaints(report_json()), "");
    EXPECT_NE(Schema("report").complaints(class_json()), "");
}

TEST(ResultSchemas, accept_every_verdict_and_kind)
{
    const Schema schema("report");
    SubmissionResult result = test::submission();
    for (int i = 0; i <= static_cast<int>(Verdict::grader_fault); ++i) {
        result.units[0].verdict = static_cast<Verdict>(i);
        EXPECT_EQ(schema.complaints(to_json(result, test::fingerprint())), "");
    }
    for (const JudgeRecord* judge : judges()) {
        const JudgeKind kind{std::string(judge->name)};
        result.units[0].checks[0].kind = kind;
        EXPECT_EQ(schema.complaints(to_json(result, test::fingerprint())), "");
    }
    json root = report_json();
    root["submission"]["units"][0]["verdict"] = "passed";
    EXPECT_NE(schema.complaints(root), "");
}

TEST(ResultSchemas, hold_a_sketch_where_there_is_one)
{
    SubmissionResult result = test::submission();
    EXPECT_FALSE(to_json(result, test::fingerprint())["submission"]["units"][0]["checks"][0].contains("sketch"));
    result.units[0].checks[0].sketch = "#-\n\x1b#\xFF";
    const json report = to_json(result, test::fingerprint());
    EXPECT_EQ(Schema("report").complaints(report), "");
    EXPECT_EQ(Schema("class").complaints(to_json(ClassResult{test::fingerprint(), {result}})), "");
    EXPECT_EQ(report["submission"]["units"][0]["checks"][0]["sketch"].get<std::string>().substr(0, 3), "#-\n");
    EXPECT_NO_THROW((void)report.dump()) << "valid UTF-8";
    json wrong = report;
    wrong["submission"]["units"][0]["checks"][0]["sketch"] = nullptr;
    EXPECT_NE(Schema("report").complaints(wrong), "");
}

TEST(ResultSchemas, hold_what_kept_a_check_from_being_judged)
{
    SubmissionResult result = test::submission();
    EXPECT_FALSE(to_json(result, test::fingerprint())["submission"]["units"][0]["checks"][0].contains("unjudged"));
    for (const Unjudged unjudged : {Unjudged::unwritten, Unjudged::stopped, Unjudged::not_run}) {
        result.units[0].checks[0].unjudged = unjudged;
        EXPECT_EQ(Schema("report").complaints(to_json(result, test::fingerprint())), "");
        EXPECT_EQ(Schema("class").complaints(to_json(ClassResult{test::fingerprint(), {result}})), "");
        EXPECT_EQ(unjudged_from(to_string(unjudged)), unjudged);
    }
    EXPECT_THROW((void)unjudged_from(""), std::invalid_argument);
    json wrong = to_json(result, test::fingerprint());
    wrong["submission"]["units"][0]["checks"][0]["unjudged"] = "";
    EXPECT_NE(Schema("report").complaints(wrong), "");
}

TEST(ResultSchemas, hold_seeds_where_noise_was_judged)
{
    SubmissionResult result = test::submission();
    const auto check_of = [](const json& report) { return report["submission"]["units"][0]["checks"][0]; };
    EXPECT_FALSE(check_of(to_json(result, test::fingerprint())).contains("seeds"));
    result.units[0].checks[0].kind = JudgeKind{"noise"};
    result.units[0].checks[0].seeds = {18446744073709551615U, 7};
    json report = to_json(result, test::fingerprint());
    EXPECT_EQ(Schema("report").complaints(report), "");
    EXPECT_EQ(check_of(report)["seeds"], (json{"18446744073709551615", "7"}));
    EXPECT_EQ(Schema("class").complaints(to_json(ClassResult{test::fingerprint(), {result}})), "")
        << "not in class.json";
    for (const json& wrong : {json::array(), json(7), json{7, 8}, json{"1", "2", "3"}, json{"-1"}}) {
        report["submission"]["units"][0]["checks"][0]["seeds"] = wrong;
        EXPECT_NE(Schema("report").complaints(report), "") << wrong;
    }
}

TEST(ResultSchemas, are_strict_in_every_field)
{
    expect_strict(Schema("class"), class_json(), {"metrics", "artefacts"});
    expect_strict(Schema("report"), report_json(), {"metrics", "artefacts"});
}

TEST(ResultSchemas, refuse_values_out_of_range)
{
    const Schema schema("report");
    for (const auto& [pointer, value] :
         std::vector<std::pair<const char*, json>>{{"/version", 2},
                                                   {"/score_unit", "points"},
                                                   {"/submission/score", -1},
                                                   {"/submission/score", 0.5},
                                                   {"/submission/units/0/id", "sphere"},
                                                   {"/submission/units/0/digest", "abc"},
                                                   {"/submission/units/0/seed", 5},
                                                   {"/submission/units/0/seed", "-5"},
                                                   {"/submission/units/0/explanation/0/confidence", 1.5},
                                                   {"/submission/units/0/checks/1/metrics/psnr", "31"},
                                                   {"/submission/units/0/checks/1/artefacts/triptych", nullptr}}) {
        json root = report_json();
        root[json::json_pointer(pointer)] = value;
        EXPECT_NE(schema.complaints(root), "") << pointer << " = " << value;
    }
}

TEST(ResultSchemas, say_the_same_of_what_they_share)
{
    const json a = read_schema("class")["definitions"];
    const json b = read_schema("report")["definitions"];
    for (const char* name : {"tool", "machine", "submission", "difference", "explanation"})
        EXPECT_EQ(a.at(name), b.at(name)) << name;
    for (const char* name : {"unit", "check"})
        for (const auto& [key, value] : a.at(name).at("properties").items())
            EXPECT_EQ(value, b.at(name).at("properties").at(key)) << name << "." << key;
}

/// Every named field of a schema has a description.
void expect_described(const json& schema, const json::json_pointer& here)
{
    for (const char* group : {"properties", "definitions"}) {
        if (!schema.contains(group)) continue;
        for (const auto& [key, value] : schema[group].items()) {
            EXPECT_TRUE(value.contains("description") || value.contains("$ref")) << here / group / key;
            expect_described(value, here / group / key);
        }
    }
}

TEST(Schemas, describe_every_field)
{
    for (const char* name : {"class", "report", "exercise", "accuracy"})
        expect_described(read_schema(name), json::json_pointer("/" + std::string(name)));
}

TEST(ExerciseSchema, agrees_with_the_program_on_variants_of_a_manifest)
{
    const Schema schema("exercise");
    const json manifest = test::manifest();
    ASSERT_EQ(schema.complaints(manifest), "");
    std::vector<json::json_pointer> objects;
    find_objects(manifest, json::json_pointer(), objects);
    const std::vector<json> values{nullptr,
                                   true,
                                   0,
                                   -1,
                                   0.25,
                                   1,
                                   2,
                                   600.5,
                                   1e10,
                                   "",
                                   " a",
                                   "a\nb",
                                   "a/b",
                                   "../a.cpp",
                                   "a.cpp",
                                   "t.margin",
                                   "image",
                                   json::array(),
                                   json::array({1, 0}),
                                   json::object()};
    int refused = 0;
    const auto compare = [&](const json& variant, const std::string& what) {
        const std::string message = test::message_of([&] { (void)parse_exercise(variant, "variant"); });
        // What a schema cannot say: sums, decimals, order of two numbers, comparison with other fields.
        for (const char* beyond :
             {"the sum of the checks' points", "the sum of its checks' points", "decimal places", "less than \"full\"",
              "low < high", "not checked before", "of a visible check", "a case of the unit's checks"})
            if (message.find(beyond) != std::string::npos) return;
        EXPECT_EQ(message == "nothing was thrown", schema.complaints(variant).empty())
            << what << "\nprogram: " << message << "\nschema: " << schema.complaints(variant);
        refused += message == "nothing was thrown" ? 0 : 1;
    };
    for (const json::json_pointer& object : objects) {
        json variant = manifest;
        variant[object]["unknown"] = 1;
        compare(variant, object.to_string() + "/unknown");
        for (const auto& [key, old] : manifest[object].items()) {
            variant = manifest;
            variant[object].erase(key);
            compare(variant, "without " + (object / key).to_string());
            for (const json& value : values) {
                variant = manifest;
                variant[object][key] = value;
                compare(variant, (object / key).to_string() + " = " + value.dump());
            }
        }
    }
    EXPECT_GT(refused, 200);
}

TEST(ExerciseSchema, agrees_with_the_program_on_every_unit)
{
    const Schema schema("exercise");
    int units = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "exercises")) {
        if (entry.path().filename() != "exercise.json") continue;
        SCOPED_TRACE(entry.path().string());
        ++units;
        json manifest;
        ASSERT_NO_THROW(manifest = read_json(entry.path()));
        EXPECT_EQ(schema.complaints(manifest), "");
        EXPECT_EQ(test::message_of([&] { (void)parse_exercise(manifest, "exercise.json"); }), "nothing was thrown");
    }
    if (units == 0) GTEST_SKIP() << "there is no unit yet";
}

}
}
