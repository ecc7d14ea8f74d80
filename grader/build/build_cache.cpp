#include "build/build_cache.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <vector>

#include "model/disk.hpp"
#include "model/scratch.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;
using Time = fs::file_time_type;

struct Entry {
    fs::path path;
    std::uintmax_t bytes = 0;
    Time used;
};

/// A link could lead anywhere: what is looked at, and removed, are folders of the cache itself.
bool is_own_folder(const fs::path& path)
{
    std::error_code gone;
    return fs::is_directory(fs::symlink_status(path, gone));
}

std::vector<fs::path> folders_in(const fs::path& folder)
{
    std::vector<fs::path> folders;
    std::error_code error;
    if (!is_own_folder(folder)) return folders;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (is_own_folder(at->path())) folders.push_back(at->path());
    return folders;
}

std::vector<Entry> entries_of(const fs::path& builds)
{
    std::vector<Entry> entries;
    for (const fs::path& letters : folders_in(builds))
        for (const fs::path& entry : folders_in(letters)) {
            std::error_code gone;
            const Time used = fs::last_write_time(entry, gone);
            if (!gone) entries.push_back({entry, bytes_below(entry), used});
        }
    return entries;
}

void remove_old_scratch(const fs::path& cache, Time now)
{
    for (const fs::path& folder : folders_in(cache)) {
        std::error_code gone;
        const Time written = fs::last_write_time(folder, gone);
        if (gone || !is_scratch_name(folder.filename().string()) || now - written < std::chrono::hours(24)) continue;
        fs::remove_all(folder, gone);
    }
}

}

void prune_builds(const fs::path& cache, std::uintmax_t limit) noexcept
{
    try {
        remove_old_scratch(cache, Time::clock::now());
    } catch (const std::exception&) {
        // Out of memory for the list: the next one will do it.
    }
    prune_entries(cache / "builds", limit);
}

void prune_entries(const fs::path& folder, std::uintmax_t limit) noexcept
try {
    const Time now = Time::clock::now();
    std::vector<Entry> entries = entries_of(folder);
    std::uintmax_t bytes = 0;
    for (const Entry& entry : entries) bytes += entry.bytes;
    if (bytes <= limit) return;
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (bytes <= limit / 5 * 4 || now - entry.used < std::chrono::hours(1)) return;
        std::error_code gone;
        fs::remove_all(entry.path, gone);
        bytes -= entry.bytes;
    }
} catch (const std::exception&) {
    // Out of memory for the list: the next one will do it.
}

void mark_used(const fs::path& entry) noexcept
{
    std::error_code ignored;
    fs::last_write_time(entry, Time::clock::now(), ignored);
}

}
