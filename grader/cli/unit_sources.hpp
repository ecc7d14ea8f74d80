#pragma once

#include <filesystem>

#include "cli/checkout.hpp"

namespace umbral::grader {

/// When what a unit is built from was changed last: the sources and manifest in its folder, what units of its topic
/// share, the kit, all references, and the framework. Statements, pictures and alternatives are not built; mistakes
/// only with UnitParts::all. Folders that are not there have no files. The earliest time there is if there are none.
[[nodiscard]] std::filesystem::file_time_type last_change(const Toolchain& tools, const Exercise& unit,
                                                          UnitParts parts);

}
