#pragma once

#include <cstddef>
#include <string>

namespace umbral::grader {

/// A symbol as C++ writes it, cut behind `limit` bytes; a name that is not mangled stays as it is. Takes time and
/// memory in proportion to the mangled name and the limit, whatever the name says: a few letters may stand for
/// gigabytes.
[[nodiscard]] std::string demangled(const char* name, std::size_t limit);

}
