#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "judge/rows/alignment.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {

/// An event that came, and one that did not, by their places in the two sequences.
struct EventPair {
    std::size_t yours = 0;
    std::size_t expected = 0;
};

/// Where two sequences part: the first event that stands on one side only, and the one beside it if there is one.
struct FirstApart {
    std::optional<std::size_t> yours{};
    std::optional<std::size_t> expected{};
};

/// The event that was probably meant: of the other side, of the same kind as the first one that stands alone, and
/// nowhere on the first one's side. One with the same numbers in another order (a triangle turned over) is preferred to
/// what stands beside it; where nothing stands beside it, the one with most numbers equal, and the nearest of these.
/// Nothing where no such event is better than what stands beside it, or where hundreds stand alone.
[[nodiscard]] std::optional<EventPair> meant_pair(
    const TensorView& yours, const TensorView& expected, const Alignment& alignment, const FirstApart& first,
    const std::function<bool(std::span<const double>, std::span<const double>)>& same);

}
