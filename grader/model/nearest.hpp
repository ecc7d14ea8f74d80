#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// How many letters must be inserted, left out, replaced, or swapped with their neighbour to make `a` of `b`, no matter
/// their case (the optimal string alignment distance). Costs the product of the lengths.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// Those of `known` that somebody who typed `word` may have meant, at most `most`: names with up to a third of the
/// letters mistyped, the nearest first; if there are none, names that hold the word, of three letters at least. None if
/// it is longer than 64 bytes.
[[nodiscard]] std::vector<std::string> nearest(std::string_view word, std::span<const std::string> known,
                                               std::size_t most = 3);

/// "; did you mean `a`, `b` or `c`?", or ";" if there are none: a sentence goes on behind it.
[[nodiscard]] std::string did_you_mean(std::span<const std::string> names);

}
