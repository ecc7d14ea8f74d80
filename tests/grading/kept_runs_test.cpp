#include <gtest/gtest.h>

#include <set>

#include "build/build_cache.hpp"
#include "store/kept_run.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "worker/seeds.hpp"
#include "worker/unit_key.hpp"

// Trusted runs that are kept on the disk: used again, and never where they could be wrong.
namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class KeptRuns : public testing::Test {
protected:
    Workbench bench;
    const Exercise sphere = bench.exercise("raytracing/sphere");

    [[nodiscard]] std::shared_ptr<const UnitKeys> keys(unsigned attempt = 0) const
    {
        KeyPlan plan;
        plan.grading.attempt = attempt;
        return std::make_shared<const UnitKeys>(bench.tools(), std::vector{sphere}, plan);
    }

    [[nodiscard]] std::set<fs::path> files() const
    {
        std::set<fs::path> found;
        std::error_code none;
        for (const auto& entry : fs::recursive_directory_iterator(runs_folder(bench.tools().cache), none))
            if (entry.is_regular_file()) found.insert(entry.path());
        return found;
    }

    /// The reference's recording of a case, by a worker that remembers nothing.
    [[nodiscard]] RunOutcome reference(const std::string& case_name, std::shared_ptr<const UnitKeys> keys) const
    {
        Worker worker(bench.tools());
        worker.keep_runs(std::move(keys));
        return worker.trusted(sphere, Answers::reference, case_name, SeedPlan{}.seed_of(sphere, case_name));
    }
};

TEST_F(KeptRuns, are_used_again)
{
    const RunOutcome first = reference("head-on", keys());
    ASSERT_EQ(files().size(), 1U);
    const RunOutcome again = reference("head-on", keys());
    EXPECT_EQ(again.recording.tensors, first.recording.tensors);
    // Reports set a student's time beside the reference's.
    EXPECT_GT(first.wall_seconds, 0);
    EXPECT_EQ(again.wall_seconds, first.wall_seconds);
    EXPECT_EQ(again.cpu_seconds, first.cpu_seconds);
    // What was kept is what is used: here it says something else.
    KeptRun other = *kept_run(*files().begin());
    other.tensors.at("t").bytes[0] ^= std::byte{1};
    keep_run(*files().begin(), other);
    EXPECT_EQ(reference("head-on", keys()).recording.tensors, other.tensors);
    EXPECT_EQ(reference("head-on", nullptr).recording.tensors, first.recording.tensors);
}

TEST_F(KeptRuns, are_run_again_if_damaged_or_if_the_key_is_another)
{
    const RunOutcome first = reference("head-on", keys());
    const fs::path file = *files().begin();
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(reference("head-on", keys()).recording.tensors, first.recording.tensors);
    EXPECT_TRUE(kept_run(file));
    (void)reference("head-on", keys(1));
    EXPECT_EQ(files().size(), 2U);
}

TEST_F(KeptRuns, are_of_visible_cases_only)
{
    int hidden = 0;
    for (const Check& check : sphere.checks)
        if (check.hidden) (void)reference(check.case_name, keys()), ++hidden;
    EXPECT_GT(hidden, 0);
    EXPECT_TRUE(files().empty());
}

TEST_F(KeptRuns, cost_nobody_a_result_where_they_cannot_be_written)
{
    bench.write(fs::relative(runs_folder(bench.tools().cache), bench.folder()), "a file where the folder would be");
    EXPECT_EQ(reference("head-on", keys()).verdict, Verdict::ok);
}

}
}
