#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "collect/submitted_files.hpp"
#include "model/caps.hpp"

namespace umbral::grader {

/// What came out of one archive.
struct Unpacked {
    std::vector<std::pair<std::string, std::string>> files;  ///< paths and bytes: source code, and archives within
    std::vector<Ignored> ignored;
    std::vector<std::string> notes;  ///< why not all could be read; printable
    double cpu_seconds = 0;          ///< that unpacking took
};

/// Unpacks an archive in memory, confined. Paths are as in SubmittedFiles: whatever the archive said, they are relative
/// and lead nowhere else. It takes at most `seconds` of processor time. Never throws for what is in the archive. Throws
/// std::runtime_error or std::system_error if umbral-unpack cannot be started, or there is no room for a copy of the
/// archive.
[[nodiscard]] Unpacked unpack(const ArchiveTools& tools, std::string_view archive,
                              double seconds = caps::unpack_seconds);

/// Reads what umbral-unpack printed (see unpack_main.cpp), which a hostile archive may have made it print. Whatever
/// follows the first damage is dropped, and a note says so.
[[nodiscard]] Unpacked parse_unpacked(std::string_view output);

/// A path from an archive as SubmittedFiles has them: both kinds of slashes part it; empty parts, ".", ".." and drives
/// ("C:") go.
[[nodiscard]] std::string harmless_path(std::string_view path);

}
