#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explain/explain_unit.hpp"
#include "planted.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "report/terminal.hpp"
#include "run/forging.hpp"
#include "run/raw_calls.hpp"
#include "support/workbench.hpp"
#include "unit/evidence.hpp"
#include "unit/grade_unit.hpp"

// A submission that puts its hidden inputs into whatever a report might repeat: what students read must be the same,
// whatever the inputs were.
namespace umbral::grader::test {
namespace {

/// C++ that makes a number of the inputs of a call.
const std::string secret_of_inputs = R"(
#include <cstring>
#include <string>
namespace {
unsigned bits(float value) { unsigned result; std::memcpy(&result, &value, sizeof result); return result; }
template <class R, class S>
unsigned secret(const R& ray, const S& sphere)
{
    unsigned hash = 2166136261U;
    for (const float value : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                              ray.direction.z, sphere.centre.x, sphere.radius})
        hash = (hash ^ bits(value)) * 16777619U;
    return hash ^ hash >> 15;
}
}
)";

/// A way to say the number `h`.
struct Channel {
    const char* name;
    const char* code;
    bool in_instructors;  ///< the full result holds the secret, so that leaving it out is what is tested
};

const std::vector<Channel> channels = {
    {"numbers_of_refused_calls", "for (int i = 0; i < 32; ++i) raw(500 + 2 * i + ((h >> i) & 1));", false},
    {"which_known_calls_are_refused",
     "if (h & 1) raw(SYS_socket, 1, 1, 0); else raw(SYS_fork); if (h & 2) raw(SYS_execve, 0, 0, 0);", false},
    {"printed_text", "std::printf(\"%x\\n\", h); std::fprintf(stderr, \"%x\\n\", h);", false},
    {"exception_text", "throw std::runtime_error(std::to_string(h));", true},
    {"exception_type",
     "if (h & 1) throw std::runtime_error(\"x\"); if (h & 2) throw std::out_of_range(\"x\"); if (h & 4) throw h; throw "
     "std::logic_error(\"x\");",
     true},
    {"assertion_text", "std::fprintf(stderr, \"Assertion %x\\n\", h); std::abort();", true},
    {"exit_status", "raw(SYS_exit_group, h & 255);", false},
    {"place_of_crash",
     "volatile int* nowhere = nullptr;\nif (h & 1) {\n*nowhere = 1; }\nif (h & 2) {\n*nowhere = 2; }\nif (h & 4) "
     "{\n*nowhere = 3; }\n*nowhere = 4;",
     true},
    {"kind_of_signal", "volatile int zero = 0; if (h & 1) __builtin_trap(); if (h & 2) zero = 7 / zero; std::abort();",
     true},
    {"note_and_text", "Header* r = find(); r->note = 1; std::snprintf(r->text, sizeof r->text, \"%x\", h); leave();",
     true},
    {"damage", "Header* r = find(); r->tensor_count = 257 + h; finish(r);", true},
    {"count_of_stubs_and_frames",
     "Header* r = find(); r->refused_count = h; for (auto& one : r->refused) one = h & 511; leave();", true},
    {"number_of_rows",
     "Header* r = find(); put(r, \"t\", {1, 20 + h % 60, 1, 1, 0, 0}, (20 + h % 60) * 4, 0); finish(r);", true},
    {"far_too_many_rows",
     "Header* r = find(); put(r, \"t\", {1, 100000 + h % 10000, 1, 1, 0, 0}, (100000 + h % 10000) * 4, 0); finish(r);",
     true},
    {"size_of_a_picture",
     "Header* r = find(); put(r, \"ids\", {3, 20 + h % 60, 8, 1, 0, 0}, (20 + h % 60) * 32, 0); put(r, \"t\", {1, 1, "
     "1, 1, 0, 0}, 4, 0); finish(r);",
     false},
    {"names_of_tensors",
     "Header* r = find(); const std::string name = \"n\" + std::to_string(h); put(r, name.c_str(), {1, 1, 1, 1, 0, 0}, "
     "4, 0); finish(r);",
     false},
    {"payload_of_nan",
     "Header* r = find(); put(r, \"t\", {1, 1000, 1, 1, 0, 0}, 4000, 0); char* at = reinterpret_cast<char*>(r) + "
     "umbral::wire::tensors_offset + "
     "sizeof(umbral::wire::TensorHeader) + 8; "
     "const unsigned nan = 0x7fc00000 | (h & 0xfffff); for (int i = 0; i < 1000; ++i) std::memcpy(at + 4 * i, &nan, "
     "4); finish(r);",
     false},
    {"values", "return static_cast<float>(h & 0xffffff);", true},
    {"type_of_a_tensor",
     "Header* r = find(); put(r, \"t\", {h % 2 ? 2U : 3U, 8, 1, 1, 0, 0}, h % 2 ? 64 : 32, 0); finish(r);", true},
};

