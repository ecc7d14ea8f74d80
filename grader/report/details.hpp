#pragma once

#include <string>

#include "report/paint.hpp"

namespace umbral::grader {

/// What a student needs to know about one unit that is not all right, as indented lines, the last ending in a line
/// break. Expects a unit of without_hidden_values. `folder` is the workspace that commands name; if it is empty, none.
[[nodiscard]] std::string unit_details(const UnitResult& unit, int width, const Paint& paint,
                                       const std::string& folder = "");

}
