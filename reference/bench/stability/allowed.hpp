#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace stability {

/// The question, made one that the function's header allows: its vectors normalised, say, where it wants units. Nothing
/// where that cannot be done, and the question unchanged where the header asks nothing that could be broken, or where
/// the function throws.
[[nodiscard]] std::optional<std::vector<float>> allowed(std::string_view function, std::vector<float> question);

}
