#pragma once

#include <elfutils/libdw.h>
#include <libelf.h>

#include <string>
#include <vector>

namespace umbral::grader {

/// The names of a built library as one line of JSON: which of `interface_names` (mangled) it does not define
/// ("missing", readable), what it wants from others ("undefined", pairs of mangled and readable), and the functions of
/// its debug information that left code, inlined ones too ("functions", pairs of readable name and file). What only
/// code wants or holds that the linker left out, because nothing calls it, is not among them, unless a name of the
/// interface is missing. Lists and names are bounded by grader/model/caps.hpp. Empty if the file is damaged, has no
/// debug information, or more names than are read: what was not seen could be anything.
[[nodiscard]] std::string names_as_json(Elf* elf, Dwarf* dwarf, const std::vector<std::string>& interface_names);

}
