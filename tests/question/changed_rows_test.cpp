#include "question/changed_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <umbral/core/random.hpp>

// Rows that came and should not, as those that are missing with a number changed.
namespace umbral::grader {
namespace {

/// Triangles of a grid: a code, and three corners, the least in front.
NumberRows triangles(int columns, int rows)
{
    NumberRows all;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double a = y * (columns + 1) + x;
            const double c = a + columns + 1;
            all.push_back({1, a, a + 1, c + 1});
            all.push_back({1, a, c + 1, c});
        }
    return all;
}

TEST(ChangedRows, tell_of_triangles_that_are_turned_over)
{
    const NumberRows right = triangles(4, 3);
    NumberRows yours = right;
    for (std::size_t i = 16; i < yours.size(); ++i) std::swap(yours[i][2], yours[i][3]);
    std::ranges::reverse(yours);
    const auto found = changed_rows(yours, right, 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, (ChangedRows{ChangedRows::How::exchanged, 2, 3, 8, 8}));
}

TEST(ChangedRows, tell_of_a_sign)
{
    Random random(7);
    NumberRows right;
    for (int i = 0; i < 30; ++i) right.push_back({random.uniform(-1.0F, 1.0F), random.uniform(1.0F, 2.0F)});
    NumberRows yours = right;
    for (std::size_t i = 0; i < 10; ++i) yours[i][1] = -yours[i][1] * (1 + 1e-8);
    const auto found = changed_rows(yours, right, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, (ChangedRows{ChangedRows::How::negated, 1, 1, 10, 10}));
}

TEST(ChangedRows, say_nothing_of_rows_that_are_wrong_otherwise_or_few)
{
    const NumberRows right = triangles(4, 3);
    NumberRows yours = right;
    for (std::size_t i = 0; i < yours.size(); ++i) yours[i][1] += 100;
    EXPECT_FALSE(changed_rows(yours, right, 1));
    yours = right;
    std::swap(yours[3][2], yours[3][3]);
    EXPECT_FALSE(changed_rows(yours, right, 1));
    EXPECT_FALSE(changed_rows(right, right, 1));
}

TEST(ChangedRows, count_rows_as_often_as_they_stand)
{
    const auto [too_many, missing] = unpaired({{1, 2}, {1, 2}, {3, 4}}, {{1, 2}, {3, 4}, {5, 6}});
    EXPECT_EQ(too_many, (NumberRows{{1, 2}}));
    EXPECT_EQ(missing, (NumberRows{{5, 6}}));
}

}
}
