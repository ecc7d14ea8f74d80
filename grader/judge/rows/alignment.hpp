#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace umbral::grader {

/// Which elements of two sequences belong together, in the order of both.
struct Alignment {
    std::vector<std::pair<std::size_t, std::size_t>> matches;  ///< positions in a and in b, both increasing
    bool best = true;  ///< no alignment has more matches; false where the search was cut short
};

/// A longest common subsequence of two sequences of these sizes; `same(i, j)` compares element i of a with j of b.
///
/// Takes time in proportion to the size times the number of differences. Where that is more than a few seconds' work,
/// pieces are aligned one after the other: then there may be fewer matches than possible, never wrong ones. Based on:
/// Eugene W. Myers. An O(ND) difference algorithm and its variations. 1986.
[[nodiscard]] Alignment align(std::size_t size_a, std::size_t size_b,
                              const std::function<bool(std::size_t, std::size_t)>& same);

}
