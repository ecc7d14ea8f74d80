#pragma once

#include <string>

namespace umbral::grader {

/// Libraries of the system that every run holds, and whose symbols are looked up one by one.
enum class SystemLibrary { mathematics, compiler, cpp };

/// Does this machine's libm, libgcc_s or libstdc++ itself define the symbol? So the names of another version are those
/// that it has.
[[nodiscard]] bool defines(SystemLibrary library, const std::string& symbol);

}
