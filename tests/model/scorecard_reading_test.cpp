#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "judge/judges.hpp"
#include "message_of.hpp"
#include "model/scorecard.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

/// A unit with every field filled in.
UnitResult everything()
{
    UnitResult unit = test::submission().units[0];
    unit.message = "two\nlines\tand “more”\n";
    unit.output = std::string(1000, 'x') + "\n\n";
    unit.unscored = 4000;
    unit.rubric = {{"Texturas", 500, 1500}};
    unit.explanations[0].ambiguous = true;
    CheckResult& check = unit.checks[0];
    check.sketch = "#-\n-#\n";
    check.unjudged = Unjudged::not_run;
    check.seeds = {0, std::numeric_limits<std::uint64_t>::max()};
    check.message = " spaces at its ends ";
    check.error = 0.1 + 0.2;
    check.code_place = CodePlace{"sphere.cpp", 17, 5, "return t;", "all 4 calls with wrong answers come through here"};
    check.metrics["tiny"] = std::numeric_limits<double>::denorm_min();
    return unit;
}

TEST(UnitResultFromJson, gives_back_every_field)
{
    SubmissionResult all = test::submission();
    all.units.push_back(everything());
    for (const UnitResult& unit : all.units) {
        const json written = to_json(unit);
        const UnitResult read = unit_result_from_json(json::parse(written.dump()), "kept");
        EXPECT_EQ(to_json(read), written);
    }
    // to_json could leave a field out; so the fields themselves.
    const UnitResult read = unit_result_from_json(to_json(everything()), "kept");
    EXPECT_EQ(read.output, everything().output);
    EXPECT_EQ(read.message, everything().message);
    EXPECT_EQ(read.seed, everything().seed);
    EXPECT_EQ(read.unscored, 4000);
    ASSERT_TRUE(read.curve);
    EXPECT_EQ(read.curve->check, "head-on/t");
    EXPECT_EQ(read.curve->yours.error, 2.5);
    EXPECT_EQ(read.curve->others.at(0).name, "school formula");
    EXPECT_EQ(read.curve->others.at(1).seconds, 0.25);
    ASSERT_EQ(read.rubric.size(), 1U);
    EXPECT_EQ(read.rubric[0].words, "Texturas");
    EXPECT_EQ(read.rubric[0].score, 500);
    EXPECT_EQ(read.rubric[0].max_score, 1500);
    EXPECT_EQ(read.checks[0].seeds, everything().checks[0].seeds);
    ASSERT_TRUE(read.checks[0].code_place);
    EXPECT_EQ(read.checks[0].code_place->column, 5);
    EXPECT_EQ(read.checks[0].sketch, everything().checks[0].sketch);
    EXPECT_EQ(read.checks[0].unjudged, Unjudged::not_run);
    EXPECT_EQ(read.checks[0].error, everything().checks[0].error);
    EXPECT_EQ(read.checks[1].artefacts, everything().checks[1].artefacts);
    EXPECT_EQ(read.checks[1].kind, JudgeKind{"image"});
    EXPECT_TRUE(read.checks[1].hidden);
    EXPECT_TRUE(read.explanations[0].ambiguous);
    EXPECT_EQ(read.explanations[1].sentence, "You return the far root.");
}

TEST(UnitResultFromJson, numbers_that_are_not_finite_stay_so)
{
    UnitResult unit = everything();
    unit.seconds = unit.explanations[0].confidence = unit.checks[0].metrics["psnr"] =
        std::numeric_limits<double>::quiet_NaN();
    unit.checks[0].error = std::numeric_limits<double>::infinity();
    const UnitResult read = unit_result_from_json(to_json(unit), "kept");
    EXPECT_TRUE(std::isnan(read.seconds));
    EXPECT_TRUE(std::isnan(read.explanations[0].confidence));
    EXPECT_TRUE(std::isnan(read.checks[0].metrics.at("psnr")));
    EXPECT_FALSE(read.checks[0].error.has_value());
    EXPECT_EQ(to_json(read), to_json(unit));
}

TEST(UnitResultFromJson, every_verdict_and_kind)
{
    UnitResult unit = everything();
    for (int i = 0; i <= static_cast<int>(Verdict::grader_fault); ++i) {
        unit.verdict = static_cast<Verdict>(i);
        EXPECT_EQ(unit_result_from_json(to_json(unit), "kept").verdict, unit.verdict);
    }
    for (const JudgeRecord* judge : judges()) {
        const JudgeKind kind{std::string(judge->name)};
        unit.checks[0].kind = kind;
        EXPECT_EQ(unit_result_from_json(to_json(unit), "kept").checks[0].kind, kind);
    }
}

/// Pointers to every value in `value`.
void find_values(const json& value, const json::json_pointer& here, std::vector<json::json_pointer>& found)
{
    if (!here.empty()) found.push_back(here);
    if (value.is_structured())
        for (const auto& [key, item] : value.items())
            find_values(item, value.is_array() ? here / std::stoul(key) : here / key, found);
}

TEST(UnitResultFromJson, refuses_whatever_to_json_does_not_write)
{
    const json whole = to_json(everything());
    std::vector<json::json_pointer> values;
    find_values(whole, json::json_pointer(), values);
    const std::vector<std::string> optional{"sketch", "seeds", "ambiguous",  "unscored", "unjudged",
                                            "rubric", "curve", "code_place", "column"};
    int refused = 0;
    for (const json::json_pointer& place : values) {
        json other = whole;
        other[place] = whole[place].is_object() ? json::array() : json::object();
        EXPECT_NE(test::message_of([&] { (void)unit_result_from_json(other, "kept"); }), "nothing was thrown") << place;
        json more = whole;
        if (const std::string last = place.back();
            whole[place].is_object() && last != "metrics" && last != "artefacts") {
            more[place]["unknown"] = 1;
            EXPECT_NE(test::message_of([&] { (void)unit_result_from_json(more, "kept"); }), "nothing was thrown")
                << place;
        }
        const json::json_pointer parent = place.parent_pointer();
        const bool free = !parent.empty() && (parent.back() == "metrics" || parent.back() == "artefacts");
        if (!whole[parent].is_object() || free || std::ranges::count(optional, place.back()) > 0) continue;
        json less = whole;
        less[parent].erase(place.back());
        EXPECT_NE(test::message_of([&] { (void)unit_result_from_json(less, "kept"); }), "nothing was thrown")
            << "without " << place;
        ++refused;
    }
    EXPECT_GT(refused, 30);
    for (const auto& [place, value] : std::vector<std::pair<const char*, json>>{{"/seed", "-1"},
                                                                                {"/seed", "18446744073709551616"},
                                                                                {"/seed", "01"},
                                                                                {"/seed", "1x"},
                                                                                {"/verdict", "passed"},
                                                                                {"/checks/0/kind", "a guess"},
                                                                                {"/score", -1},
                                                                                {"/score", 0.5}}) {
        json wrong = whole;
        wrong[json::json_pointer(place)] = value;
        const std::string message = test::message_of([&] { (void)unit_result_from_json(wrong, "kept"); });
        EXPECT_TRUE(message.starts_with("kept: ")) << place << ": " << message;
    }
}

}
}
