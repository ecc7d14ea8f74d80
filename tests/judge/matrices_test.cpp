#include <gtest/gtest.h>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

std::vector<float> identity() { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }

TEST(Matrices, the_first_difference_is_an_entry_by_row_and_column)
{
    std::vector<float> many;
    for (int i = 0; i < 5; ++i)
        for (const float v : identity()) many.push_back(v);
    std::vector<float> wrong = many;
    wrong[3 * 16 + 12] = 5;  // column 3, row 0 of matrix 3
    const Judgement found =
        judge(check_of(JudgeKind{"matrices"}, absolute(1e-6)), floats(wrong, 16), floats(many, 16), nullptr);
    EXPECT_DOUBLE_EQ(found.right, 0.8);
    EXPECT_EQ(found.first_difference->where, "matrix 3, entry (row 0, column 3)");
    EXPECT_EQ(found.first_difference->yours, "5 in [1 0 0 5; 0 1 0 0; 0 0 1 0; 0 0 0 1]");
    EXPECT_EQ(found.first_difference->expected, "0 in [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]");
    EXPECT_EQ(found.error, 5);
}

// A cosine of 90 degrees in double is 6e-17: beside a 1 that is no number to wonder about.
TEST(Matrices, what_rounding_left_of_0_is_shown_as_0)
{
    std::vector<double> expected(16, 0.0);
    for (const std::size_t i : {1U, 4U, 10U, 15U}) expected[i] = 1;
    expected[0] = expected[5] = 6.123e-17;
    std::vector<double> yours = expected;
    yours[4] = -1;
    const Judgement found =
        judge(check_of(JudgeKind{"matrices"}, absolute(1e-6)), doubles(yours, 16), doubles(expected, 16), nullptr);
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->expected, "1 in [0 1 0 0; 1 0 0 0; 0 0 1 0; 0 0 0 1]");
    // Unless that is the difference.
    expected = std::vector<double>(16, 1.0);
    expected[0] = 0;
    yours = expected;
    yours[0] = 3e-10;
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, absolute(1e-12)), doubles(yours, 16), doubles(expected, 16), nullptr)
            .first_difference->yours.substr(0, 8),
        "3e-10 in");
}

// The 1 of an affine matrix is no rounding, however far it moves things.
TEST(Matrices, a_whole_number_beside_huge_ones_is_shown)
{
    std::vector<double> expected(16, 0);
    expected[0] = expected[5] = expected[10] = expected[15] = 1;
    expected[12] = 1e13;
    std::vector<double> yours = expected;
    yours[12] = 2e13;
    const Judgement found =
        judge(check_of(JudgeKind{"matrices"}, absolute(1)), doubles(yours, 16), doubles(expected, 16), nullptr);
    EXPECT_EQ(found.first_difference->expected, "1e+13 in [1 0 0 1e+13; 0 1 0 0; 0 0 1 0; 0 0 0 1]");
}

TEST(Matrices, a_huge_translation_does_not_excuse_the_rotation)
{
    std::vector<float> expected = identity();
    expected[12] = 1e6F;
    std::vector<float> off = expected;
    off[0] = 1.01F;
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, relative(1e-5)), floats(off, 16), floats(expected, 16), nullptr).right,
        0);
    off = expected;
    off[13] = 1;  // beside a million, one is 1e-6
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, relative(1e-5)), floats(off, 16), floats(expected, 16), nullptr).right,
        1);
}

TEST(Matrices, zero_by_cancellation_may_keep_its_neighbours_rounding)
{
    std::vector<float> off = identity();
    off[1] = 1e-7F;
    EXPECT_EQ(judge(check_of(JudgeKind{"matrices"}, ulps(2)), floats(off, 16), floats(identity(), 16), nullptr).right,
              1);
    off[1] = 1e-6F;
    EXPECT_EQ(judge(check_of(JudgeKind{"matrices"}, ulps(2)), floats(off, 16), floats(identity(), 16), nullptr).right,
              0);
}

TEST(Matrices, a_column_of_zeros_counts_against_the_whole_matrix)
{
    const std::vector<float> expected{2, 0, 0, 0, 2, 0, 0, 0, 0};
    std::vector<float> off = expected;
    off[8] = 1e-6F;
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, relative(1e-6)), floats(off, 9), floats(expected, 9), nullptr).right, 1);
    off[8] = 1e-5F;
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, relative(1e-6)), floats(off, 9), floats(expected, 9), nullptr).right, 0);
}

TEST(Matrices, every_entry_matters)
{
    for (std::size_t i = 0; i < 16; ++i) {
        std::vector<float> off = identity();
        off[i] += 0.1F;
        EXPECT_EQ(
            judge(check_of(JudgeKind{"matrices"}, absolute(1e-3)), floats(off, 16), floats(identity(), 16), nullptr)
                .right,
            0)
            << i;
        off[i] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_EQ(
            judge(check_of(JudgeKind{"matrices"}, absolute(1e-3)), floats(off, 16), floats(identity(), 16), nullptr)
                .right,
            0)
            << i;
    }
}

TEST(Matrices, other_sizes_are_a_grader_fault)
{
    EXPECT_THROW((void)judge(check_of(JudgeKind{"matrices"}, absolute(1)), floats({1, 2, 3, 4}, 4),
                             floats({1, 2, 3, 4}, 4), nullptr),
                 std::invalid_argument);
}

TEST(Matrices, three_by_three_ones_are_read_by_three)
{
    const std::vector<float> expected{1, 0, 0, 0, 2, 0, 5, 0, 3};
    std::vector<float> off = expected;
    off[7] = 4;
    const Judgement found =
        judge(check_of(JudgeKind{"matrices"}, absolute(1e-3)), floats(off, 9), floats(expected, 9), nullptr);
    EXPECT_EQ(found.first_difference->where, "matrix 0, entry (row 1, column 2)");
    EXPECT_EQ(found.first_difference->yours, "4 in [1 0 5; 0 2 4; 0 0 3]");
}

TEST(Matrices, negative_entries_are_as_large_as_positive_ones)
{
    std::vector<float> expected = identity();
    expected[5] = -2;
    std::vector<float> off = expected;
    off[4] = 1e-3F;
    EXPECT_EQ(
        judge(check_of(JudgeKind{"matrices"}, relative(1e-3)), floats(off, 16), floats(expected, 16), nullptr).right,
        1);
}

TEST(Matrices, margins_and_absence_are_those_of_their_rows)
{
    std::vector<float> two = identity();
    for (const float v : identity()) two.push_back(v);
    std::vector<float> off = two;
    off[16] = 9;
    const Tensor margin = floats({5, 1});
    EXPECT_EQ(judge(check_of(JudgeKind{"matrices"}, Tolerance{{}, {}, 1, 2}), floats(off, 16), floats(two, 16), &margin)
                  .right,
              1);
    Tensor absent = floats(std::vector<float>(16, 0.0F), 16);
    absent.present = {0};
    Tensor expected = floats(identity(), 16);
    expected.present = {1};
    EXPECT_EQ(judge(check_of(JudgeKind{"matrices"}, ulps(1)), absent, expected, nullptr).first_difference->yours,
              "nothing");
}

}
}
