#include <gtest/gtest.h>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader::test {
namespace {

class GradeUnit : public testing::TestWithParam<const char*> {
protected:
    Workbench bench;
    Exercise exercise = bench.exercise(GetParam());
    Worker worker{bench.tools()};

    UnitResult grade(const Sources& sources, const GradeOptions& options = {})
    {
        return grade_unit(worker, exercise, {sources, {}, ""}, options);
    }
};

TEST_P(GradeUnit, the_reference_gets_all_points)
{
    const UnitResult result = grade(reference_sources(bench.tools().reference, exercise));
    EXPECT_EQ(to_string(result.verdict), "ok") << result.message;
    EXPECT_EQ(result.score, exercise.points);
    EXPECT_EQ(result.checks.size(), exercise.checks.size());
    EXPECT_TRUE(result.explanations.empty());
    EXPECT_TRUE(result.message.empty()) << result.message;
    EXPECT_FALSE(result.digest.empty());
}

TEST_P(GradeUnit, a_mistake_loses_points_and_is_explained)
{
    const std::vector<KnownSolution> mistakes = mistakes_of(bench.tools().reference, exercise);
    ASSERT_FALSE(mistakes.empty());
    int tried = 0;
    for (const KnownSolution& mistake : mistakes) {
        if (mistake.verdict || tried == 2) continue;
        ++tried;
        const UnitResult result = grade(mistake.sources);
        const double percent = 100.0 * static_cast<double>(result.score) / static_cast<double>(result.max_score);
        EXPECT_GE(percent, mistake.least_credit) << mistake.name;
        EXPECT_LE(percent, mistake.most_credit) << mistake.name;
        ASSERT_FALSE(result.explanations.empty()) << mistake.name;
        EXPECT_EQ(result.explanations.front().name, "mistake: " + mistake.name);
        EXPECT_EQ(result.explanations.front().sentence, mistake.hint);
    }
    EXPECT_GT(tried, 0);
}

TEST_P(GradeUnit, the_stub_is_not_implemented)
{
    const UnitResult result = grade(stub_sources(exercise));
    EXPECT_EQ(to_string(result.verdict), "not_implemented");
    EXPECT_EQ(result.score, 0);
    EXPECT_EQ(result.max_score, exercise.points);
    // With a statement more it is no longer equal to the stub, but reaches it in every case.
    Sources sources = stub_sources(exercise);
    sources.begin()->second += "namespace { [[maybe_unused]] int my_own = 1; }\n";
    EXPECT_EQ(to_string(grade(sources).verdict), "not_implemented");
}

TEST_P(GradeUnit, pictures_are_kept_and_named_relative_to_the_report)
{
    GradeOptions options;
    options.relative_to = bench.folder();
    options.artefacts = bench.folder() / "pictures";
    const UnitResult result = grade(reference_sources(bench.tools().reference, exercise), options);
    std::size_t pictures = 0;
    for (const CheckResult& check : result.checks) {
        for (const auto& [kind, path] : check.artefacts) {
            EXPECT_TRUE(std::filesystem::path(path).is_relative()) << path;
            EXPECT_GT(std::filesystem::file_size(bench.folder() / path), 100U) << path;
            ++pictures;
        }
    }
    EXPECT_GT(pictures, 0U);
}

TEST_P(GradeUnit, hidden_seeds_follow_from_secret_and_student)
{
    SeedPlan one{"secret", "course", "ada", 0};
    SeedPlan other_student{"secret", "course", "grace", 0};
    SeedPlan other_secret{"another", "course", "ada", 0};
    SeedPlan other_attempt{"secret", "course", "ada", 1};
    int hidden = 0;
    for (const std::string& name : exercise.cases()) {
        const std::uint64_t seed = one.seed_of(exercise, name);
        EXPECT_EQ(seed, SeedPlan(one).seed_of(exercise, name));
        EXPECT_NE(seed, other_attempt.seed_of(exercise, name));
        const bool is_hidden = is_hidden_case(exercise, name);
        hidden += is_hidden ? 1 : 0;
        EXPECT_EQ(seed != other_student.seed_of(exercise, name), is_hidden) << name;
        EXPECT_EQ(seed != other_secret.seed_of(exercise, name), is_hidden) << name;
    }
    EXPECT_GT(hidden, 0);
}

INSTANTIATE_TEST_SUITE_P(Units, GradeUnit, testing::Values("raytracing/sphere", "projections/view-matrix"),
                         [](const auto& one) {
                             std::string name = one.param;
                             for (char& c : name)
                                 if (c == '/' || c == '-') c = '_';
                             return name;
                         });

}
}
