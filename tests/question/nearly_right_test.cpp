#include "question/nearly_right.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_pattern.hpp"

namespace umbral::grader::test {
namespace {

// What is lost by float, by constants of few digits or by differences has no simpler pattern.
TEST(NearlyRight, say_of_small_errors_that_digits_are_lost)
{
    const auto lost = [](std::size_t components, double much) {
        return first_pattern(table(components, [much](Row right) {
            for (double& x : right) x += much * x * std::sin(1e3 * x);
            return right;
        }));
    };
    for (const double much : {1e-9, 1e-7, 5e-6, 1e-3})
        for (const std::size_t components : {1U, 3U, 16U})
            EXPECT_EQ(lost(components, much), much == 1e-7  ? right_to_float
                                              : much < 1e-5 ? right_but_for_rounding
                                                            : roughly_right)
                << much << ", " << components << " numbers";
    EXPECT_EQ(lost(3, 0.3), "");
    // Beside a thousand, one is not little where a row holds different things.
    const auto beside = [](Row right) { return Row{1000, 1 + std::sin(right[0]), 5, 5, 5}; };
    AnswerTable mixed{5, 1, {}, {}, {}};
    for (int i = 0; i < 12; ++i) mixed.answers.push_back({beside({0.1 * i}), {1000, 7.0 + i, 5, 5, 5}, true});
    EXPECT_EQ(first_pattern(mixed).find("nearly right"), std::string::npos);
    const auto one = [](Row right) { return Row{right[0], right[1], right[2] + 1e-3 * std::sin(1e3 * right[0])}; };
    EXPECT_EQ(first_pattern(table(3, one)), std::string("differs in z only, and ") + roughly_right);
    // A count that is one too large is no matter of digits.
    AnswerTable counts{1, 0, {}, {}, {}};
    for (int i = 0; i < 12; ++i) {
        const double right = 1000.0 + 7 * i;
        counts.answers.push_back({{right + (i % 3 == 0 ? 1.0 : -2.0)}, {right}, true});
    }
    EXPECT_EQ(first_pattern(counts), "");
}

// Where differences cancel, some answers lose all digits, and some are no numbers.
TEST(NearlyRight, say_that_most_of_them_are_nearly_right)
{
    const auto cancelled = [](int far, double yours) {
        AnswerTable made{1, 0, {}, {}, {}};
        for (int i = 0; i < 24; ++i) {
            const double right = 1.5 + 0.37 * i;
            made.answers.push_back(
                {{i % 24 < far ? yours * (i + 2.0) : right * (1 + 1e-3 * std::sin(i + 1.0))}, {right}, true});
        }
        return made;
    };
    const AnswerPattern mostly{mostly_nearly_right, CommonTells::mostly};
    EXPECT_EQ(answer_patterns(cancelled(5, -0.7)).front(), mostly);
    EXPECT_EQ(answer_patterns(cancelled(5, std::numeric_limits<double>::quiet_NaN())).front(), mostly);
    EXPECT_NE(std::ranges::count(answer_patterns(cancelled(0, 0)), mostly), 0) << "other inputs may all be near";
    EXPECT_EQ(std::ranges::count(answer_patterns(cancelled(12, -0.7)), mostly), 0);
}

}
}
