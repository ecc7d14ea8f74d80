#include "question/number_changes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

// What numbers are beside the right ones.
namespace umbral::grader::test {
namespace {

// Sums of rounded terms are not the rounded sum.
TEST(NumberChanges, find_that_all_are_multiples_of_what_right_ones_are_not)
{
    const auto said_of = [](double step) {
        std::vector<double> yours;
        std::vector<double> right;
        for (int i = 1; i < 30; ++i) {
            right.push_back(0.73912 * i + 0.01 * i * i);
            yours.push_back(step * (std::floor(right.back() / step) + i % 3));
        }
        const auto found = change_of_numbers(yours, right);
        return found ? found->words : "";
    };
    EXPECT_EQ(said_of(0.01), "a multiple of 0.01, as the right one is not");
    EXPECT_EQ(said_of(1.0 / 255), "a multiple of 1/255, as the right one is not");
    EXPECT_EQ(said_of(0.0123), "");
}

}
}
