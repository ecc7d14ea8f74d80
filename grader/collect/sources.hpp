#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "model/exercise.hpp"

namespace umbral::grader {

/// Texts by file name: a unit as somebody wrote it.
using Sources = std::map<std::string, std::string>;

/// Reads a whole text file that is not hostile. Throws std::runtime_error with the path.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// Writes a file of our own in a folder where nobody else looks. Throws std::runtime_error with the path and the
/// reason.
void write_text(const std::filesystem::path& file, std::string_view text);

/// The files that no compiler reads: what the driver gets as text, such as shaders.
[[nodiscard]] Sources texts_of(const Sources& files);

/// How much they hold, names and all.
[[nodiscard]] std::size_t bytes_of(const Sources& files);

/// Are these the stubs of the unit, but for white space and comments?
[[nodiscard]] bool equals_stub(const Sources& files, const Exercise& exercise);

/// Is `text` the stub of the unit's file `name`, but for white space and comments?
[[nodiscard]] bool is_stub(std::string_view text, const Exercise& exercise, const std::string& name);

}
