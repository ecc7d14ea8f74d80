#include "explain/explain_unit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "handed_in.hpp"
#include "judge/explain/thresholds.hpp"

namespace umbral::grader::test {
namespace {

/// Nothing that could compile: whatever compiled here would throw or find nothing.
Toolchain without_compiler(Toolchain tools)
{
    tools.compiler = "/nonexistent/compiler";
    tools.student_header = "/nonexistent/header.hpp";
    tools.cache = "/nonexistent/cache";
    return tools;
}

class ExplainUnit : public testing::TestWithParam<const char*> {
protected:
    Workbench bench;
    Exercise exercise = bench.exercise(GetParam());
    Worker worker{without_compiler(bench.tools())};
    std::vector<KnownSolution> mistakes = explaining_mistakes(worker, exercise);

    RunOutcome run(const KnownSolution& mistake, const std::string& name, std::uint64_t seed)
    {
        return worker.run_known(exercise, "mistakes/" + mistake.name, mistake.sources, name, seed);
    }

    std::vector<Explanation> explain(const Answer& answer)
    {
        const auto [result, cases] = hand_in(worker, exercise, answer);
        return explain_unit(worker, exercise, result, cases);
    }
};

TEST_P(ExplainUnit, takes_mistakes_that_were_compiled_with_the_project)
{
    ASSERT_FALSE(mistakes.empty());
    for (const KnownSolution& mistake : mistakes) {
        const auto found =
            explain([&](const std::string& name, std::uint64_t seed) { return run(mistake, name, seed); });
        ASSERT_FALSE(found.empty()) << mistake.name;
        EXPECT_EQ(found.front().name, "mistake: " + mistake.name);
        // A subtle one breaks a few rows only: then it is "probably", not "very likely".
        EXPECT_GT(found.front().confidence, thresholds::least_sure) << mistake.name;
        EXPECT_EQ(found.front().fit, 1) << mistake.name;
        EXPECT_FALSE(found.front().ambiguous) << mistake.name;
    }
}

TEST_P(ExplainUnit, says_nothing_of_right_work)
{
    const auto found = explain([&](const std::string& name, std::uint64_t seed) {
        return worker.trusted(exercise, Answers::reference, name, seed);
    });
    EXPECT_TRUE(found.empty());
}

TEST_P(ExplainUnit, a_mistake_that_breaks_more_than_the_students_work_is_not_its_reason)
{
    int tried = 0;
    for (const KnownSolution& mistake : mistakes) {
        const auto [result, cases] = hand_in(
            worker, exercise, [&](const std::string& name, std::uint64_t seed) { return run(mistake, name, seed); });
        std::set<std::string> broken;
        for (std::size_t i = 0; i < exercise.checks.size(); ++i)
            if (result.checks[i].score < exercise.checks[i].points) broken.insert(exercise.checks[i].case_name);
        if (broken.size() < 3) continue;
        ++tried;
        // The student fails the first of these cases exactly as the mistake does, and is right in all others.
        const auto found = explain([&](const std::string& name, std::uint64_t seed) {
            return name == *broken.begin() ? run(mistake, name, seed)
                                           : worker.trusted(exercise, Answers::reference, name, seed);
        });
        for (const Explanation& one : found) EXPECT_NE(one.name, "mistake: " + mistake.name) << one.confidence;
    }
    EXPECT_GT(tried, 0);
}

TEST_P(ExplainUnit, without_its_mistake_among_the_candidates_no_other_is_named_for_it)
{
    for (const KnownSolution& mistake : mistakes) {
        const auto [result, cases] = hand_in(
            worker, exercise, [&](const std::string& name, std::uint64_t seed) { return run(mistake, name, seed); });
        std::vector<KnownSolution> others = mistakes;
        std::erase_if(others, [&](const KnownSolution& other) { return other.name == mistake.name; });
        for (const Explanation& one : explain_unit(worker, exercise, result, cases, others))
            EXPECT_FALSE(one.name.starts_with("mistake: "))
                << mistake.name << " taken for " << one.name << ", " << one.confidence;
    }
}

/// A run in which, of the cells that `wrong` has otherwise than `right`, every `nth` is taken over into `into`.
void take_over(RunOutcome& into, const RunOutcome& right, const RunOutcome& wrong, std::size_t nth)
{
    for (auto& [name, tensor] : into.recording.tensors) {
        const auto is = right.recording.tensors.find(name);
        const auto its = wrong.recording.tensors.find(name);
        if (is == right.recording.tensors.end() || its == wrong.recording.tensors.end()) continue;
        const Tensor& from = its->second;
        if (from.bytes.size() != tensor.bytes.size() || from.present.size() != tensor.present.size()) continue;
        const std::size_t size = tensor.components * size_of(tensor.element);
        std::size_t different = 0;
        for (std::size_t cell = 0; cell < tensor.cells(); ++cell) {
            const auto here = static_cast<std::ptrdiff_t>(cell * size);
            const auto there = static_cast<std::ptrdiff_t>((cell + 1) * size);
            const bool same =
                std::equal(from.bytes.begin() + here, from.bytes.begin() + there, is->second.bytes.begin() + here) &&
                (from.present.empty() || from.present[cell] == is->second.present[cell]);
            if (same || different++ % nth != 0) continue;
            std::copy(from.bytes.begin() + here, from.bytes.begin() + there, tensor.bytes.begin() + here);
            if (!tensor.present.empty()) tensor.present[cell] = from.present[cell];
        }
    }
}

TEST_P(ExplainUnit, two_mistakes_are_the_reason_only_where_most_of_what_each_breaks_is_wrong)
{
    constexpr std::size_t most_pairs = 5;
    int named = 0;
    for (std::size_t i = 0; i < most_pairs && i + 1 < mistakes.size(); ++i) {
        const auto are_named = [&](std::size_t nth) {
            const auto found = explain([&](const std::string& name, std::uint64_t seed) {
                const RunOutcome right = worker.trusted(exercise, Answers::reference, name, seed);
                RunOutcome answer = right;
                for (const KnownSolution* mistake : {&mistakes[i], &mistakes[i + 1]})
                    take_over(answer, right, run(*mistake, name, seed), nth);
                return answer;
            });
            return !found.empty() && found.front().name.starts_with("mistakes: ");
        };
        if (!are_named(1)) continue;
        ++named;
        // Who errs in a fifth of the rows made other mistakes.
        EXPECT_FALSE(are_named(5)) << mistakes[i].name << " and " << mistakes[i + 1].name;
    }
    EXPECT_GT(named, 0);
}

INSTANTIATE_TEST_SUITE_P(Units, ExplainUnit, testing::Values("raytracing/sphere", "projections/view-matrix"),
                         [](const auto& one) {
                             std::string name = one.param;
                             for (char& c : name)
                                 if (c == '/' || c == '-') c = '_';
                             return name;
                         });

}
}
