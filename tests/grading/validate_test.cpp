#include <gtest/gtest.h>

#include <algorithm>

#include "support/workbench.hpp"
#include "validate/rubric_findings.hpp"
#include "worker/worker.hpp"

// What validation says of a unit whose files do not fit together.
namespace umbral::grader {
namespace {

std::vector<Finding> findings_on(Worker& worker, const Exercise& exercise)
{
    std::vector<Finding> findings;
    validate_unit(worker, exercise, 0, [&](const Finding& finding) { findings.push_back(finding); });
    return findings;
}

TEST(Validation, names_a_mistyped_case_first)
{
    const test::Workbench bench;
    Worker worker(bench.tools());
    Exercise sphere = bench.exercise("raytracing/sphere");
    const std::string real = sphere.checks.front().case_name;
    for (Check& check : sphere.checks)
        if (check.case_name == real) check.case_name = "haed-on";
    const std::vector<Finding> findings = findings_on(worker, sphere);
    ASSERT_EQ(findings.size(), 1U) << "what else goes wrong follows from it";
    EXPECT_EQ(findings.front().subject, "case: haed-on");
    EXPECT_FALSE(findings.front().holds);
    EXPECT_TRUE(findings.front().message.starts_with(
        "in exercise.json: the driver has no case 'haed-on'; did you mean `head-on`? its cases: head-on, "))
        << findings.front().message;
}

TEST(Validation, passes_over_mistakes_and_nothing_else)
{
    const test::Workbench bench;
    Worker worker(bench.tools());
    std::map<KnownMistakes, std::set<std::string>> subjects;
    for (const KnownMistakes mistakes : {KnownMistakes::graded, KnownMistakes::passed_over})
        validate_unit(
            worker, bench.exercise("raytracing/sphere"), 0,
            [&](const Finding& finding) {
                EXPECT_TRUE(finding.holds) << finding.subject << ": " << finding.message;
                subjects[mistakes].insert(finding.subject);
            },
            mistakes);
    EXPECT_GT(std::erase_if(subjects[KnownMistakes::graded],
                            [](const std::string& subject) { return subject.starts_with("mistake: "); }),
              5U);
    EXPECT_EQ(subjects[KnownMistakes::passed_over], subjects[KnownMistakes::graded]);
    EXPECT_TRUE(subjects[KnownMistakes::passed_over].contains("stub"));
}

TEST(Validation, names_the_path_of_a_missing_reference)
{
    const test::Workbench bench;
    Toolchain tools = bench.tools();
    tools.reference = bench.folder() / "empty";
    Worker worker(tools);
    for (const auto& [unit, file] : {std::pair("raytracing/sphere", "empty/raytracing/sphere.cpp"),
                                     std::pair("lighting/shaders", "empty/lighting/shaders/phong.frag")}) {
        const std::vector<Finding> findings = findings_on(worker, bench.exercise(unit));
        ASSERT_EQ(findings.size(), 1U);
        EXPECT_EQ(findings.front().subject, "reference");
        EXPECT_FALSE(findings.front().holds);
        EXPECT_NE(findings.front().message.find("expected " + (bench.folder() / file).string()), std::string::npos)
            << findings.front().message;
    }
    EXPECT_TRUE(expect_reference(bench.tools().reference, bench.exercise("lighting/shaders"), 0).holds);
}

/// A unit of three lines, of which the last two lost points by one check each.
UnitResult two_lines_lost()
{
    UnitResult result;
    for (const Millipoints score : {1000, 400, 0}) {
        CheckResult& check = result.checks.emplace_back();
        check.name = "check " + std::to_string(result.checks.size());
        check.score = score;
        check.max_score = 1000;
        result.rubric.push_back({"words", score, 1000});
    }
    return result;
}

TEST(Validation, names_other_lines_of_a_rubric_that_a_mistake_costs)
{
    UnitResult result = two_lines_lost();
    EXPECT_EQ(rubric_complaint(0, result), "line 1 of the rubric loses nothing");
    EXPECT_EQ(rubric_complaint(1, result),
              "is to cost points in line 2 of the rubric only, but line 3 loses some too; checks that take points: "
              "check 2, check 3");
    result.rubric[1].score = 1000;
    EXPECT_EQ(rubric_complaint(2, result), "");
    EXPECT_EQ(rubric_complaint(1, result), "line 2 of the rubric loses nothing");
}

TEST(Validation, wants_a_mistake_for_each_line_of_a_rubric)
{
    Exercise unit;
    EXPECT_TRUE(expect_rubric(unit, {}, 0).empty()) << "no rubric";
    unit.rubric = {{"Modelo", 1000}, {"Imagen", 1000}};
    KnownSolution mistake;
    EXPECT_EQ(expect_rubric(unit, {mistake}, 0).size(), 2U);
    mistake.rubric_line = 1;
    const std::vector<Finding> findings = expect_rubric(unit, {mistake}, 0);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings.front().subject, "rubric: line 1");
    EXPECT_FALSE(findings.front().holds);
}

TEST(Validation, refuses_a_line_that_a_rubric_does_not_have)
{
    const test::Workbench bench;
    Exercise sphere = bench.exercise("raytracing/sphere");
    sphere.rubric = {{"Modelo", 1000}};
    sphere.folder = bench.folder() / "unit";
    const auto lines_of = [&](const std::string& rubric) {
        bench.write("unit/mistakes/one.cpp", "// mistake: a\n// hint: b\n// credit: 1..2\n" + rubric);
        return mistakes_of(bench.tools().reference, sphere).front().rubric_line;
    };
    EXPECT_EQ(lines_of(""), std::nullopt);
    EXPECT_EQ(lines_of("// rubric: 1\n"), std::optional<std::size_t>(0));
    for (const char* wrong : {"2", "0", "-1", "one"}) {
        try {
            (void)lines_of(std::string("// rubric: ") + wrong + "\n");
            ADD_FAILURE() << wrong;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find("which has 1 of them, got '" + std::string(wrong) + "'"),
                      std::string::npos)
                << error.what();
        }
    }
}

}
}
