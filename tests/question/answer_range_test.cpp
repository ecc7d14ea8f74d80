#include "question/answer_range.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>

#include "question/first_pattern.hpp"

namespace umbral::grader::test {
namespace {

/// Right answers from -6 to 6, and wrong ones made of them.
template <class Wrong>
AnswerTable around_zero(Wrong wrong)
{
    AnswerTable made{1, 0, {}, {}, {}};
    for (int i = 0; i <= 24; ++i) {
        const double right = 0.5 * i - 6;
        const double yours = wrong(right);
        made.answers.push_back({{yours}, {right}, yours != right});
    }
    return made;
}

/// Empty if there is none.
std::string range_words(const AnswerTable& table)
{
    std::vector<const AnswerPair*> wrong;
    for (const AnswerPair& one : table.answers)
        if (one.wrong) wrong.push_back(&one);
    const auto range = range_of_answers(table, wrong, {0});
    return range ? range->words : "";
}

TEST(AnswerRange, says_that_right_answers_are_cut)
{
    EXPECT_EQ(first_pattern(around_zero([](double x) { return std::clamp(x, 0.0, 1.0); })),
              "is the right one cut to 0 to 1");
    EXPECT_EQ(first_pattern(around_zero([](double x) { return std::max(x, 0.0); })),
              "is 0 where the right one is less");
    EXPECT_EQ(first_pattern(around_zero([](double x) { return std::min(x, 1.0); })),
              "is 1 where the right one is more");
}

TEST(AnswerRange, says_what_answers_never_pass)
{
    const auto of_cut = [](double x) { return x < -5 ? 0 : 0.5 + 0.5 * std::sin(2 * x); };
    EXPECT_EQ(range_words(around_zero(of_cut)), "is never below 0, though right ones are") << "none lies at 1";
    EXPECT_EQ(range_words(around_zero([&](double x) { return x > 5 ? 1 : of_cut(x); })),
              "is never below 0 or above 1, though right ones are");
    EXPECT_EQ(range_words(around_zero([](double x) { return std::abs(x); })),
              "is never below 0, though right ones are");
}

TEST(AnswerRange, says_nothing_of_constants_and_of_ends_by_chance)
{
    EXPECT_EQ(first_pattern(around_zero([](double) { return 0; })), "is 0");
    EXPECT_EQ(range_words(around_zero([](double x) { return x + 1; })), "");
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const double low = random.uniform(-3, 0);
        const double high = random.uniform(1, 4);
        const auto any = [&](double) {
            return double{random.uniform(static_cast<float>(low), static_cast<float>(high))};
        };
        EXPECT_EQ(range_words(around_zero(any)), "");
    }
}

}
}
