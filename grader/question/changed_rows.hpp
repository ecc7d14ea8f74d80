#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace umbral::grader {

/// Rows of numbers, of equal length.
using NumberRows = std::vector<std::vector<double>>;

/// What makes rows that came and should not those that are missing.
struct ChangedRows {
    enum class How { exchanged, negated };
    How how = How::exchanged;
    std::size_t one = 0;    ///< the number that is changed …
    std::size_t other = 0;  ///< … or exchanged with this one
    std::size_t rows = 0;   ///< so many rows that came are missing ones after it …
    std::size_t all = 0;    ///< … of these

    friend bool operator==(const ChangedRows&, const ChangedRows&) = default;
};

/// The rows of `yours` that are not among `right`, each as often as it stands there too often, and the reverse; equal
/// up to rounding.
[[nodiscard]] std::pair<NumberRows, NumberRows> unpaired(const NumberRows& yours, const NumberRows& right);

/// Two numbers exchanged, or one with the opposite sign, in nearly all rows that came and should not: so they are rows
/// that are missing. `first`: the first number that may be changed; those before say what the row is about. Nothing
/// where there is no such change, or where few rows came.
[[nodiscard]] std::optional<ChangedRows> changed_rows(const NumberRows& yours, const NumberRows& right,
                                                      std::size_t first);

}
