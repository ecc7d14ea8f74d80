#include "judge/rows/row_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <umbral/core/random.hpp>
#include <vector>

#include "longest_alignment.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {

using Row = std::array<double, 2>;
using Rows = std::vector<Row>;

TensorView view_of(const Rows& rows)
{
    std::vector<double> numbers;
    for (const Row& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
    return TensorView(doubles(numbers, 2));
}

Rows some_rows(Random& random, bool in_order)
{
    Rows rows(random.below(20));
    for (Row& row : rows) row = {double(random.below(2)) - 1, double(random.below(3))};
    if (in_order) std::ranges::sort(rows);
    return rows;
}

TEST(RowRanks, are_equal_where_rows_are_and_in_their_order)
{
    const auto ranks =
        ranks_of_whole_rows(view_of({{3, 1}, {-2, 7}, {3, 0}}), 2, view_of({{3, 1}, {-2, 8}, {-0.0, 0}}));
    ASSERT_TRUE(ranks);
    EXPECT_EQ(ranks->a, (std::vector<std::uint32_t>{3, 0}));
    EXPECT_EQ(ranks->b, (std::vector<std::uint32_t>{3, 1, 2}));
}

TEST(RowRanks, are_of_whole_numbers_only)
{
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double number : {0.5, infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_FALSE(ranks_of_whole_rows(view_of({{1, number}}), 1, view_of({{1, 2}})));
        EXPECT_FALSE(ranks_of_whole_rows(view_of({{1, 2}}), 1, view_of({{1, number}})));
        EXPECT_TRUE(ranks_of_whole_rows(view_of({{1, number}}), 0, view_of({{1, 2}}))) << "that row is left out";
    }
}

TEST(RowRanks, lead_to_a_longest_alignment_in_order_or_not)
{
    Random random(23);
    for (int round = 0; round < 2000; ++round) {
        SCOPED_TRACE(testing::Message() << "seed 23, round " << round);
        const Rows a = some_rows(random, round % 2 == 0);
        const Rows b = some_rows(random, round % 4 < 2);
        const auto ranks = ranks_of_whole_rows(view_of(a), a.size(), view_of(b));
        ASSERT_TRUE(ranks);
        expect_longest(align(*ranks), a, b);
    }
}

// Of half a million rows in order nothing is guessed.
TEST(RowRanks, of_long_tables_in_order_give_the_best)
{
    Rows a;
    Rows b;
    for (int i = 0; i < 200'000; ++i) {
        a.push_back({double(i), 0});
        a.push_back({double(i), 1});
        b.push_back({double(i), i % 2 == 0 ? 1.0 : 2.0});
    }
    const auto ranks = ranks_of_whole_rows(view_of(a), a.size(), view_of(b));
    ASSERT_TRUE(ranks);
    const Alignment found = align(*ranks);
    EXPECT_TRUE(found.best);
    EXPECT_EQ(found.matches.size(), 100'000U);
}

}
}
