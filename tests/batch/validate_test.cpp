#include <gtest/gtest.h>

#include <algorithm>

#include "batch/validate.hpp"
#include "batch/worker.hpp"
#include "support/workbench.hpp"

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

}
}
