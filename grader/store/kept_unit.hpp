#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// A unit's sections of the report's pages, ready to be put into them.
struct UnitSections {
    std::string student;
    std::string instructor;  ///< empty if there is no instructor's edition
};

/// A result as it lies on the disk, so that it need not be asked for again.
struct KeptUnit {
    std::string key;      ///< digest of all that decides the result; empty: it is only shown, and asked for again
    std::string machine;  ///< digest of version and machine (worker/unit_key.hpp)
    UnitResult result;
};

/// Writes it to `file`, whole or not at all, and flushed to the disk. Throws std::runtime_error with path and reason.
void keep_unit(const std::filesystem::path& file, const KeptUnit& unit, const UnitSections& sections);

/// Reads it without the sections; nothing if the file is missing, damaged, or of another version.
[[nodiscard]] std::optional<KeptUnit> kept_unit(const std::filesystem::path& file);

/// Its sections; nothing if the file is missing, or a bit of them is damaged.
[[nodiscard]] std::optional<UnitSections> kept_sections(const std::filesystem::path& file);

}
