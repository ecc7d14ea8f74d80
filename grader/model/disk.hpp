#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace umbral::grader {

/// The bytes of all regular files below `folder`, links not followed. What vanishes or cannot be read while it looks
/// counts nothing.
[[nodiscard]] inline std::uintmax_t bytes_below(const std::filesystem::path& folder)
{
    namespace fs = std::filesystem;
    std::uintmax_t bytes = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && at != end; at.increment(error)) {
        std::error_code gone;
        if (!at->is_regular_file(gone) || at->is_symlink(gone)) continue;
        const std::uintmax_t size = at->file_size(gone);
        if (!gone) bytes += size;
    }
    return bytes;
}

}
