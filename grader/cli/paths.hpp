#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "cli/application.hpp"
#include "store/refused_folder.hpp"

namespace umbral::grader {

// What users name on the command line is theirs to mend: whatever is wrong with it throws UsageError with the path and
// the reason.

/// Expects a folder that can be read; `meaning` says what for, as "a workspace".
void expect_folder(const std::filesystem::path& folder, std::string_view meaning);

/// The workspace that is meant: where no other one is named than the default, ".", and a unit is named by the path of
/// its folder, "work/raytracing/sphere", the folder in which that lies as a workspace holds its units. Throws
/// UsageError if units are named so of two workspaces.
[[nodiscard]] std::string workspace_of(std::span<const std::string> units, const std::string& folder);

/// Makes a folder, and those above it, where they are missing.
void make_folder(const std::filesystem::path& folder);

/// Expects that write_output(file, …) will find a folder in which it can write, and no folder, device or link in its
/// way: asked before hours of work, not after them. An empty name means no output, and is right.
void expect_writable(const std::filesystem::path& file);

/// Writes a file, whole or not at all.
void write_output(const std::filesystem::path& file, std::string_view text);

/// The bytes of a file, which may come from anybody: a device, a pipe or a folder is refused, a file of more than
/// `most` bytes too, and nothing is waited for. `option` says what named it.
[[nodiscard]] std::string read_given(std::string_view option, const std::filesystem::path& file, std::size_t most);

/// Does what works with files of the user's: what the file system refuses is a UsageError.
template <class Action>
auto as_given(const Action& action)
{
    try {
        return action();
    } catch (const std::filesystem::filesystem_error& error) {
        throw UsageError(error.what());
    } catch (const RefusedFolder& error) {
        throw UsageError(error.what());
    }
}

}
