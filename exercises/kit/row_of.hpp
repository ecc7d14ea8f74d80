#pragma once

#include <cstddef>
#include <optional>

namespace umbral {

/// The row of a student's table at this place; where the table is too short, nothing, which reports call so.
template <class Table>
[[nodiscard]] std::optional<typename Table::value_type> row_of(const Table& table, std::size_t place)
{
    return place < table.size() ? std::optional(table[place]) : std::nullopt;
}

}
