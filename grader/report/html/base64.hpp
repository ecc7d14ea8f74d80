#pragma once

#include <string>
#include <string_view>

namespace umbral::grader::html {

/// Bytes in base 64, with padding. Based on: S. Josefsson. The Base16, Base32, and Base64 Data Encodings. RFC 4648, 2006.
[[nodiscard]] std::string base64(std::string_view bytes);

/// What Content-Security-Policy calls the hash of an inline style or script: "sha256-…".
[[nodiscard]] std::string source_hash(std::string_view text);

}
