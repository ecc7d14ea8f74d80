#include "judge/sureness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/thresholds.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {

constexpr double much = 1000;

TEST(Sureness, IsTheShareOfTheChecksThatSpeakForIt)
{
    EXPECT_EQ(sureness({}), 0);
    EXPECT_EQ(sureness({0, 3, much}), 0);
    EXPECT_NEAR(sureness({3, 0, much}), 1, 1e-12);
    EXPECT_NEAR(sureness({1, 4, much}), 0.2, 1e-12) << "a mistake that breaks five checks, of which the student fails one";
}

TEST(Sureness, IsLessWhereTheAgreementSaysLittle)
{
    EXPECT_EQ(sureness({3, 0, 0}), 0);
    EXPECT_LT(sureness({1, 0, 1}), thresholds::least_sure) << "one wrong boolean says too little";
    double before = 0;
    for (double bits = 1; bits < 60; bits += 1) {
        EXPECT_GT(sureness({1, 0, bits}), before);
        before = sureness({1, 0, bits});
    }
}

TEST(Sureness, TheBestStillPossibleIsABound)
{
    for (std::size_t yes = 0; yes < 5; ++yes)
        for (std::size_t no = 0; no < 5; ++no)
            for (std::size_t undecided = 0; undecided < 5; ++undecided) {
                const Testimony now{yes, no, 10};
                for (std::size_t more = 0; more <= undecided; ++more) {
                    const Testimony later{yes + more, no + undecided - more, 10 + 50.0 * static_cast<double>(more)};
                    EXPECT_GE(most_sureness(now, undecided), sureness(later)) << yes << ' ' << no << ' ' << undecided << ' ' << more;
                }
            }
}

TEST(Sureness, OfAPatternCountsTheWaysToChooseIt)
{
    EXPECT_NEAR(pattern_bits(8, 1), 3, 1e-9);
    EXPECT_NEAR(pattern_bits(6, 3), std::log2(20), 1e-9);
    EXPECT_EQ(pattern_bits(100, 100), 0) << "all are wrong: no pattern";
    EXPECT_EQ(pattern_bits(100, 0), 0);
    EXPECT_EQ(pattern_bits(100000, 500), thresholds::most_pattern_bits);
}

TEST(Sureness, TheBackgroundOfAGridIsNoPlace)
{
    const Tensor blank = grid(10, 10, std::vector<std::uint32_t>(100, 0));
    std::vector<std::uint32_t> ids(100, 0);
    for (std::size_t i = 40; i < 44; ++i) ids[i] = 7;
    const Tensor shape = grid(10, 10, ids);
    std::vector<bool> lost(100, false);
    for (std::size_t i = 40; i < 44; ++i) lost[i] = true;
    // Everything is lost that there was: four of a hundred cells make no pattern.
    EXPECT_NEAR(agreement_bits(blank, shape, std::vector<bool>(100, true), lost), 1, 1e-12);
}

Explanation said(const std::string& name, double confidence) { return {name, "A sentence.", confidence}; }

std::vector<std::string> names(const std::vector<Explanation>& list)
{
    std::vector<std::string> result;
    for (const Explanation& one : list) result.push_back(one.name + (one.ambiguous ? " or" : ""));
    return result;
}

using Names = std::vector<std::string>;

TEST(Ranked, BestFirstAndNothingBelowTheFloor)
{
    EXPECT_EQ(names(ranked({said("a", 0.7), said("mistake: b", 0.95), said("c", thresholds::least_sure - 0.01)})), (Names{"mistake: b", "a"}));
    EXPECT_TRUE(ranked({said("a", 0.3)}).empty());
    EXPECT_TRUE(ranked({}).empty());
    EXPECT_EQ(ranked(std::vector<Explanation>(9, said("a", 1))).size(), thresholds::most_explanations);
}

TEST(Ranked, AKnownMistakeStandsBeforeATransformThatMatchesAsWell)
{
    EXPECT_EQ(names(ranked({said("negated", 0.995), said("mistake: sign", 0.99)})), (Names{"mistake: sign", "negated"}))
        << "the hint was written for the unit, and both are true";
    EXPECT_EQ(names(ranked({said("negated", 0.995), said("mistake: sign", 0.9)})), (Names{"negated", "mistake: sign"}));
}

TEST(Ranked, TwoOfAKindThatMatchEquallyWellAreAmbiguous)
{
    EXPECT_EQ(names(ranked({said("mistake: a", 0.99), said("mistake: b", 0.985), said("mistake: c", 0.9)})),
              (Names{"mistake: a or", "mistake: b or", "mistake: c"}));
    EXPECT_EQ(names(ranked({said("transposed", 0.99), said("inverse", 0.99)})), (Names{"transposed or", "inverse or"}));
    EXPECT_EQ(names(ranked({said("transposed", 0.99), said("mistake: a", 0.99), said("mistake: b", 0.99)})),
              (Names{"mistake: a or", "mistake: b or", "transposed"}));
}

}
}
