#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "model/caps.hpp"
#include "planted.hpp"
#include "run/forging.hpp"
#include "run/raw_calls.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

// What a submission can make the grader do is bounded, and nothing that it hands in is the grader's fault.
namespace umbral::grader::test {
namespace {

class Bounds : public testing::Test {
protected:
    UnitResult grade(const Sources& files) { return grade_unit(worker, exercise, {files, {}, ""}, {}); }

    Workbench bench;
    Exercise exercise = bench.exercise("raytracing/sphere");
    Worker worker{bench.tools()};
    std::string good = project_file("reference/raytracing/sphere.cpp");
};

TEST_F(Bounds, two_cases_run_into_the_time_limit_and_the_rest_is_not_reached)
{
    exercise.limits.wall_seconds = 0.3;
    const Sources files{{"sphere.cpp", sphere_with("", "    for (volatile int i = 0;; i = i + 1) {}")}};
    const UnitResult result = grade(files);
    EXPECT_EQ(result.verdict, Verdict::timeout);
    EXPECT_EQ(result.score, 0);
    EXPECT_NE(result.message.find("not reached: 2 cases used up their time or memory"), std::string::npos)
        << result.message;
    std::map<std::string, std::string> cases;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i)
        cases[exercise.checks[i].case_name] = result.checks[i].message;
    EXPECT_EQ(std::ranges::count_if(
                  cases, [](const auto& one) { return one.second.find("stopped after") != std::string::npos; }),
              caps::endless_cases);
    EXPECT_EQ(std::ranges::count_if(cases, [](const auto& one) { return one.second.starts_with("not reached"); }),
              static_cast<std::ptrdiff_t>(cases.size()) - caps::endless_cases);
    const UnitResult again = grade(files);
    for (std::size_t i = 0; i < result.checks.size(); ++i) EXPECT_EQ(again.checks[i].message, result.checks[i].message);
}

TEST_F(Bounds, cases_that_are_all_slow_take_a_few_limits_together_and_the_rest_is_not_reached)
{
    exercise.limits.wall_seconds = 1;
    // Each case computes for a bit less than its limit, once.
    const Sources files{{"sphere.cpp", sphere_with("#include <ctime>\n",
                                                   "    static const bool slow = [] {\n"
                                                   "        while (std::clock() < 0.7 * CLOCKS_PER_SEC) {}\n"
                                                   "        return true;\n"
                                                   "    }();\n    (void)slow;\n")}};
    const auto begin = std::chrono::steady_clock::now();
    const UnitResult result = grade(files);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::set<std::string> reached;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i)
        if (!result.checks[i].message.starts_with("not reached")) reached.insert(exercise.checks[i].case_name);
    EXPECT_GE(reached.size(), 3U);
    EXPECT_LE(reached.size(), 5U);
    EXPECT_LT(taken.count(), 60);
}

TEST_F(Bounds, what_the_units_of_a_submission_share_is_taken_once)
{
    exercise.limits.wall_seconds = 0.3;
    GradeOptions options;
    options.budgets.running = std::make_shared<TimeBudget>(0.1, 0.4);
    const auto graded = [&](const char* body) {
        return grade_unit(worker, exercise, {{{"sphere.cpp", body == nullptr ? good : sphere_with("", body)}}, {}, ""},
                          options);
    };
    // Its first case takes what is its own and the half of what all share, its second one the rest.
    const UnitResult hangs = graded("    for (volatile int i = 0;; i = i + 1) {}");
    EXPECT_EQ(hangs.verdict, Verdict::timeout);
    EXPECT_FALSE(hangs.settled) << "beside other units it would be run for longer";
    EXPECT_LE(options.budgets.running->left(), 0.1);
    // A unit that takes its usual time has that of its own.
    options.budgets.running = std::make_shared<TimeBudget>(caps::run_seconds, 0);
    const UnitResult right = graded(nullptr);
    EXPECT_EQ(right.score, right.max_score) << right.message;
    EXPECT_TRUE(right.settled);
    EXPECT_DOUBLE_EQ(options.budgets.running->left(), 0);
    // What has none is not run on, and not for a reason either.
    options.budgets.running = std::make_shared<TimeBudget>(0, 0);
    const UnitResult none = graded("    if (ray.direction.x > 0) return 1.0F;");
    EXPECT_NE(none.message.find("all units more than the 240 s that they share"), std::string::npos) << none.message;
    EXPECT_TRUE(std::ranges::none_of(none.checks, [](const CheckResult& check) { return check.simplest.has_value(); }));
}

TEST_F(Bounds, one_case_that_hangs_costs_itself_only)
{
    exercise.limits.wall_seconds = 0.3;
    // The rays of "behind and before" alone start within the sphere or behind it in this number.
    const UnitResult result = grade(
        {{"sphere.cpp",
          sphere_with("",
                      "    static int calls = 0;\n    if (++calls > 4000) for (volatile int i = 0;; i = i + 1) {}")}});
    EXPECT_EQ(result.message.find("not reached"), std::string::npos) << result.message;
    EXPECT_GT(result.score, 0);
}

