#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace umbral::grader {

/// These headers of the framework, and all that they include of it, as "umbral/core/ray.hpp"; `framework` is the folder
/// that they lie in. One that is not there is left out. Throws std::runtime_error if one cannot be read.
[[nodiscard]] std::set<std::string> with_included(const std::filesystem::path& framework,
                                                  std::vector<std::string> headers);

}
