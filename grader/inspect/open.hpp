#pragma once

#include <elfutils/libdw.h>

namespace umbral::grader {

/// The debug information of a file, or null if there is none, or none that libdw may be given: it takes for granted
/// that sections of strings end with a zero, and reads on behind those that do not. Compressed ones, which our compiler
/// does not write, are refused too.
[[nodiscard]] Dwarf* open_debug_information(Elf* elf);

}
