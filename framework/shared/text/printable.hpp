#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace umbral {

/// Text from a student's process made fit to print and store: invalid UTF-8, control characters but \n and \t and what
/// is_deceptive() are replaced, and so are more than four marks on one letter; what exceeds `limit` bytes is cut,
/// saying so.
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit);

}
