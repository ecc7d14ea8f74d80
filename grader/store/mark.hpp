#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// The file by which Umbral knows folders that it made: only what lies beside one is ever replaced or deleted.
inline constexpr const char* mark_name = "umbral-reports.json";

/// What a mark says.
struct Mark {
    Grading grading;
    std::string submission{};  ///< the id of the submission whose reports lie here; empty for the folder of a class
    std::string shown{};       ///< how it was called, if otherwise
    std::string source{};      ///< the name of the folder or archive that was graded, printable; empty: nobody knows
    std::string reports{};     ///< digest of what the reports were made from; empty: they still have to be written
};

/// As JSON, ready to be written.
[[nodiscard]] std::string to_text(const Mark& mark);

/// The mark in `folder`; nothing if there is none. Throws RefusedFolder if a file of that name is damaged, of a later
/// version, or no regular file.
[[nodiscard]] std::optional<Mark> read_mark(const std::filesystem::path& folder);

/// Is there nothing in `folder` but what a run left that was killed before it could set its mark?
[[nodiscard]] bool is_untouched(const std::filesystem::path& folder);

}
