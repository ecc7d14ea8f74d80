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

std::vector<Entry> entries_of(const fs::path& builds)
{
    std::vector<Entry> entries;
    std::error_code error;
    for (const auto& letters : fs::directory_iterator(builds, error)) {
        std::error_code gone;
        for (const auto& entry : fs::directory_iterator(letters.path(), gone)) {
            const Time used = fs::last_write_time(entry.path(), gone);
            if (!gone) entries.push_back({entry.path(), bytes_below(entry.path()), used});
        }
    }
    return entries;
}

void remove_old_scratch(const fs::path& cache, Time now)
{
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(cache, error)) {
        std::error_code gone;
        const Time written = fs::last_write_time(entry.path(), gone);
        if (gone || !is_scratch_name(entry.path().filename().string()) || now - written < std::chrono::hours(24)) continue;
        fs::remove_all(entry.path(), gone);
    }
}

}

void prune_builds(const fs::path& cache, std::uintmax_t limit) noexcept
try {
    const Time now = Time::clock::now();
    remove_old_scratch(cache, now);
    std::vector<Entry> entries = entries_of(cache / "builds");
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
