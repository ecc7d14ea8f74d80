#include <gtest/gtest.h>

#include "judge/make.hpp"
#include "validate/column_findings.hpp"

// Which numbers of a row a tolerance excuses altogether.
namespace umbral::grader {
namespace {

using test::floats;
using test::text;

Tolerance absolute(double bound)
{
    Tolerance tolerance;
    tolerance.absolute = bound;
    return tolerance;
}

Tolerance relative(double bound)
{
    Tolerance tolerance;
    tolerance.relative = bound;
    return tolerance;
}

Check numbers(const Tolerance& tolerance)
{
    Check check{};
    check.name = "case/value";
    check.judge = JudgeKind{"numbers"};
    check.tolerance = tolerance;
    return check;
}

std::string complaint(const Tolerance& tolerance, const Tensor& expected, const char* names = nullptr)
{
    const Tensor called = text(names == nullptr ? "" : names);
    return column_complaint(numbers(tolerance), {&expected, nullptr, names == nullptr ? nullptr : &called});
}

// A length in the same row is what a relative error is measured against.
TEST(ColumnFindings, name_what_a_large_neighbour_excuses)
{
    const Tensor expected = floats({1000, 0.004F, 2000, 0.009F}, 2);
    const std::string said = complaint(relative(1e-4), expected, "length, angle");
    EXPECT_TRUE(said.starts_with("'angle' may be 0 in every row, and no row is wrong")) << said;
    EXPECT_EQ(complaint(relative(1e-7), expected), "");
}

TEST(ColumnFindings, name_what_an_absolute_tolerance_excuses)
{
    EXPECT_NE(complaint(absolute(2.25), floats({36, 1, 60, 2}, 2)), "");
    EXPECT_EQ(complaint(absolute(0.25), floats({36, 1, 60, 2}, 2)), "");
}

// What is 0 but for rounding may be anything as small; nor does a column of zeros say anything.
TEST(ColumnFindings, leave_roundings_of_zero_alone)
{
    EXPECT_EQ(complaint(absolute(1e-6), floats({3, 1e-8F, 0, 4, -1e-8F, 0}, 3)), "");
}

// A value far below its column's largest may drown; one row that counts is enough.
TEST(ColumnFindings, look_at_the_rows_that_matter)
{
    EXPECT_EQ(complaint(absolute(0.5), floats({1, 0.25F, 1, 8}, 2)), "");
}

TEST(ColumnFindings, leave_single_columns_to_the_controls)
{
    EXPECT_EQ(complaint(absolute(10), floats({1, 2, 3}, 1)), "");
}

}
}
