#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "run/descriptor.hpp"

namespace umbral::grader {

// Files and folders below an open folder that somebody else filled. Nothing here follows a link, waits at a pipe or
// opens a device. What the other one did becomes a text in `refused`; std::system_error is thrown for all else: no
// descriptor or memory left, an ailing disk, a network that is gone, a file that was listed and is not there any more.

/// Can whoever makes a folder see to it that opening something there ends with this errno? Others are the machine's.
[[nodiscard]] bool may_be_made(int error) noexcept;

/// The bytes of one file.
struct FileBytes {
    std::string bytes;
    std::string refused;  ///< why it is not read; empty if it is
};
/// Reads the regular file `path` (parts joined by '/') below the folder `root`, if it has at most `limit` bytes.
[[nodiscard]] FileBytes read_file_below(int root, std::string_view path, std::size_t limit);

/// Is there anything at `path` that can be looked at? Throws where only the machine keeps one from it.
[[nodiscard]] bool lies_below(int root, std::string_view path);

/// What lies in one folder.
struct Listing {
    std::vector<std::string> folders;  ///< sorted, without what tools make (is_junk)
    std::vector<std::string>
        files;                ///< sorted: all else whose name is of source code or of an archive, of whatever type
    std::size_t entries = 0;  ///< how many names were looked at
    bool whole = true;        ///< false: there are more than `most` of them
    std::string refused;      ///< why it is not read; empty if it is
};
/// Lists the folder `path` ("" for `root` itself), looking at no more than `most` names.
[[nodiscard]] Listing list_folder_below(int root, std::string_view path, std::size_t most);

}
