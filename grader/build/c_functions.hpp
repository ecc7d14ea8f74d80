#pragma once

#include <string_view>

namespace umbral::grader {

/// Functions and data of the C library that belong together: students' files may use all of them, or none.
struct CFamily {
    std::string_view what;   ///< of allowed ones what they are; of refused ones what they do: "opens or changes files"
    std::string_view names;  ///< patterns, separated by spaces: names as the C standard, POSIX or glibc know them
    bool allowed;
};

/// The family of a symbol of the C library, or null if it is in none: then it may not be used either, for nobody has
/// looked at it. Names that headers give to the same functions belong with them: `__isoc23_strtol` and `strtol_l` with
/// `strtol`, `__memcpy_chk` with `memcpy`.
[[nodiscard]] const CFamily* c_family(std::string_view symbol);

}
