#pragma once

#include <filesystem>
#include <string_view>

namespace umbral::grader {

/// Could this be the name of a temporary file of write_file_atomically for a file called `target` (empty: for any)?
[[nodiscard]] bool is_temporary(std::string_view name, std::string_view target = {});

/// Removes what a killed run left of its temporary files directly in `folder`, and nothing else. For folders of
/// Umbral's own, and only while nobody writes there. Never throws: what cannot be removed stays.
void remove_temporaries(const std::filesystem::path& folder, std::string_view target = {}) noexcept;

}
