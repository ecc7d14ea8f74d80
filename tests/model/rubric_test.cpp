#include "model/rubric.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/schema.hpp>

#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"

namespace umbral::grader {
namespace {

using nlohmann::json;

/// The manifest of all tests with a rubric of two lines: of the first are the checks 0, 2 and 4.
json manifest_with_rubric()
{
    json all = test::manifest();
    all["rubric"] = json::parse(R"([{"words": "Modelo", "points": 2.625}, {"words": "Imagen", "points": 2.25}])");
    for (std::size_t i = 0; i < all["checks"].size(); ++i) all["checks"][i]["rubric"] = i % 2 + 1;
    return all;
}

TEST(Rubric, gives_each_line_what_its_checks_earned)
{
    const Exercise unit = parse_exercise(manifest_with_rubric(), "here.json");
    ASSERT_EQ(unit.rubric.size(), 2U);
    EXPECT_EQ(unit.rubric[1].words, "Imagen");
    EXPECT_EQ(unit.rubric[1].points, 2250);

    std::vector<CheckResult> checks(unit.checks.size());
    for (std::size_t i = 0; i < checks.size(); ++i) checks[i].score = 1 << i;
    const std::vector<RubricScore> lines = by_rubric(unit, checks);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].words, "Modelo");
    EXPECT_EQ(lines[0].score, 1 + 4 + 16);
    EXPECT_EQ(lines[0].max_score, 2625);
    EXPECT_EQ(lines[1].score, 2 + 8 + 32);
}

TEST(Rubric, is_empty_where_a_unit_has_none)
{
    const Exercise unit = parse_exercise(test::manifest(), "here.json");
    EXPECT_TRUE(by_rubric(unit, std::vector<CheckResult>(unit.checks.size())).empty());
}

TEST(Rubric, that_does_not_hold_together_is_refused)
{
    const umbral::test::Schema schema("exercise");
    ASSERT_EQ(schema.complaints(manifest_with_rubric()), "");
    const auto message = [](const json& all) {
        return test::message_of([&] { (void)parse_exercise(all, "here.json"); });
    };
    json no_line = manifest_with_rubric();
    no_line["checks"][2].erase("rubric");
    EXPECT_NE(message(no_line).find("checks[2].rubric: "), std::string::npos) << message(no_line);
    EXPECT_NE(schema.complaints(no_line), "");

    json no_rubric = manifest_with_rubric();
    no_rubric.erase("rubric");
    EXPECT_NE(message(no_rubric).find("checks[0].rubric: expected no line"), std::string::npos) << message(no_rubric);
    EXPECT_NE(schema.complaints(no_rubric), "");

    json other_line = manifest_with_rubric();
    other_line["checks"][0]["rubric"] = 2;
    EXPECT_NE(message(other_line).find("line 1 that are the sum of its checks' points, 0.62"), std::string::npos)
        << message(other_line);

    json beyond = manifest_with_rubric();
    beyond["checks"][0]["rubric"] = 3;
    EXPECT_NE(message(beyond).find("checks[0].rubric: "), std::string::npos) << message(beyond);
}

}
}
