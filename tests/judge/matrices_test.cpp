#include <gtest/gtest.h>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

std::vector<float> identity() { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }

TEST(Matrices, TheFirstDifferenceIsAnEntryByRowAndColumn)
{
    std::vector<float> many;
    for (int i = 0; i < 5; ++i)
        for (const float v : identity()) many.push_back(v);
    std::vector<float> wrong = many;
    wrong[3 * 16 + 12] = 5;  // column 3, row 0 of matrix 3
    const Judgement found = judge(check_of(JudgeKind::matrices, absolute(1e-6)), floats(wrong, 16), floats(many, 16), nullptr);
    EXPECT_DOUBLE_EQ(found.right, 0.8);
    EXPECT_EQ(found.first_difference->where, "matrix 3, entry (row 0, column 3)");
    EXPECT_EQ(found.first_difference->yours, "5 in [1 0 0 5; 0 1 0 0; 0 0 1 0; 0 0 0 1]");
    EXPECT_EQ(found.first_difference->expected, "0 in [1 0 0 0; 0 1 0 0; 0 0 1 0; 0 0 0 1]");
    EXPECT_EQ(found.error, 5);
}

TEST(Matrices, AHugeTranslationDoesNotExcuseTheRotation)
{
    std::vector<float> expected = identity();
    expected[12] = 1e6F;
    std::vector<float> off = expected;
    off[0] = 1.01F;
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, relative(1e-5)), floats(off, 16), floats(expected, 16), nullptr).right, 0);
    off = expected;
    off[13] = 1;  // beside a million, one is 1e-6
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, relative(1e-5)), floats(off, 16), floats(expected, 16), nullptr).right, 1);
}

TEST(Matrices, ZeroByCancellationMayKeepItsNeighboursRounding)
{
    std::vector<float> off = identity();
    off[1] = 1e-7F;
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, ulps(2)), floats(off, 16), floats(identity(), 16), nullptr).right, 1);
    off[1] = 1e-6F;
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, ulps(2)), floats(off, 16), floats(identity(), 16), nullptr).right, 0);
}

TEST(Matrices, AColumnOfZerosCountsAgainstTheWholeMatrix)
{
    const std::vector<float> expected{2, 0, 0, 0, 2, 0, 0, 0, 0};
    std::vector<float> off = expected;
    off[8] = 1e-6F;
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, relative(1e-6)), floats(off, 9), floats(expected, 9), nullptr).right, 1);
    off[8] = 1e-5F;
    EXPECT_EQ(judge(check_of(JudgeKind::matrices, relative(1e-6)), floats(off, 9), floats(expected, 9), nullptr).right, 0);
}

TEST(Matrices, EveryEntryMatters)
{
    for (std::size_t i = 0; i < 16; ++i) {
        std::vector<float> off = identity();
        off[i] += 0.1F;
        EXPECT_EQ(judge(check_of(JudgeKind::matrices, absolute(1e-3)), floats(off, 16), floats(identity(), 16), nullptr).right, 0) << i;
        off[i] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_EQ(judge(check_of(JudgeKind::matrices, absolute(1e-3)), floats(off, 16), floats(identity(), 16), nullptr).right, 0) << i;
    }
}

TEST(Matrices, OtherSizesAreAGraderFault)
{
    EXPECT_THROW((void)judge(check_of(JudgeKind::matrices, absolute(1)), floats({1, 2, 3, 4}, 4), floats({1, 2, 3, 4}, 4), nullptr), std::invalid_argument);
}

}
}
