#pragma once

#include <cstdint>
#include <filesystem>

namespace umbral::grader {

/// Makes room in a cache of built submissions (`cache/builds/<two letters>/<key>`): once its files take more than `limit` bytes, entries go,
/// those first that were not used for longest, until four fifths are left. Entries used within the last hour stay, for a run may be
/// about to load them; scratch folders older than a day, which a killed grader left, go too. Never throws: another process may
/// do the same, or the disk may be read-only.
void prune_builds(const std::filesystem::path& cache, std::uintmax_t limit) noexcept;

/// Notes that an entry was used now.
void mark_used(const std::filesystem::path& entry) noexcept;

}
