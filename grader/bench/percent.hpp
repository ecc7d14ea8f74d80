#pragma once

#include <cstddef>

namespace umbral::grader {

/// How many of a hundred; 0 of none.
[[nodiscard]] constexpr double percent(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

}
