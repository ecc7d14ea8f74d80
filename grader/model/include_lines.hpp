#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// What stands between the quotes or brackets of a text's include lines, in their order. Comments and conditions are
/// not looked at.
[[nodiscard]] std::vector<std::string> included_in(std::string_view text);

/// The headers of the framework among them: "umbral/core/ray.hpp".
[[nodiscard]] std::vector<std::string> framework_includes(std::string_view text);

}
