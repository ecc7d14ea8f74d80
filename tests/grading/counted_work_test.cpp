#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <any>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <umbral/core/not_implemented_count.hpp>

#include "judge/cost/cost.hpp"
#include "manifest/units.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "worker/known_solutions.hpp"

extern "C" void __sanitizer_cov_trace_pc();

// Work that hides from its count, on meshes/weld, whose largest soup has 16,224 corners; and honest work, which must
// never be taken for it.
namespace umbral::grader::test {
namespace {

class CountedWork : public testing::Test {
protected:
    Workbench bench;
    Worker worker{bench.tools()};

    UnitResult grade(const Exercise& exercise, const Sources& sources)
    {
        GradeOptions options;
        options.explain = false;
        return grade_unit(worker, exercise, {sources, {}, ""}, options);
    }

    /// Welds by looking through all vertices. `before` comes in front of the search, which begins with `first` and ends
    /// with `last`.
    UnitResult grade_search(const std::string& before, const std::string& attribute, const std::string& first,
                            const std::string& last)
    {
        const std::string text = fmt::format(R"(#include <umbral/core/not_implemented_count.hpp>
#include <umbral/meshes/weld.hpp>
{}
namespace umbral::meshes {{
namespace {{
{} std::uint32_t vertex_of(std::vector<glm::vec3>& positions, const glm::vec3& corner)
{{
    {}
    const bool number = corner == corner;
    std::uint32_t i = 0;
    while (i < positions.size() && !(number && positions[i] == corner)) ++i;
    if (i == positions.size()) positions.push_back(corner);
    {}
    return i;
}}
}}
IndexedMesh weld(const std::vector<glm::vec3>& corners)
{{
    IndexedMesh mesh;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {{
        const auto a = vertex_of(mesh.positions, corners[i]), b = vertex_of(mesh.positions, corners[i + 1]);
        mesh.triangles.emplace_back(a, b, vertex_of(mesh.positions, corners[i + 2]));
    }}
    return mesh; }}
std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{{
    std::vector<glm::vec3> corners;
    for (const glm::uvec3& t : mesh.triangles)
        corners.insert(corners.end(), {{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]}});
    return corners;
}} }}
)",
                                             before, attribute, first, last);
        return grade(bench.exercise("meshes/weld"), {{"weld.cpp", text}});
    }
};

/// Points of the checks that count work, and the most that there are.
std::pair<Millipoints, Millipoints> cost_points(const UnitResult& result)
{
    std::pair<Millipoints, Millipoints> points;
    for (const CheckResult& check : result.checks)
        if (check.kind == JudgeKind{"cost"}) points.first += check.score, points.second += check.max_score;
    return points;
}

/// Of checks that say nothing of costs. Many vertices are asked only of those who do not take too long.
Millipoints other_points(const UnitResult& result)
{
    Millipoints points = 0;
    for (const CheckResult& check : result.checks)
        if (check.kind != JudgeKind{"cost"} && !check.name.starts_with("many vertices/")) points += check.score;
    return points;
}

std::string messages(const UnitResult& result)
{
    std::string text = result.message;
    for (const CheckResult& check : result.checks) text += "\n" + check.message;
    return text;
}

/// From a function that students may name to the counter, found as an attacker would: in the instruction that adds to
/// it.
std::ptrdiff_t distance_to_the_counter()
{
    const auto* const code = reinterpret_cast<const unsigned char*>(&__sanitizer_cov_trace_pc);
    for (int i = 0; i < 16; ++i) {
        if (code[i] != 0x48 || code[i + 1] != 0x83 || code[i + 2] != 0x05) continue;  // add qword ptr [rip + n], 1
        std::int32_t relative = 0;
        std::memcpy(&relative, code + i + 3, sizeof relative);
        return code + i + 8 + relative - reinterpret_cast<const unsigned char*>(&not_implemented_count);
    }
    throw std::runtime_error("the counter is no single instruction any more");
}

/// Threads that use up processor and caches.
class Load {
public:
    explicit Load(int threads)
    {
        for (int i = 0; i < threads; ++i)
            threads_.emplace_back([this] {
                std::vector<int> numbers(std::size_t{1} << 21U);
                while (!over_)
                    for (int& number : numbers) ++number;
            });
    }
    Load(const Load&) = delete;
    Load& operator=(const Load&) = delete;
    ~Load()
    {
        over_ = true;
        for (std::thread& thread : threads_) thread.join();
    }

private:
    std::atomic<bool> over_ = false;
    std::vector<std::thread> threads_;
};

}

