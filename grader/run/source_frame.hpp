#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace umbral::grader {

/// How the texts that a student hands in beside C++ (shaders, say) go into a run: plain lengths and bytes, without a
/// grammar to attack. For each file the sizes of its name and of its text, eight bytes each in this machine's order,
/// then both.
[[nodiscard]] std::string framed(const std::map<std::string, std::string>& sources);

/// The same read back. Believes no length: throws std::runtime_error if the bytes are not exactly such a frame.
[[nodiscard]] std::map<std::string, std::string, std::less<>> unframed(std::string_view bytes);

}
