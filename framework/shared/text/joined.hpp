#pragma once

#include <span>
#include <string>

namespace umbral {

/// "a", "a and b", "a, b and c"; empty for none.
[[nodiscard]] std::string joined_with_and(std::span<const std::string> words);

}