/// What a student reads of a submission with this unit, without times.
struct StudentsEdition {
    std::string json;
    std::string html;
    std::string terminal;
};

StudentsEdition edition_of(UnitResult unit, const html::UnitDetail& detail)
{
    unit.seconds = unit.reference_seconds = 0;
    if (unit.curve) {
        unit.curve->yours.seconds = 1;
        for (CurvePoint& other : unit.curve->others) other.seconds = 1;
    }
    SubmissionResult submission{"ada", 0, 0, {std::move(unit)}};
    add_up(submission);
    return {to_json(without_hidden_values(submission), {}).dump(1),
            html::report_html(submission, {}, {{submission.units.front().id, detail}}),
            terminal_report(submission, {})};
}

class HiddenChannel : public testing::TestWithParam<Channel> {
protected:
    GradedUnit grade(const Sources& files, const std::string& secret)
    {
        GradeOptions options;
        options.seeds.secret = secret;
        // What instructors get must not change what students do.
        options.show_hidden = true;
        return grade_with_evidence(worker, exercise, {files, {}, ""}, options);
    }

    Workbench bench;
    Exercise exercise = bench.exercise("raytracing/sphere");
    Worker worker{bench.tools()};
};

TEST_P(HiddenChannel, says_nothing_to_students)
{
    const std::string code =
        std::string("    [[maybe_unused]] const unsigned h = secret(ray, sphere);\n") + GetParam().code;
    const bool ordinary = code.find("raw(") == std::string::npos && code.find("find()") == std::string::npos;
    const Sources files = ordinary ? Sources{{"sphere.cpp", sphere_with(secret_of_inputs, code)}}
                                   : planted(bench, sphere_with(raw_calls + find_recording + secret_of_inputs, code));
    const GradedUnit one = grade(files, "one secret");
    const StudentsEdition a = edition_of(one.result, one.detail);
    const auto full = [](const GradedUnit& graded) { return to_json(graded.result)["checks"].dump(); };
    bool carried = !GetParam().in_instructors;
    // A channel of a bit or two says the same of many secrets.
    for (int i = 0; i < 8 && (i == 0 || !carried); ++i) {
        const GradedUnit other = grade(files, "another " + std::to_string(i));
        for (const GradedUnit* graded : {&one, &other}) {
            ASSERT_NE(to_string(graded->result.verdict), "grader_fault") << graded->result.message;
            ASSERT_NE(to_string(graded->result.verdict), "compile_error") << graded->result.message;
            ASSERT_NE(to_string(graded->result.verdict), "forbidden") << graded->result.message;
        }
        ASSERT_EQ(one.result.score, other.result.score) << "points are no part of this comparison";
        const StudentsEdition b = edition_of(other.result, other.detail);
        EXPECT_EQ(a.json, b.json);
        EXPECT_EQ(a.terminal, b.terminal);
        EXPECT_TRUE(a.html == b.html) << "the pages differ";
        carried = carried || full(one) != full(other);
    }
    EXPECT_TRUE(carried) << "this channel carries nothing, even in the instructors' result: the test shows nothing";
}

INSTANTIATE_TEST_SUITE_P(All, HiddenChannel, testing::ValuesIn(channels),
                         [](const auto& one) { return std::string(one.param.name); });

