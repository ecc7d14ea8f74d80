#include "model/scorecard.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "results.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

TEST(AddUp, sums_all_units_but_those_that_are_our_fault)
{
    SubmissionResult result = test::submission();
    result.score = result.max_score = -1;
    add_up(result);
    EXPECT_EQ(result.score, 1250);
    EXPECT_EQ(result.max_score, 6000);
    result.units.clear();
    add_up(result);
    EXPECT_EQ(result.score, 0);
    EXPECT_EQ(result.max_score, 0);
}

TEST(ClassJson, is_this_text)
{
    SubmissionResult result = test::submission();
    add_up(result);
    result.units.resize(1);
    const json expected = json::parse(R"json({"format": "umbral-class", "version": 1, "score_unit": "millipoints",
        "tool": {"version": "0.1.0", "commit": "2a63927"},
        "machine": {"cpu": "Some CPU", "compiler": "g++ 12.2", "gl": "llvmpipe 22.3.6", "libm": "glibc 2.36",
        "protections": ["landlock 4", "seccomp"]},
        "course": "", "attempt": 0, "secret": "", "unfinished": [], "elsewhere": [], "left_out": [],
        "faults": [],
        "submissions": [{"id": "student-1", "score": 1250, "max_score": 6000, "units": [{
            "id": "raytracing/sphere", "digest": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
            "verdict": "partial",
            "score": 1250, "max_score": 4000, "seconds": 0.25, "reference_seconds": 0.125, "message": "",
            "stdout": "hello\n",
            "explanation": [{"name": "transposed", "sentence": "Your matrix is transposed.", "confidence": 0.75},
                            {"name": "mistake: far_root", "sentence": "You return the far root.", "confidence": 0.5}],
            "checks": [
                {"name": "head-on/t", "kind": "numbers", "hard": true, "hidden": false, "score": 1000,
                "max_score": 1000,
                 "error": 2.5, "reference_error": 0.5, "message": "",
                 "metrics": {"ulps": 2.5}, "first_difference": null},
                {"name": "picture/normals", "kind": "image", "hard": false, "hidden": true, "score": 250,
                "max_score": 3000,
                 "error": null, "reference_error": null, "message": "too dark",
                 "metrics": {"psnr": 31.5, "ssim": 0.5}, "first_difference": {"where": "pixel (120, 33)",
                 "yours": "0.1", "expected": "0.9"}}]}]}]})json");
    EXPECT_EQ(to_json(ClassResult{test::fingerprint(), {result}}), expected);
}

TEST(ScorecardJson, says_that_an_explanation_is_one_of_several)
{
    SubmissionResult result = test::submission();
    result.units[0].explanations[0].ambiguous = true;
    const json said = to_json(result, test::fingerprint()).at("submission").at("units").at(0).at("explanation");
    EXPECT_EQ(said.at(0).at("ambiguous"), true);
    EXPECT_FALSE(said.at(1).contains("ambiguous"));
}

TEST(ReportJson, adds_seeds_and_artefacts)
{
    const json root = to_json(test::submission(), test::fingerprint());
    EXPECT_EQ(root.at("format"), "umbral-report");
    const json& unit = root.at("submission").at("units").at(0);
    EXPECT_EQ(unit.at("seed"), "18446744073709551615");
    EXPECT_EQ(unit.at("checks").at(0).at("artefacts"), json::object());
    EXPECT_EQ(unit.at("checks").at(1).at("artefacts"), json::parse(R"({"triptych": "pictures/normals.png"})"));
    EXPECT_EQ(root.at("submission").at("units").at(1).at("verdict"), "missing");
}

TEST(ScorecardJson, numbers_that_are_not_finite_become_null)
{
    SubmissionResult result = test::submission();
    const double infinity = std::numeric_limits<double>::infinity();
    result.units[0].seconds = std::numeric_limits<double>::quiet_NaN();
    result.units[0].explanations[0].confidence = infinity;
    result.units[0].checks[0].error = -infinity;
    result.units[0].checks[0].metrics["ulps"] = infinity;
    const json unit = to_json(result, test::fingerprint()).at("submission").at("units").at(0);
    EXPECT_TRUE(unit.at("seconds").is_null());
    EXPECT_TRUE(unit.at("explanation").at(0).at("confidence").is_null());
    EXPECT_TRUE(unit.at("checks").at(0).at("error").is_null());
    EXPECT_TRUE(unit.at("checks").at(0).at("metrics").at("ulps").is_null());
}

TEST(ScorecardJson, any_text_leaves_as_utf8)
{
    const std::string bad = "\xFF\x1b[31m\xC3";
    SubmissionResult result{bad, 0, 0, {}};
    UnitResult unit;
    unit.id = unit.message = unit.output = bad;
    unit.explanations = {{bad, bad, 1}};
    CheckResult check;
    check.name = check.message = bad;
    check.metrics[bad] = 1;
    check.artefacts[bad] = bad;
    check.first_difference = Difference{bad, bad, bad};
    unit.checks = {check};
    result.units = {unit};
    Fingerprint machine{bad, bad, bad, bad, bad, bad, {bad}};
    // dump throws on invalid UTF-8 wherever it stands.
    const std::string text = to_json(result, machine).dump();
    EXPECT_EQ(text.find('\xFF'), std::string::npos);
    EXPECT_EQ(text.find("\\u001b"), std::string::npos);
    EXPECT_NE(text.find("\uFFFD[31m\uFFFD"), std::string::npos);
    EXPECT_EQ(to_json(ClassResult{machine, {result}}).dump(), to_json(ClassResult{machine, {result}}).dump());
}
}
}