TEST_F(CountedWork, that_is_measured_after_work_which_nobody_counts_is_a_fault_of_the_grader)
{
    Exercise exercise = bench.exercise("meshes/weld");
    for (Check& check : exercise.checks)
        if (auto* parameters = std::any_cast<CostParameters>(&check.own)) parameters->after = "nowhere";
    const UnitResult result = grade(exercise, reference_sources(bench.tools().reference, exercise));
    EXPECT_EQ(result.verdict, Verdict::grader_fault);
    EXPECT_NE(messages(result).find("no table of costs 'nowhere'"), std::string::npos) << messages(result);
}

TEST_F(CountedWork, a_function_that_is_not_counted_is_refused)
{
    for (const char* attribute :
         {"__attribute__((no_sanitize_coverage, noinline))", "[[gnu::no_sanitize_coverage, gnu::noinline]]"}) {
        const UnitResult result = grade_search("", attribute, "", "");
        EXPECT_EQ(result.score, 0);
        EXPECT_EQ(to_string(result.verdict), "forbidden") << result.message;
    }
}

TEST_F(CountedWork, a_counter_of_ones_own_is_refused)
{
    const UnitResult result = grade_search("extern \"C\" void __sanitizer_cov_trace_pc() {}", "", "", "");
    EXPECT_EQ(result.score, 0);
    EXPECT_EQ(to_string(result.verdict), "forbidden") << result.message;
}

TEST_F(CountedWork, the_counters_address_is_refused)
{
    const UnitResult result = grade_search(
        "extern \"C\" void __sanitizer_cov_trace_pc(); void (*volatile counter)() = &__sanitizer_cov_trace_pc;", "", "",
        "");
    EXPECT_EQ(result.score, 0);
    EXPECT_EQ(to_string(result.verdict), "forbidden") << result.message;
    EXPECT_NE(result.message.find("address"), std::string::npos) << result.message;
    const UnitResult named = grade_search("namespace umbral { std::uint64_t blocks_executed() noexcept; }", "",
                                          "(void)umbral::blocks_executed();", "");
    EXPECT_EQ(to_string(named.verdict), "forbidden") << named.message;
}

TEST_F(CountedWork, a_counter_that_is_set_back_is_contradicted_from_outside)
{
    const std::string counter = fmt::format(
        "auto* counter = reinterpret_cast<volatile "
        "std::uint64_t*>(reinterpret_cast<char*>(&umbral::not_implemented_count) + "
        "({}));",
        distance_to_the_counter());
    const UnitResult result =
        grade_search("", "", counter + " const std::uint64_t before = *counter;", "*counter = before + 9;");
    EXPECT_EQ(cost_points(result).first, 0) << messages(result);
    EXPECT_EQ(other_points(result), 8250) << messages(result);
    EXPECT_NE(messages(result).find("work was done that is not counted"), std::string::npos) << messages(result);
}

// What moves in memory counts, whoever moves it: here one insertion before all others for each corner.
TEST_F(CountedWork, bytes_that_are_moved_count)
{
    const UnitResult result = grade_search(
        "#include <array>\n#include <map>\n"
        "static std::vector<std::uint64_t> table;\n"
        "static std::map<std::array<float, 3>, std::uint32_t> known;",
        "",
        "if (positions.empty()) table.clear(), known.clear();\n"
        "table.insert(table.begin(), 1);\n"
        "if (corner == corner) { const auto [place, added] = known.try_emplace("
        "std::array<float, 3>{corner.x + 0.0F, corner.y + 0.0F, corner.z + 0.0F}, positions.size());\n"
        "if (added) positions.push_back(corner); return place->second; }\n"
        "positions.push_back(corner); return static_cast<std::uint32_t>(positions.size()) - 1;",
        "");
    EXPECT_EQ(cost_points(result).first, 0) << messages(result);
    EXPECT_EQ(other_points(result), 8250) << messages(result);
    EXPECT_NE(messages(result).find("your work grows"), std::string::npos) << messages(result);
}

