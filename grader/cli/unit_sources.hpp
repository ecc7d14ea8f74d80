#pragma once

#include <filesystem>

#include "cli/checkout.hpp"

namespace umbral::grader {

// When what units are built from was changed last. Statements, pictures and alternatives are not built. Folders that
// are not there have no files; the earliest time there is if there are none.

/// Of what all units are built from: the kit, all references, and the framework.
[[nodiscard]] std::filesystem::file_time_type last_shared_change(const Toolchain& tools);

/// Of the sources and the manifest in a unit's folder, mistakes only with UnitParts::all, and of what units of its
/// topic share.
[[nodiscard]] std::filesystem::file_time_type last_own_change(const Exercise& unit, UnitParts parts);

}
