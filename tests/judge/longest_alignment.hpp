#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "judge/rows/alignment.hpp"

namespace umbral::grader::test {

/// The length of a longest common subsequence by the textbook's table.
template <class Sequence>
std::size_t longest(const Sequence& a, const Sequence& b)
{
    std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            table[i + 1][j + 1] = a[i] == b[j] ? table[i][j] + 1 : std::max(table[i][j + 1], table[i + 1][j]);
    return table[a.size()][b.size()];
}

/// Is it one of equal elements, in the order of both, than which there is no longer one?
template <class Sequence>
void expect_longest(const Alignment& found, const Sequence& a, const Sequence& b)
{
    EXPECT_TRUE(found.best);
    EXPECT_EQ(found.matches.size(), longest(a, b));
    for (std::size_t i = 0; i < found.matches.size(); ++i) {
        EXPECT_EQ(a[found.matches[i].first], b[found.matches[i].second]);
        if (i == 0) continue;
        EXPECT_LT(found.matches[i - 1].first, found.matches[i].first);
        EXPECT_LT(found.matches[i - 1].second, found.matches[i].second);
    }
}

}
