#include <gtest/gtest.h>

#include "mutants/repair_words.hpp"
#include "mutants/try_case.hpp"
#include "mutants/try_repairs.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

/// Where a sphere.cpp with this change of a right one can be mended.
class TryRepairs : public testing::Test {
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(finder_)) GTEST_SKIP() << "libclang-14-dev is not installed: NOTHING WAS LOCATED";
    }

    /// A right file with this change, whose line is remembered.
    std::string changed(const std::string& right, const std::string& wrong)
    {
        std::string text = project_file("exercises/raytracing/sphere/alternatives/double_precision.cpp");
        const std::size_t at = text.find(right);
        if (at == std::string::npos) throw std::runtime_error("no '" + right + "' in the alternative");
        line_ = 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
        return text.replace(at, right.size(), wrong);
    }

    RepairSearch search(const std::string& right, const std::string& wrong)
    {
        Crew crew(bench_.tools(), 2);
        return try_repairs(crew, exercise_,
                           build_mutants(bench_.tools(), exercise_, MutantFamily::repairs, finder_,
                                         changed(right, wrong), bench_.folder()),
                           {.seconds = 20});
    }

    /// The x of the first random origin in the case "inside" whose ray hits something, as a literal.
    std::string random_origin(unsigned attempt)
    {
        const Built prints =
            bench_.build_sphere("#include <cstdio>\n" +
                                changed("return static_cast<float>(t);",
                                        "return std::printf(\"%a \", double{ray.origin.x}), static_cast<float>(t);"));
        Worker worker(bench_.tools());
        SeedPlan seeds;
        seeds.attempt = attempt;
        const std::string printed = try_case(worker, exercise_, prints, "inside", seeds).run.output;
        const std::size_t begin = printed.find(' ') + 1;  // the first ray is the same with all seeds
        return printed.substr(begin, printed.find(' ', begin) - begin) + "F";
    }

    /// The changes that were found in the line that is wrong.
    [[nodiscard]] std::vector<std::string> there(const RepairSearch& found) const
    {
        std::vector<std::string> changes;
        for (const Repair& one : found.repairs)
            if (one.change.line == line_) changes.push_back(one.change.change);
        return changes;
    }

    Workbench bench_;
    Exercise exercise_ = bench_.exercise("raytracing/sphere");
    std::filesystem::path finder_ = bench_.tools().programs / "umbral-mutate";
    std::size_t line_ = 0;
};

TEST_F(TryRepairs, find_the_line_of_a_sign)
{
    const RepairSearch found = search("- glm::dvec3(sphere.centre)", "+ glm::dvec3(sphere.centre)");
    EXPECT_FALSE(found.wrong.empty());
    ASSERT_EQ(there(found).size(), 1U);
    EXPECT_EQ(found.repairs.front().mends.size(), found.wrong.size());
    EXPECT_GT(found.tried, 50U);
}

TEST_F(TryRepairs, find_a_wrong_field_and_a_wrong_operator)
{
    EXPECT_EQ(there(search("t < ray.t_max", "t < ray.t_min")).size(), 1U);
    EXPECT_EQ(there(search("ray.t_min < t &&", "ray.t_min < t ||")).size(), 1U);
}

TEST_F(TryRepairs, find_nothing_where_nothing_is_wrong_or_no_small_change_helps)
{
    EXPECT_TRUE(search("const double a", "const double a").wrong.empty());
    const RepairSearch missing = search("if (discriminant < 0) return std::nullopt;", "return std::nullopt;");
    EXPECT_FALSE(missing.wrong.empty());
    EXPECT_TRUE(there(missing).empty());
}

// g++ 12 would overwrite the array's first numbers: build/padding_fault.hpp.
TEST_F(TryRepairs, find_nothing_wrong_where_the_compiler_would_fill_the_wrong_place)
{
    const RepairSearch found = search("const double a = dot(d, d);",
                                      "struct Scaled { int kind; double m[16]; bool on; };\n"
                                      "    const double length = dot(d, d);\n"
                                      "    const Scaled scaled{1, {length, length, length}, true};\n"
                                      "    const double a = scaled.on ? scaled.m[0] : scaled.kind;");
    EXPECT_TRUE(found.wrong.empty());
}

// A change that is tried where nothing is wrong would seem to mend it, like any other.
TEST_F(TryRepairs, are_tried_on_the_inputs_that_are_wrong)
{
    const std::string origin = random_origin(1);
    ASSERT_NE(origin, random_origin(0));
    const RepairSearch found = search("return static_cast<float>(t);",
                                      "return ray.origin.x == " + origin + " ? 0.125F : static_cast<float>(t);");
    EXPECT_EQ(found.wrong, std::vector<std::string>{"inside/t"});
    EXPECT_EQ(there(found).size(), 1U);
}

TEST(RepairWords, say_where_to_look_without_the_change)
{
    Mutant change;
    change.kind = "comparison";
    change.change = "a < b → a <= b";
    EXPECT_NE(words_of_repair(change).find("comparison"), std::string::npos);
    EXPECT_EQ(words_of_repair(change).find("<="), std::string::npos);
    change.kind = "none of the kinds";
    EXPECT_EQ(words_of_repair(change), "Look at this.");
}

}
}
