#include "judge/explain/confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/explain/thresholds.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {

constexpr double much = 1000;

TEST(Confidence, is_the_share_of_the_checks_that_speak_for_it)
{
    EXPECT_EQ(confidence({}), 0);
    EXPECT_EQ(confidence({0, 3, much}), 0);
    EXPECT_NEAR(confidence({3, 0, much}), 1, 1e-12);
    EXPECT_NEAR(confidence({1, 4, much}), 0.2, 1e-12)
        << "a mistake that breaks five checks, of which the student fails one";
}

TEST(Confidence, is_less_where_the_agreement_says_little)
{
    EXPECT_EQ(confidence({3, 0, 0}), 0);
    EXPECT_LT(confidence({1, 0, 1}), thresholds::least_sure) << "one wrong boolean says too little";
    double before = 0;
    for (double bits = 1; bits < 60; bits += 1) {
        EXPECT_GT(confidence({1, 0, bits}), before);
        before = confidence({1, 0, bits});
    }
}

TEST(Confidence, the_best_still_possible_is_a_bound)
{
    for (std::size_t yes = 0; yes < 5; ++yes)
        for (std::size_t no = 0; no < 5; ++no)
            for (std::size_t undecided = 0; undecided < 5; ++undecided) {
                const Tally now{yes, no, 10};
                for (std::size_t more = 0; more <= undecided; ++more) {
                    const Tally later{yes + more, no + undecided - more, 10 + 50.0 * static_cast<double>(more)};
                    EXPECT_GE(most_confidence(now, undecided), confidence(later))
                        << yes << ' ' << no << ' ' << undecided << ' ' << more;
                }
            }
}

TEST(Confidence, of_a_pattern_counts_the_ways_to_choose_it)
{
    EXPECT_NEAR(pattern_bits(8, 1), 3, 1e-9);
    EXPECT_NEAR(pattern_bits(6, 3), std::log2(20), 1e-9);
    EXPECT_EQ(pattern_bits(100, 100), 0) << "all are wrong: no pattern";
    EXPECT_EQ(pattern_bits(100, 0), 0);
    EXPECT_EQ(pattern_bits(100000, 500), thresholds::most_pattern_bits);
}

TEST(Confidence, the_background_of_a_grid_is_no_place)
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

TEST(Confidence, checks_add_up)
{
    Tally all;
    for (const Resemblance& one :
         {Resemblance{Says::for_it, 3}, Resemblance{Says::against_it, 0}, Resemblance{}, Resemblance{Says::for_it, 4}})
        all += one;
    EXPECT_EQ(all.for_it, 2U);
    EXPECT_EQ(all.against_it, 1U);
    EXPECT_EQ(all.bits, 7);
    EXPECT_NEAR(fit(all), 2.0 / 3, 1e-12);
}

TEST(Confidence, shared_wrong_values_count_by_what_they_say)
{
    const auto bits = [](const std::vector<float>& yours, const std::vector<float>& expected,
                         const std::vector<bool>& alike, std::uint32_t components = 1) {
        return agreement_bits(floats(yours, components), floats(expected, components),
                              std::vector<bool>(alike.size(), true), alike);
    };
    EXPECT_NEAR(bits({5.5F, 5.5F, 7.25F, 4}, {1, 2, 3, 4}, {true, true, true, false}), 2 * 6 + 2, 1e-9)
        << "two different numbers, one of four patterns";
    EXPECT_NEAR(bits({0, 0, 3, 4}, {1, 2, 3, 4}, {true, true, false, false}), 1 + std::log2(6), 1e-9)
        << "many errors give nothing";
    EXPECT_NEAR(bits({9.5F, 2}, {1, 2}, {true}, 2), 6, 1e-9) << "the right half of a row says nothing";
    std::vector<float> many(40);
    for (std::size_t i = 0; i < many.size(); ++i) many[i] = 2.5F + static_cast<float>(i);
    EXPECT_NEAR(bits(many, std::vector<float>(40, 1), std::vector<bool>(40, true)), thresholds::most_value_bits, 1e-9);
}

Explanation said(const std::string& name, double confidence) { return {name, "A sentence.", confidence}; }

std::vector<std::string> names(const std::vector<Explanation>& list)
{
    std::vector<std::string> result;
    for (const Explanation& one : list) result.push_back(one.name + (one.ambiguous ? " or" : ""));
    return result;
}

using Names = std::vector<std::string>;

TEST(Ranked, best_first_and_nothing_below_the_floor)
{
    EXPECT_EQ(names(ranked({said("a", 0.7), said("mistake: b", 0.95), said("c", thresholds::least_sure - 0.01)})),
              (Names{"mistake: b", "a"}));
    EXPECT_TRUE(ranked({said("a", 0.3)}).empty());
    EXPECT_TRUE(ranked({}).empty());
    EXPECT_EQ(ranked(std::vector<Explanation>(9, said("a", 1))).size(), thresholds::most_explanations);
}

TEST(Ranked, a_known_mistake_stands_before_a_transform_that_matches_as_well)
{
    EXPECT_EQ(names(ranked({said("negated", 0.995), said("mistake: sign", 0.99)})), (Names{"mistake: sign", "negated"}))
        << "the hint was written for the unit, and both are true";
    EXPECT_EQ(names(ranked({said("negated", 0.995), said("mistake: sign", 0.9)})), (Names{"negated", "mistake: sign"}));
}

TEST(Ranked, two_of_a_kind_that_match_equally_well_are_ambiguous)
{
    EXPECT_EQ(names(ranked({said("mistake: a", 0.99), said("mistake: b", 0.985), said("mistake: c", 0.9)})),
              (Names{"mistake: a or", "mistake: b or", "mistake: c"}));
    EXPECT_EQ(names(ranked({said("transposed", 0.99), said("inverse", 0.99)})), (Names{"transposed or", "inverse or"}));
    EXPECT_EQ(names(ranked({said("transposed", 0.99), said("mistake: a", 0.99), said("mistake: b", 0.99)})),
              (Names{"mistake: a or", "mistake: b or", "transposed"}));
}

}
}
