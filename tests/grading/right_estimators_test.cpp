#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "support/all_tests.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "worker/known_solutions.hpp"

// The units whose pictures are Monte Carlo estimates blame no right work: other seeds, and all other ways to sample
// that they bring.
namespace umbral::grader::test {
namespace {

/// Right runs of each unit, over all its alternatives: together a thousand for `./umbral test --all`.
constexpr int right_runs = 500;

class RightEstimators : public testing::TestWithParam<const char*> {
protected:
    Workbench bench;
    Exercise exercise = bench.exercise(GetParam());
    Worker worker{bench.tools()};

    UnitResult grade(const Sources& sources, unsigned attempt)
    {
        GradeOptions options;
        options.seeds.attempt = attempt;
        options.explain = false;
        options.questions = false;
        return grade_unit(worker, exercise, {sources, {}, ""}, options);
    }
};
INSTANTIATE_TEST_SUITE_P(Units, RightEstimators, testing::Values("raytracing/path-tracing", "raytracing/distributed"),
                         [](const auto& unit) {
                             std::string name = unit.param;
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '/' || c == '-'; }, '_');
                             return name;
                         });

// A false alarm of one submission in ten thousand is allowed: a thousand right runs have none with a chance of 0.9.
TEST_P(RightEstimators, all_right_ways_to_sample_pass_with_many_seeds)
{
    const std::vector<KnownSolution> ways = alternatives_of(bench.tools().reference, exercise);
    const auto attempts = static_cast<unsigned>(tests_all() ? right_runs / static_cast<int>(ways.size()) + 1 : 2);
    int checks = 0;
    int again = 0;
    double smallest = 1;
    for (unsigned attempt = 0; attempt < attempts; ++attempt) {
        for (const KnownSolution& way : ways) {
            const UnitResult result = grade(way.sources, attempt);
            EXPECT_EQ(to_string(result.verdict), "ok") << way.name << ", attempt " << attempt << ": " << result.message;
            for (const CheckResult& check : result.checks) {
                EXPECT_EQ(check.score, check.max_score)
                    << way.name << ", attempt " << attempt << ", " << check.name << ": " << check.message;
                if (!check.metrics.contains("probability")) continue;
                ++checks;
                again += check.seeds.size() == 2 ? 1 : 0;
                smallest = std::min(smallest, check.metrics.at("probability"));
            }
        }
        worker.let_go();
    }
    std::printf("%s: %u attempts of %zu right solutions: %d noise checks, %d run again, smallest probability %.2g\n",
                GetParam(), attempts, ways.size(), checks, again, smallest);
}

}
}
