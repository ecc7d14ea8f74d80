#pragma once

#include <elfutils/libdw.h>

#include <cstdint>
#include <optional>
#include <string>

namespace umbral::grader {

/// A place in a file of the student's own, which are compiled by their bare names.
struct OwnPlace {
    std::string file;
    std::uint64_t line = 0;    ///< counted from 1
    std::uint64_t column = 0;  ///< counted from 1; 0 where nothing says it
};

/// Where the code at `address` comes from, if that is a file of the student's own; or the place in such a file that
/// called what was inlined there.
[[nodiscard]] std::optional<OwnPlace> place_in_own_files(Dwarf* dwarf, Dwarf_Addr address);

}
