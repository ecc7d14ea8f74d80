#pragma once

#include <string>
#include <string_view>

namespace umbral::grader::html {

/// Bytes in base 64 (RFC 4648), with padding. Throws std::length_error if they are 1 GiB or more.
[[nodiscard]] std::string base64(std::string_view bytes);

/// What Content-Security-Policy calls the hash of an inline style or script: "sha256-…".
[[nodiscard]] std::string source_hash(std::string_view text);

}
