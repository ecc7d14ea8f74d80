#pragma once

#include <filesystem>
#include <optional>

#include "run/spawner.hpp"

namespace umbral::grader {

/// What a run left that ended well, as it was kept in a file; nothing if there is no such file, or a damaged one.
[[nodiscard]] std::optional<RunOutcome> kept_outcome(const std::filesystem::path& file);

/// Keeps what a run left. Keeping is for speed alone: a cache that cannot be written costs nobody a result.
void try_to_keep(const std::filesystem::path& file, const RunOutcome& outcome) noexcept;

}
