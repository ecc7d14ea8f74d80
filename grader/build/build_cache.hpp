#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace umbral::grader {

/// Makes room in a cache of built submissions (`cache/builds/<two letters>/<key>`): once its files take more than
/// `limit` bytes, entries go, those first that were not used for longest, until four fifths are left. Entries used
/// within the last hour stay, for a run may be about to load them; scratch folders older than a day, which a killed
/// grader left, go too. Never throws: another process may do the same, or the disk may be read-only.
void prune_builds(const std::filesystem::path& cache, std::uintmax_t limit) noexcept;

/// Where the entry of a key (a digest in hexadecimal digits) lies in a folder of entries, `<two letters>/<key>`.
[[nodiscard]] inline std::filesystem::path entry_of(const std::filesystem::path& folder, const std::string& key)
{
    return folder / key.substr(0, 2) / key;
}

/// prune_builds for any folder of entries, without looking for scratch folders.
void prune_entries(const std::filesystem::path& folder, std::uintmax_t limit) noexcept;

/// Where the last results of checked workspaces lie in a cache.
[[nodiscard]] inline std::filesystem::path checks_folder(const std::filesystem::path& cache)
{
    return cache / "checks";
}

/// Where trusted runs are kept (worker/worker.hpp), an entry for each unit.
[[nodiscard]] inline std::filesystem::path runs_folder(const std::filesystem::path& cache) { return cache / "runs"; }

/// Notes that an entry was used now.
void mark_used(const std::filesystem::path& entry) noexcept;

}
