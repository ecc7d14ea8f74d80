#pragma once

#include <libelf.h>

#include <cstdint>

namespace umbral::grader {

/// How many bytes of a library its code may write: its static and global variables, those of functions and threads
/// too. What the compiler and the linker put there for themselves does not count. 0 is never said of a library that has
/// a variable.
[[nodiscard]] std::uint64_t own_memory(Elf* elf);

}
