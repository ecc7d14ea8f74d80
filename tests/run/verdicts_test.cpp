#include <gtest/gtest.h>

#include <fstream>

#include "grading/planted.hpp"
#include "raw_calls.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader::test {
namespace {

/// A sphere.cpp and what must become of it.
struct Submission {
    const char* name;
    std::string text;
    Verdict verdict;
    std::string says;  ///< a part of the message
};

std::string with(const std::string& first) { return sphere_with("", first); }

std::string answer(const std::string& body)
{
    return "namespace umbral::raytracing {\n\nstd::optional<float> intersect(const Ray& ray, const Sphere& "
           "sphere)\n{\n" +
           body + "\n}\n\n}\n";
}

std::vector<Submission> submissions()
{
    return {
        {"ok", project_file("reference/raytracing/sphere.cpp"), Verdict::ok, ""},
        {"partial", with(""), Verdict::partial, ""},
        {"wrong", answer("    return 12345.0F * (ray.t_min + sphere.radius);"), Verdict::wrong, ""},
        {"not_implemented",
         answer("    const float unused = ray.t_min;\n    return not_implemented<std::optional<float>>(ray, sphere, "
                "unused);"),
         Verdict::not_implemented, ""},
        {"compile_error", answer("    return ray.nonsense + sphere.radius;"), Verdict::compile_error, "sphere.cpp:5:"},
        {"interface_mismatch",
         "namespace umbral::raytracing {\nstd::optional<float> intersect(const Ray& ray, Sphere&) { return ray.t_min; "
         "}\n}\n",
         Verdict::interface_mismatch, "Sphere&"},
        {"forbidden", sphere_with("#include <cstdlib>\n", "    if (std::system(\"id\") != 0) return std::nullopt;"),
         Verdict::forbidden, "system"},
        {"assertion",
         sphere_with("#include <cassert>\n", "    assert(sphere.radius < 0 && \"the ball is inside out\");"),
         Verdict::crashed, "sphere.cpp:7"},
        {"glibcxx_assertion", with("    std::vector<float> none;\n    if (none[3] > 0) return std::nullopt;"),
         Verdict::crashed, "sphere.cpp:7"},
        {"segmentation_fault", with("    volatile float* nowhere = nullptr;\n    *nowhere = ray.t_min;"),
         Verdict::crashed, "sphere.cpp:7"},
        {"division_by_zero",
         with("    volatile int zero = 0;\n    volatile int seven = 7 / zero;\n    if (seven == 7) return "
              "std::nullopt;"),
         Verdict::crashed, "sphere.cpp:7"},
        {"exception", with("    if (ray.t_min < 1000) throw std::runtime_error(\"no such ball\");"), Verdict::crashed,
         "std::runtime_error: no such ball"},
        {"exception_of_its_own", with("    if (ray.t_min < 1000) throw 17;"), Verdict::crashed, "not a std::exception"},
        {"stack_overflow",
         sphere_with("static int down(volatile int n) { volatile char big[4096]; big[0] = 1; return n == -1 ? 0 : "
                     "down(n + 1) + big[0]; }\n",
                     "    if (down(0) == 7) return std::nullopt;"),
         Verdict::crashed, "stack overflowed"},
        {"jump_to_nowhere", with("    auto* nowhere = reinterpret_cast<void (*)()>(16);\n    nowhere();"),
         Verdict::crashed, "signal 11"},
        {"abort", with("    std::abort();"), Verdict::crashed, "signal 6"},
        {"exit", with("    std::exit(0);"), Verdict::crashed, "exit"},
        {"throws_at_start",
         sphere_with(
             "static int thrown() { throw std::runtime_error(\"at start\"); }\nstatic const int value = thrown();\n",
             "    if (value == 7) return std::nullopt;"),
         Verdict::crashed, "at start"},
        {"endless_loop", with("    for (volatile int i = 0;; i = i + 1) {}"), Verdict::timeout, "loop that never ends"},
        {"endless_loop_at_start",
         sphere_with(
             "static int loop() { for (volatile int i = 0;; i = i + 1) {} }\nstatic const int value = loop();\n",
             "    if (value == 7) return std::nullopt;"),
         Verdict::timeout, "stopped after"},
        {"sleep", sphere_with(raw_calls, "    const long hour[2] = {3600, 0};\n    raw(SYS_nanosleep, hour, 0);"),
         Verdict::timeout, "hardly computed"},
        {"too_much_memory",
         with("    std::vector<std::vector<char>> all;\n    for (;;) all.emplace_back(1U << 24U, 'x');"),
         Verdict::out_of_memory, "512 MiB"},
        {"too_much_at_once",
         with("    const std::vector<double> all(std::size_t{1} << 33U, ray.t_min);\n    if (all[7] == 7) return "
              "std::nullopt;"),
         Verdict::out_of_memory, "512 MiB"},
        {"too_large_array",
         sphere_with(
             "static char everything[std::size_t{900} << 20U];\n",
             "    everything[static_cast<int>(sphere.radius)] = 1;\n    if (everything[0] == 7) return std::nullopt;"),
         Verdict::out_of_memory, "512 MiB"},
    };
}

UnitResult grade(const Toolchain& tools, const Exercise& original, const Handed& handed, double wall_seconds = 5)
{
    Worker worker(tools);
    Exercise exercise = original;
    exercise.limits.wall_seconds = wall_seconds;
    GradeOptions options;
    options.explain = false;
    return grade_unit(worker, exercise, handed, options);
}

class Verdicts : public testing::TestWithParam<Submission> {};

TEST_P(Verdicts, are_what_the_file_deserves)
{
    const Workbench bench;
    const Submission& submission = GetParam();
    const double seconds = submission.verdict == Verdict::timeout ? 0.5 : 5;
    // What calls the kernel directly needs assembler, which the builder refuses.
    const bool is_raw = submission.text.find(raw_calls) != std::string::npos;
    const Sources files = is_raw ? planted(bench, submission.text) : Sources{{"sphere.cpp", submission.text}};
    const UnitResult result = grade(bench.tools(), bench.exercise("raytracing/sphere"), {files, {}, ""}, seconds);
    EXPECT_EQ(to_string(result.verdict), to_string(submission.verdict)) << result.message;
    EXPECT_NE(result.message.find(submission.says), std::string::npos) << result.message;
    EXPECT_EQ(result.max_score, 10000);
    if (submission.verdict == Verdict::ok) {
        EXPECT_EQ(result.score, 10000);
    } else if (submission.verdict == Verdict::partial) {
        EXPECT_TRUE(result.score > 0 && result.score < 10000) << result.score;
    } else {
        EXPECT_EQ(result.score, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Verdicts, testing::ValuesIn(submissions()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(VerdictsOfOthers, an_assertion_is_shown_with_its_text)
{
    const Workbench bench;
    const std::string text =
        sphere_with("#include <cassert>\n", "    assert(sphere.radius < 0 && \"the ball is inside out\");");
    const UnitResult result =
        grade(bench.tools(), bench.exercise("raytracing/sphere"), {{{"sphere.cpp", text}}, {}, ""});
    EXPECT_NE(result.output.find("the ball is inside out"), std::string::npos) << result.output;
}

// A cache in ~/.cache/umbral has the project's name in its path, as the framework's headers have.
TEST(VerdictsOfOthers, a_place_is_told_wherever_the_cache_lies)
{
    const Workbench bench;
    Toolchain tools = bench.tools();
    tools.cache = bench.folder() / "umbral";
    const std::string text = sphere_with("", "    volatile float* nowhere = nullptr;\n    *nowhere = 1;");
    const UnitResult result = grade(tools, bench.exercise("raytracing/sphere"), {{{"sphere.cpp", text}}, {}, ""});
    EXPECT_NE(result.message.find("at sphere.cpp:7"), std::string::npos) << result.message;
}

TEST(VerdictsOfOthers, missing_and_refused_files_are_missing)
{
    const Workbench bench;
    const Exercise exercise = bench.exercise("raytracing/sphere");
    const UnitResult result = grade(bench.tools(), exercise, {{}, {"sphere.cpp"}, ""});
    EXPECT_EQ(result.verdict, Verdict::missing);
    EXPECT_NE(result.message.find("sphere.cpp"), std::string::npos);
    EXPECT_EQ(grade(bench.tools(), exercise, {{}, {}, "sphere.cpp: it is a link"}).verdict, Verdict::missing);
}

// Without the driver nobody's work can run: no zero, but no points to reach either.
TEST(VerdictsOfOthers, a_missing_driver_is_a_fault_of_the_grader)
{
    namespace fs = std::filesystem;
    const Workbench bench;
    Toolchain tools = bench.tools();
    tools.units = bench.folder() / "units";
    fs::create_directories(tools.units / "raytracing/sphere");
    fs::copy(bench.tools().units / "framework-exports.txt", tools.units);
    for (const char* const file : {"exports.txt", "exports.map", "reference.so", "oracle.so"})
        fs::copy(bench.tools().units / "raytracing/sphere" / file, tools.units / "raytracing/sphere");
    const Handed good{{{"sphere.cpp", project_file("reference/raytracing/sphere.cpp")}}, {}, ""};
    const UnitResult absent = grade(tools, bench.exercise("raytracing/sphere"), good);
    EXPECT_EQ(absent.verdict, Verdict::grader_fault) << absent.message;
    EXPECT_EQ(absent.max_score, 0);
    EXPECT_NE(absent.message.find("driver.so"), std::string::npos) << absent.message;

    // A driver that is there and broken shows in the reference's own run.
    std::ofstream(tools.units / "raytracing/sphere/driver.so") << "not a library";
    const UnitResult broken = grade(tools, bench.exercise("raytracing/sphere"), good);
    EXPECT_EQ(broken.verdict, Verdict::grader_fault) << broken.message;
    EXPECT_EQ(broken.max_score, 0);
}

}
}
