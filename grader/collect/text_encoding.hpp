#pragma once

#include <string>

namespace umbral::grader {

/// A source file's bytes as the compiler wants them: UTF-16 (with a byte order mark, or without one if plainly so)
/// becomes UTF-8, and UTF-8's byte order mark goes; all else stays as it is, line ends too. What is no character
/// becomes U+FFFD.
[[nodiscard]] std::string as_utf8(std::string bytes);

}
