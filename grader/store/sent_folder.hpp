#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace umbral::grader {

// Writing into a folder that somebody else may have sent, such as a student's workspace. Everything in it may have been
// planted: links that lead writing elsewhere, pipes that are waited for. The folder itself is the user's choice, and
// may be a link.

/// Makes the folder `below` (relative, without "..") in `root`, which exists, with those above it. Throws RefusedFolder
/// if one of them is a link or no folder, or cannot be made.
void make_folder_below(const std::filesystem::path& root, const std::filesystem::path& below);

/// Writes the file `below` in `root`, whole or not at all, in place of whatever has its name: a link is replaced and
/// not followed, a file of several names loses this one. Makes its folder. Throws RefusedFolder, and std::runtime_error
/// if the file cannot be written.
void write_file_below(const std::filesystem::path& root, const std::filesystem::path& below,
                      std::span<const std::byte> bytes);

/// The same with what lies in the file `from`, which is Umbral's own.
void copy_file_below(const std::filesystem::path& from, const std::filesystem::path& root,
                     const std::filesystem::path& below);

/// Does anything have this name, and be it a link that leads to nothing?
[[nodiscard]] inline bool is_taken(const std::filesystem::path& path)
{
    std::error_code none;
    return std::filesystem::exists(std::filesystem::symlink_status(path, none));
}

}