class HiddenCases : public testing::Test {
protected:
    Workbench bench;
    Exercise exercise = bench.exercise("raytracing/sphere");
    Worker worker{bench.tools()};
};

TEST_F(HiddenCases, how_long_they_took_is_not_in_the_sum)
{
    std::erase_if(exercise.checks, [](const Check& check) { return !check.hidden; });
    ASSERT_FALSE(exercise.checks.empty());
    const UnitResult result = grade_unit(worker, exercise, {{{"sphere.cpp", sphere_with("", "")}}, {}, ""}, {});
    ASSERT_NE(to_string(result.verdict), "grader_fault") << result.message;
    EXPECT_EQ(result.seconds, 0);
    EXPECT_EQ(result.reference_seconds, 0);
}

// A known mistake of which nothing shows where it can be seen.
TEST_F(HiddenCases, an_explanation_that_only_they_lead_to_is_not_for_students)
{
    int explained = 0;
    for (const KnownSolution& mistake : explaining_mistakes(worker, exercise)) {
        Exercise seldom = exercise;
        seldom.checks.clear();
        CaseResults cases;
        UnitResult result;
        for (const Check& check : exercise.checks) {
            CaseResult one;
            one.seed = SeedPlan{}.seed_of(exercise, check.case_name);
            one.hidden = check.hidden;
            one.student =
                worker.run_known(exercise, "mistakes/" + mistake.name, mistake.sources, check.case_name, one.seed);
            const CheckResult judged =
                judge_check(check, one, worker.trusted(exercise, judged_against(check), check.case_name, one.seed),
                            worker.trusted(exercise, Answers::reference, check.case_name, one.seed));
            if (!check.hidden && judged.score < check.points) continue;
            seldom.checks.push_back(check);
            result.checks.push_back(judged);
            result.score += judged.score;
            result.max_score += check.points;
            cases.emplace(check.case_name, std::move(one));
        }
        result.explanations = explain_unit(worker, seldom, result, cases);
        explained += result.explanations.empty() ? 0 : 1;
        for (const Explanation& one : result.explanations) EXPECT_TRUE(one.hidden) << mistake.name << ": " << one.name;
        EXPECT_TRUE(without_hidden_values({"ada", 0, 0, {result}, {}}).units[0].explanations.empty());
    }
    EXPECT_GT(explained, 0);
}

TEST_F(HiddenCases, a_run_gets_a_number_from_which_no_seed_follows)
{
    for (const std::string& name : exercise.cases()) {
        const std::uint64_t stream = stream_of(exercise, name, 7);
        EXPECT_EQ(stream, stream_of(exercise, name, 7));
        EXPECT_EQ(stream == 7, !is_hidden_case(exercise, name)) << name;
    }
    // SHA-256 of the length of the domain, the domain and the seed, computed with Python's hashlib; and the mark of
    // varied inputs.
    EXPECT_EQ(stream_of(exercise, "random", 7), 0xffff'2bbd'6f0e'ac9aU);
}

TEST_F(HiddenCases, other_files_meet_other_inputs_and_the_same_files_the_same)
{
    SeedPlan plan;
    plan.work = work_digest({{"sphere.cpp", "a"}});
    SeedPlan changed = plan;
    changed.work = work_digest({{"sphere.cpp", "b"}});
    EXPECT_EQ(plan.work, work_digest({{"sphere.cpp", "a"}}));
    EXPECT_NE(work_digest({{"ab", "c"}}), work_digest({{"a", "bc"}}));
    for (const std::string& name : exercise.cases()) {
        EXPECT_EQ(plan.seed_of(exercise, name) != changed.seed_of(exercise, name), is_hidden_case(exercise, name))
            << name;
        EXPECT_EQ(plan.fresh_seed_of(exercise, name) != changed.fresh_seed_of(exercise, name),
                  is_hidden_case(exercise, name))
            << name;
    }
    EXPECT_EQ(plan.seed_of(exercise, "head-on"), SeedPlan{}.seed_of(exercise, "head-on"))
        << "visible cases stay as they are";
}

}
}