TEST_F(CountedWork, ways_around_the_counted_calls_are_refused)
{
    const UnitResult real = grade_search("extern \"C\" void* __real_memmove(void*, const void*, std::size_t);", "",
                                         "glm::vec3 copy; __real_memmove(&copy, &corner, sizeof copy);", "");
    EXPECT_EQ(to_string(real.verdict), "forbidden") << real.message;
    EXPECT_NE(real.message.find("memmove"), std::string::npos) << real.message;
    const UnitResult own = grade_search(
        "extern \"C\" void* __wrap_memmove(void* to, const void*, std::size_t) { return to; }", "", "", "");
    EXPECT_EQ(to_string(own.verdict), "forbidden") << own.message;
    EXPECT_NE(own.message.find("__wrap_"), std::string::npos) << own.message;
}

// Searching backwards through a string is a loop within the C++ library.
TEST_F(CountedWork, work_left_to_a_library_is_seen_from_outside)
{
    const UnitResult result = grade_search(
        "static std::string table;", "",
        "if (positions.empty()) table.clear();\n"
        "table.append(1, 'a'); if (table.rfind('b') != std::string::npos) return 0;\n"
        "static std::unordered_map<std::string, std::uint32_t> known; if (positions.empty()) known.clear();\n"
        "const glm::vec3 plain = corner + 0.0F;\n"
        "if (corner == corner) { const auto [place, added] = known.try_emplace("
        "std::string(reinterpret_cast<const char*>(&plain), sizeof plain), positions.size());\n"
        "if (added) positions.push_back(corner); return place->second; }\n"
        "positions.push_back(corner); return static_cast<std::uint32_t>(positions.size()) - 1;",
        "");
    EXPECT_EQ(cost_points(result).first, 0) << messages(result);
    EXPECT_EQ(other_points(result), 8250) << messages(result);
}

TEST_F(CountedWork, work_in_static_initialisers_is_seen_from_outside)
{
    Sources sources = reference_sources(bench.tools().reference, bench.exercise("meshes/weld"));
    sources.begin()->second +=
        "namespace { const bool prepared = [] { volatile int n = 0; for (int i = 0; i < 100'000'000; ++i) n = i; "
        "return n == 0; }(); }\n";
    const UnitResult result = grade(bench.exercise("meshes/weld"), sources);
    EXPECT_EQ(cost_points(result).first, 0) << messages(result);
    EXPECT_EQ(other_points(result), 8250) << messages(result);
    EXPECT_NE(messages(result).find("before anything is counted"), std::string::npos) << messages(result);
}

TEST_F(CountedWork, honest_work_is_believed_under_load)
{
    const Load load(3);
    std::vector<std::string> units;
    for (const auto& exercise : load_units(bench.tools().exercises).exercises)
        if (exercise.counts_work) units.push_back(exercise.id);
    EXPECT_GE(units.size(), 10U);
    // All of them take minutes: `./umbral test --all`.
    if (std::getenv("UMBRAL_TEST_ALL") == nullptr) units.resize(2);
    for (const std::string& id : units) {
        Exercise exercise = bench.exercise(id);
        std::erase_if(exercise.checks, [](const Check& check) { return check.judge != JudgeKind{"cost"}; });
        std::vector<KnownSolution> honest = alternatives_of(bench.tools().reference, exercise);
        honest.emplace_back().sources = reference_sources(bench.tools().reference, exercise);
        for (const KnownSolution& one : honest) {
            const UnitResult result = grade(exercise, one.sources);
            EXPECT_EQ(cost_points(result).first, cost_points(result).second)
                << id << " " << one.name << ": " << messages(result);
        }
    }
}

// The work is as it should be, and what it led to is wrong: what the answers amount to says by which mistake.
TEST_F(CountedWork, a_cost_lost_for_wrong_answers_is_explained_by_them)
{
    const Exercise normals = bench.exercise("meshes/vertex-normals");
    const auto known = mistakes_of(bench.tools().reference, normals);
    const auto inwards = std::ranges::find(known, "inwards", &KnownSolution::name);
    ASSERT_NE(inwards, known.end());
    const UnitResult result = grade_mistake(worker, normals, *inwards, {});
    const auto cost = std::ranges::find(result.checks, JudgeKind{"cost"}, &CheckResult::kind);
    ASSERT_NE(cost, result.checks.end());
    EXPECT_EQ(cost->score, 0) << cost->message;
    ASSERT_FALSE(result.explanations.empty());
    EXPECT_EQ(result.explanations.front().name, "mistake: inwards");
    EXPECT_GT(result.explanations.front().confidence, 0.9) << "nothing is left that it does not explain";
}

}
