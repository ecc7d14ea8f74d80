#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "collect/submitted_files.hpp"
#include "model/time_budget.hpp"

namespace umbral::grader {

/// Where the pieces of a built Umbral lie, and how students' files are compiled.
struct Toolchain {
    std::filesystem::path exercises;       ///< the folder of units' sources
    std::filesystem::path reference;       ///< the folder of the reference's sources (for GLSL units and listing only)
    std::filesystem::path units;           ///< the folder of built drivers and solutions
    std::filesystem::path programs;        ///< umbral-spawner, umbral-confine, umbral-inspect …
    std::filesystem::path framework;       ///< include folder
    std::filesystem::path student_header;  ///< force-included, with its precompiled form beside it
    std::filesystem::path cache;           ///< built submissions, by content
    std::string compiler;
    std::vector<std::string> flags;
    std::uintmax_t cache_bytes = std::uintmax_t{1}
                                 << 30U;  ///< beyond which builds that were not used for long are dropped
    double compile_seconds = 30;          ///< of processor time of each of its processes; then the compiler is stopped
    std::shared_ptr<UnitBudget>
        budget{};  ///< of what it compiles, beyond which it is stopped too; null: no other bound
};

/// What opens archives in a submission.
[[nodiscard]] inline ArchiveTools archive_tools(const Toolchain& tools)
{
    return {tools.programs, tools.cache / "unpacked"};
}

/// The folder in `units` of a unit's built libraries.
[[nodiscard]] inline std::filesystem::path unit_folder(const Toolchain& tools, const std::string& id)
{
    return tools.units / id;
}

}
