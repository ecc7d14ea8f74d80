#include <gtest/gtest.h>

#include "judge/statistics/error_budget.hpp"
#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

/// A manifest whose only checks are these.
json with_checks(const json& checks)
{
    json manifest = test::manifest();
    double points = 0;
    for (const json& check : checks) points += check["points"].get<double>();
    manifest["checks"] = checks;
    manifest.erase("knob");  // it names one of the others
    manifest["points"] = points;
    return manifest;
}

json noise() { return {{"case", "sky"}, {"value", "light"}, {"judge", "noise"}, {"scatter", 3}, {"points", 2}}; }

std::string complaint_about(const json& check)
{
    return test::message_of([&] { (void)parse_exercise(with_checks(json::array({check})), "here.json"); });
}

TEST(NoiseManifest, reads_a_checks_bias_and_range)
{
    json check = noise();
    check["tolerance"] = {{"relative", 0.01}};
    check["why"] = "the oracle leaves out the third bounce";
    check["range"] = {0, 4};
    const Exercise unit = parse_exercise(
        with_checks(json::array({check, {{"case", "a"}, {"value", "b"}, {"judge", "image"}, {"points", 1}}})),
        "here.json");
    EXPECT_EQ(unit.checks[0].judge, JudgeKind{"noise"});
    EXPECT_EQ(unit.checks[0].tolerance.relative, 0.01);
    EXPECT_EQ(unit.checks[0].range_high, 4);
    EXPECT_NO_THROW((void)parse_exercise(with_checks(json::array({noise()})), "here.json")) << "nothing more is needed";
}

TEST(NoiseManifest, refuses_what_noise_does_not_have)
{
    json ulps = noise();
    ulps["tolerance"] = {{"ulps", 4}};
    ulps["why"] = "four roundings";
    EXPECT_NE(complaint_about(ulps).find("checks[0].tolerance: expected absolute or relative only"), std::string::npos)
        << complaint_about(ulps);
    json pairs = noise();
    pairs["pairs"] = true;
    EXPECT_NE(complaint_about(pairs).find("checks[0].pairs: expected no pairs"), std::string::npos)
        << complaint_about(pairs);
    json no_reason = noise();
    no_reason["tolerance"] = {{"relative", 0.01}};
    EXPECT_NE(complaint_about(no_reason).find("checks[0].why: expected where the tolerance comes from"),
              std::string::npos);
}

TEST(NoiseManifest, all_units_together_have_at_most_a_hundred)
{
    const umbral::test::TemporaryFolder folder;
    const auto write_unit = [&](const std::string& name, int checks) {
        json list = json::array();
        for (int i = 0; i < checks; ++i) {
            list.push_back(noise());
            list.back()["value"] = "light " + std::to_string(i);
        }
        json manifest = with_checks(list);
        manifest["id"] = "lighting/" + name;
        manifest["files"] = {"sky.cpp"};
        manifest.erase("uses");
        folder.write("lighting/" + name + "/exercise.json", manifest.dump());
        for (const char* file : {"sky.cpp", "driver.cpp"}) folder.write("lighting/" + name + "/" + file, "");
    };
    write_unit("one", 60);
    write_unit("two", most_noise_checks - 60);
    EXPECT_EQ(load_units(folder.path()).exercises.size(), 2U);
    write_unit("two", most_noise_checks - 59);
    const std::string message = test::message_of([&] { (void)load_units(folder.path()); });
    EXPECT_NE(message.find("expected at most 100 checks of the judge \"noise\""), std::string::npos) << message;
    EXPECT_NE(message.find("got 101"), std::string::npos) << message;
}

}
}
