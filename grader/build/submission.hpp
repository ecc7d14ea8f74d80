#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/exercise.hpp"

namespace umbral::grader {

/// Texts by file name: a unit as somebody wrote it.
using Sources = std::map<std::string, std::string>;

/// What was handed in for one unit.
struct Handed {
    Sources files;
    std::vector<std::string> missing;  ///< files that the unit asks for and that are not there
    std::string refused;               ///< why a file was refused (too big, a link, not a regular file); empty if none was
};

inline constexpr std::size_t largest_file = std::size_t{512} << 10U;
inline constexpr std::size_t most_files = 32;

/// Is this a name for a submission ([A-Za-z0-9._-]+, not "." or "..")?
[[nodiscard]] bool is_submission_id(std::string_view name);

/// Collects a unit's files from a submission: in `folder/topic/unit/`, or flat in `folder`. Only regular files with the suffixes of
/// source code are read (so no .gch, no object files), links are refused, sizes and counts are capped; further .hpp and .cpp files are
/// taken from the unit's own folder only. Reads through descriptors opened without following links.
[[nodiscard]] Handed collect(const std::filesystem::path& folder, const Exercise& exercise);

/// Reads a whole text file that is not hostile. Throws std::runtime_error with the path.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// The files that no compiler turned into a library: what the driver gets as text, such as shaders.
[[nodiscard]] Sources texts_of(const Sources& files);

/// Are these the stubs of the unit, but for white space and comments?
[[nodiscard]] bool equals_stub(const Sources& files, const Exercise& exercise);

}
