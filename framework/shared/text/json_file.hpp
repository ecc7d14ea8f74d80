#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace umbral {

/// Parses JSON text strictly: no comments, valid UTF-8, no key twice in one object (where readers disagree on which
/// counts), and lists and objects at most 16 deep (our formats need seven). Throws std::runtime_error that begins with
/// `where` and says at which line and column.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& where);

/// The same of a file of at most `limit` bytes. What is not a regular file is refused, and not opened.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& file, std::size_t limit = std::size_t{1} << 20U);

}
