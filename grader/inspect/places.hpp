#pragma once

#include <elfutils/libdw.h>

#include <optional>
#include <string>

namespace umbral::grader {

/// Where the code at `address` comes from, as "sphere.cpp:17", if that is a file of the student's own, which are
/// compiled by their bare names; or the place in such a file that called what was inlined there. Empty if there is
/// none.
[[nodiscard]] std::string place_in_own_files(Dwarf* dwarf, Dwarf_Addr address);

}
