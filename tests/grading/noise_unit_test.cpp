#include <gtest/gtest.h>

#include <cstdio>

#include "judge/statistics/error_budget.hpp"
#include "manifest/units.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "report/terminal.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "validate/validate.hpp"
#include "worker/known_solutions.hpp"

// From a student's file to the verdict of a unit judged by noise: tests/fixtures/exercises/noise/direct-light.
namespace umbral::grader::test {
namespace {

class NoiseUnit : public testing::Test {
protected:
    Workbench bench;
    Toolchain tools = bench.fixture_tools();
    Exercise exercise = load_exercise(tools.exercises / "noise/direct-light");
    Worker worker{tools};

    UnitResult grade(const Sources& sources, unsigned attempt)
    {
        GradeOptions options;
        options.seeds.attempt = attempt;
        options.explain = false;
        return grade_unit(worker, exercise, {sources, {}, ""}, options);
    }

    /// The reference, with all light times a factor, after a number that is drawn and thrown away: its noise is not the
    /// reference's.
    [[nodiscard]] Sources times(const std::string& factor) const
    {
        Sources sources = reference_sources(tools.reference, exercise);
        std::string& text = sources.begin()->second;
        const std::string end = "return sum / static_cast<float>(samples);";
        text.replace(text.find(end), end.size(), "return " + factor + "F * sum / static_cast<float>(samples);");
        const std::string begin = "float sum = 0;";
        text.replace(text.find(begin), begin.size(), begin + " (void)random.bits();");
        return sources;
    }
};

TEST_F(NoiseUnit, every_finding_of_validate_holds)
{
    int findings = 0;
    for (unsigned seed = 0; seed < 3; ++seed)
        validate_unit(worker, exercise, seed, [&](const Finding& finding) {
            ++findings;
            EXPECT_TRUE(finding.holds) << finding.subject << ", seed " << seed << ": " << finding.credit << " of "
                                       << finding.expected << ": " << finding.message;
        });
    EXPECT_GE(findings, 3 * 12);
}

TEST_F(NoiseUnit, the_references_own_numbers_are_right_without_chance)
{
    const UnitResult result = grade(reference_sources(tools.reference, exercise), 0);
    EXPECT_EQ(to_string(result.verdict), "ok");
    for (const CheckResult& check : result.checks) EXPECT_EQ(check.metrics.at("probability"), 1) << check.name;
}

TEST_F(NoiseUnit, other_right_ways_pass_with_two_hundred_seeds)
{
    for (const KnownSolution& other : alternatives_of(tools.reference, exercise)) {
        int again = 0;
        double smallest = 1;
        for (unsigned attempt = 0; attempt < 200; ++attempt) {
            const UnitResult result = grade(other.sources, attempt);
            ASSERT_EQ(to_string(result.verdict), "ok")
                << other.name << ", attempt " << attempt << ": " << result.message;
            for (const CheckResult& check : result.checks) {
                again += check.seeds.size() == 2 ? 1 : 0;
                smallest = std::min(smallest, check.metrics.at("probability"));
            }
        }
        std::printf("%s: 800 checks with attempts 0 to 199, %d run again, smallest probability %.2g\n",
                    other.name.c_str(), again, smallest);
        EXPECT_LE(again, 24) << "8 are expected at most";
    }
}

TEST_F(NoiseUnit, three_percent_fail_with_every_seed)
{
    for (unsigned attempt = 0; attempt < 20; ++attempt) {
        const UnitResult result = grade(times("1.03"), attempt);
        EXPECT_EQ(to_string(result.verdict), "partial") << attempt;
        EXPECT_LT(result.score, result.max_score * 85 / 100) << attempt;
        EXPECT_GT(result.score, result.max_score * 50 / 100) << attempt;
    }
}

/// The first borderline result of some attempts, and its check.
struct Borderline {
    UnitResult result;
    unsigned attempt = 0;
    std::size_t check = 0;
};

TEST_F(NoiseUnit, what_is_borderline_is_run_again_and_says_so)
{
    const Sources sources = times("1.006");
    std::optional<Borderline> found;
    for (unsigned attempt = 0; attempt < 200 && !found; ++attempt) {
        const UnitResult result = grade(sources, attempt);
        for (std::size_t i = 0; i < result.checks.size() && !found; ++i)
            if (result.checks[i].seeds.size() == 2 && !result.checks[i].hidden) found = Borderline{result, attempt, i};
    }
    ASSERT_TRUE(found) << "a bias of 0.6 % must be borderline with one of 200 seeds";
    const CheckResult& check = found->result.checks[found->check];
    std::printf("attempt %u, %s: probability %.2g, then %.2g, together %.2g; %s\n", found->attempt, check.name.c_str(),
                check.metrics.at("probability_first"), check.metrics.at("probability_fresh"),
                check.metrics.at("probability"), check.message.c_str());
    SeedPlan plan;
    plan.attempt = found->attempt;
    const std::string& case_name = exercise.checks[found->check].case_name;
    EXPECT_EQ(check.seeds,
              (std::vector<std::uint64_t>{plan.seed_of(exercise, case_name), plan.fresh_seed_of(exercise, case_name)}));
    EXPECT_EQ(after_first_run(check.metrics.at("probability_first")), FirstRun::borderline);
    EXPECT_EQ(check.metrics.at("probability") >= check_alpha(), check.score == check.max_score);

    const UnitResult once_more = grade(sources, found->attempt);
    EXPECT_EQ(once_more.score, found->result.score);
    EXPECT_EQ(once_more.checks[found->check].seeds, check.seeds);
    EXPECT_EQ(once_more.checks[found->check].message, check.message);
    EXPECT_EQ(once_more.checks[found->check].metrics, check.metrics);

    SubmissionResult submission{"ada", 0, 0, {found->result}};
    add_up(submission);
    const std::string fresh = std::to_string(check.seeds[1]);
    EXPECT_EQ(to_json(submission, {})["submission"]["units"][0]["checks"][found->check]["seeds"][1], fresh);
    EXPECT_NE(terminal_report(submission, {}).find(fresh), std::string::npos);
    EXPECT_NE(html::report_html(submission, {}, {}).find(fresh), std::string::npos);
}

TEST_F(NoiseUnit, fresh_seeds_of_hidden_cases_are_as_secret_as_the_first)
{
    const SeedPlan one{"secret", "course", "ada", 0};
    const SeedPlan other{"another", "course", "ada", 0};
    EXPECT_NE(one.fresh_seed_of(exercise, "secret"), one.seed_of(exercise, "secret"));
    EXPECT_NE(one.fresh_seed_of(exercise, "secret"), other.fresh_seed_of(exercise, "secret"));
    EXPECT_EQ(one.fresh_seed_of(exercise, "ball"), other.fresh_seed_of(exercise, "ball"))
        << "visible cases are the same for all";
    UnitResult unit = grade(times("1.03"), 0);
    ASSERT_FALSE(unit.checks[3].seeds.empty());
    const SubmissionResult shown = without_hidden_values({"ada", 0, 0, {unit}});
    EXPECT_TRUE(shown.units[0].checks[3].seeds.empty());
    EXPECT_FALSE(shown.units[0].checks[0].seeds.empty());
}

}
}
