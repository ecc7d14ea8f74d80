#include <gtest/gtest.h>

#include <cmath>

#include "build/with_zeros.hpp"
#include "model/caps.hpp"
#include "model/time_budget.hpp"
#include "support/workbench.hpp"

// Compiling a submission is bounded over all of its units, and no unit takes another one's own share.
namespace umbral::grader::test {
namespace {

/// A file that takes a compiler any time, in a namespace of its own.
std::string endless(int number)
{
    return "namespace n" + std::to_string(number) +
           " {\ntemplate <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};\n"
           "template <int I> struct B<0, I> {};\nB<24, 0> all;\n}\n";
}

class Budget : public testing::Test {
protected:
    /// The next unit of the submission.
    [[nodiscard]] Toolchain next_unit() const
    {
        Toolchain tools = bench.tools();
        tools.budget = std::make_shared<UnitBudget>(submission);
        return tools;
    }
    [[nodiscard]] Built built(const Toolchain& tools, const Sources& files) const
    {
        return build(tools, bench.exercise("raytracing/sphere"), files);
    }

    Workbench bench;
    std::string text = sphere_with("", "");
    std::shared_ptr<TimeBudget> submission = budgets_of_a_submission().compiling;
};

TEST_F(Budget, a_unit_takes_of_its_own_first)
{
    UnitBudget unit(submission);
    unit.take(caps::compile_seconds - 1);
    EXPECT_DOUBLE_EQ(submission->left(), caps::shared_compile_seconds);
    unit.take(3);
    EXPECT_DOUBLE_EQ(submission->left(), caps::shared_compile_seconds - 2);
    EXPECT_DOUBLE_EQ(unit.left(), submission->left());
    EXPECT_DOUBLE_EQ(UnitBudget(submission).left(), caps::compile_seconds + submission->left());
    unit.take(1e9);
    EXPECT_DOUBLE_EQ(unit.left(), 0);
    EXPECT_DOUBLE_EQ(UnitBudget(submission).left(), caps::compile_seconds);
    EXPECT_TRUE(std::isinf(UnitBudget().left()));
}

TEST_F(Budget, what_is_used_up_is_told_and_never_the_tools_fault)
{
    submission->take(caps::shared_compile_seconds - 1);
    const Toolchain tools = next_unit();
    tools.budget->take(caps::compile_seconds);
    const Built stopped = built(tools, {{"sphere.cpp", text + endless(0)}});
    EXPECT_EQ(to_string(stopped.verdict), "compile_error");
    EXPECT_NE(stopped.message.find("not compiled since"), std::string::npos) << stopped.message;
    EXPECT_FALSE(stopped.repeatable) << "another submission may hold the same files";
    EXPECT_LT(submission->left(), 0.1);

    Toolchain unreachable = tools;
    unreachable.programs = "/nowhere";
    const Built not_begun = built(unreachable, {{"sphere.cpp", text + "// another\n"}});
    EXPECT_EQ(to_string(not_begun.verdict), "compile_error");
    EXPECT_EQ(not_begun.message, stopped.message);

    EXPECT_EQ(to_string(built(next_unit(), {{"sphere.cpp", text}}).verdict), "ok") << "by what is its own";
}

TEST_F(Budget, holds_over_all_files_of_a_unit)
{
    submission->take(caps::shared_compile_seconds);
    Sources files{{"sphere.cpp", text}};
    for (int i = 0; i < 8; ++i) files["part" + std::to_string(i) + ".cpp"] = endless(i);
    const Toolchain tools = next_unit();
    const Built stopped = built(tools, files);
    EXPECT_NE(stopped.message.find("not compiled since"), std::string::npos) << stopped.message;
    EXPECT_LT(tools.budget->taken(), caps::compile_seconds + 2);
}

TEST_F(Budget, what_lies_in_the_cache_takes_what_it_took)
{
    const Toolchain first = next_unit();
    (void)built(first, {{"sphere.cpp", text}});
    EXPECT_GT(first.budget->taken(), 0.02);
    const Toolchain second = next_unit();
    (void)built(second, {{"sphere.cpp", text}});
    EXPECT_DOUBLE_EQ(second.budget->taken(), first.budget->taken());
}

TEST_F(Budget, a_build_with_zeros_is_counted_too)
{
    const Toolchain tools = next_unit();
    const Built once = built(tools, {{"sphere.cpp", text}});
    const double before = tools.budget->taken();
    ASSERT_TRUE(build_with_zeros(bench.tools(), bench.exercise("raytracing/sphere"), once));
    EXPECT_GT(tools.budget->taken(), before);
}

}
}
