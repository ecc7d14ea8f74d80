#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "store/mark.hpp"

namespace umbral::grader {

// The folder of one submission's reports, `out/ID`: its mark, its reports, `pictures`, and in `units` what is kept of
// each unit.

/// Makes `folder` for the submission `id` if it is not there, for this user only. Returns its mark, or the mark to set:
/// then `reports` is empty, and nothing was written. Throws RefusedFolder if there is something that Umbral did not
/// make, or that belongs to another submission; std::filesystem::filesystem_error if it cannot be made.
[[nodiscard]] Mark open_report_folder(const std::filesystem::path& folder, const std::string& id);

/// Writes the mark, whole or not at all; the folder is ready for units then. Throws std::runtime_error with path and
/// reason.
void set_mark(const std::filesystem::path& folder, const Mark& mark);

/// Where a unit's result is kept.
[[nodiscard]] std::filesystem::path unit_file(const std::filesystem::path& folder, const std::string& unit_id);
/// Where a fault of the grader's is noted that the reports show in place of it. A result that was kept stays: it may
/// still be the answer.
[[nodiscard]] std::filesystem::path fault_file(const std::filesystem::path& folder, const std::string& unit_id);
/// The units of which there is one or the other, sorted.
[[nodiscard]] std::vector<std::string> kept_units(const std::filesystem::path& folder);

/// Removes what is kept of all units; the reports stay. Throws std::filesystem::filesystem_error.
void forget_units(const std::filesystem::path& folder);

/// Removes temporary files of a killed run. Never throws.
void tidy_temporaries(const std::filesystem::path& folder) noexcept;
/// Removes these pictures, which are named by paths relative to the folder ("pictures/sphere.png"), and nothing else
/// that lies there. Never throws.
void remove_pictures(const std::filesystem::path& folder, const std::set<std::string>& pictures) noexcept;

}
