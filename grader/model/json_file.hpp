#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace umbral::grader {

/// Parses JSON text strictly: no comments, valid UTF-8, and no key twice in one object (where readers disagree on which counts).
/// Throws std::runtime_error that begins with `where` and says at which line and column.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& where);

/// The same of a file of at most `limit` bytes.
[[nodiscard]] nlohmann::json read_json(const std::filesystem::path& file, std::size_t limit = std::size_t{1} << 20U);

}
