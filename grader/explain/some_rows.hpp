#pragma once

#include <cstddef>
#include <span>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral::grader {

/// Some rows of a table, as a table.
[[nodiscard]] inline Tensor some_rows(const Tensor& table, const std::vector<std::size_t>& rows)
{
    Tensor some{table.element, static_cast<std::uint32_t>(rows.size()), 1, table.components, {}, {}};
    const std::size_t size = table.components * size_of(table.element);
    for (const std::size_t row : rows) {
        const auto bytes = std::span(table.bytes).subspan(row * size, size);
        some.bytes.insert(some.bytes.end(), bytes.begin(), bytes.end());
        if (!table.present.empty()) some.present.push_back(table.present[row]);
    }
    return some;
}

}