TEST_F(Bounds, files_that_the_unit_does_not_name_change_nothing)
{
    Sources files{{"sphere.cpp", good}};
    for (int i = 0; i < 31; ++i) files["x" + std::to_string(i) + ".glsl"] = std::string(std::size_t{60} << 10U, '\1');
    const UnitResult result = grade(files);
    EXPECT_EQ(to_string(result.verdict), "ok") << result.message;
}

TEST_F(Bounds, more_files_than_are_taken_are_the_students_own_trouble)
{
    Sources files{{"sphere.cpp", good}};
    for (int i = 0; i < 31; ++i) files["x" + std::to_string(i) + ".glsl"] = std::string(std::size_t{512} << 10U, '\1');
    const UnitResult result = grade(files);
    EXPECT_EQ(to_string(result.verdict), "missing");
    EXPECT_EQ(result.max_score, exercise.points);
    EXPECT_NE(result.message.find("at most 2048 KiB"), std::string::npos) << result.message;
}

TEST_F(Bounds, far_too_many_rows_are_counted_and_not_judged)
{
    const std::string forged =
        "    Header* r = find(); put(r, \"t\", {1, 9000000, 1, 1, 0, 0}, 36000000, 0); finish(r);";
    const UnitResult result = grade(planted(bench, sphere_with(raw_calls + find_recording, forged)));
    EXPECT_EQ(result.score, 0);
    const auto head_on = std::ranges::find(result.checks, "head-on/t", &CheckResult::name);
    ASSERT_NE(head_on, result.checks.end());
    EXPECT_EQ(head_on->message, "recorded 9000000 rows, expected 14");
    const auto picture = std::ranges::find(result.checks, "picture/ids", &CheckResult::name);
    EXPECT_EQ(picture->message, "nothing was recorded: the run was disturbed");
}

TEST_F(Bounds, code_that_takes_its_time_is_not_run_for_every_question)
{
    SpareTime time;
    EXPECT_FALSE(time.is_left());
    time.allow(1);
    RunOutcome run;
    run.cpu_seconds = 0.6;
    run.wall_seconds = 0.7;
    EXPECT_EQ(time.spent_on(run).cpu_seconds, 0.6);
    EXPECT_TRUE(time.is_left());
    // What a busy machine takes costs nothing; who sleeps pays for all of it.
    run.cpu_seconds = 0;
    run.wall_seconds = 1;
    run.waited_seconds = 0.9;
    (void)time.spent_on(run);
    EXPECT_TRUE(time.is_left());
    run.waited_seconds = 0.5;
    (void)time.spent_on(run);
    EXPECT_FALSE(time.is_left());
    // Wrong answers that come at once are looked into, and leave time.
    const UnitResult quick = grade({{"sphere.cpp", sphere_with("", "    if (ray.direction.x > 0) return 1.0F;")}});
    EXPECT_TRUE(std::ranges::any_of(quick.checks, [](const CheckResult& check) { return check.simplest.has_value(); }));
    EXPECT_TRUE(worker.spare_time().is_left());
}

TEST_F(Bounds, what_was_refused_is_reason_enough)
{
    const UnitResult result =
        grade(planted(bench, sphere_with(raw_calls, "    raw(SYS_getppid);\n    return ray.t_min + 1.0F;")));
    EXPECT_EQ(to_string(result.verdict), "blocked") << result.message;
    EXPECT_TRUE(result.explanations.empty());
    EXPECT_TRUE(std::ranges::all_of(result.checks, [](const CheckResult& check) { return check.common.empty(); }));
}

TEST_F(Bounds, what_was_printed_and_said_is_capped)
{
    const UnitResult result =
        grade({{"sphere.cpp", sphere_with("",
                                          "    for (int i = 0; i < 3000; ++i) std::printf(\"%d %p\\n\", i, (const "
                                          "void*)&ray);\n    throw std::runtime_error(std::string(100000, 'x') + "
                                          "std::to_string(ray.origin.x + ray.direction.y));")}});
    EXPECT_LE(result.output.size(), caps::printed + 100);
    EXPECT_LE(result.message.size(), caps::message + 100);
    for (const CheckResult& check : result.checks) EXPECT_LE(check.message.size(), caps::message + 100);
}

TEST_F(Bounds, no_text_shows_where_things_lie_on_this_machine)
{
    // The C library's assert names the program and the header; the exception's text is the student's own.
    const std::string text =
        sphere_with("#include <umbral/core/grid.hpp>\n",
                    "    std::printf(\"%s\\n\", UMBRAL_HERE); throw std::runtime_error(UMBRAL_HERE);");
    std::string here = text;
    for (std::size_t at = 0; (at = here.find("UMBRAL_HERE")) != std::string::npos;)
        here.replace(at, 11,
                     "\"" + (bench.tools().reference / "raytracing/sphere.cpp").string() + " " +
                         (bench.tools().cache / "builds").string() + "\"");
    const UnitResult result = grade({{"sphere.cpp", here}});
    for (const std::string& said : {result.message, result.output, result.checks.front().message}) {
        EXPECT_NE(said.find("raytracing/sphere.cpp builds"), std::string::npos) << said;
        EXPECT_EQ(said.find(bench.tools().cache.string()), std::string::npos) << said;
        EXPECT_EQ(said.find(UMBRAL_SOURCE_DIR), std::string::npos) << said;
    }
}

}
}
