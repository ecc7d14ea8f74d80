#pragma once

#include <libelf.h>

#include <string>
#include <vector>

namespace umbral::grader {

/// What the compiler calls at the beginning of each basic block of a library whose work is counted.
inline constexpr const char* block_counter = "__sanitizer_cov_trace_pc";

/// Reasons why the work of a library is not counted as a whole, each a line for its author; empty if nothing is wrong.
/// At most caps::listed of them. Asked is that
/// - the counter comes from outside, and is only ever called: the library neither defines it nor takes its address;
/// - every function calls it. Functions are the entries of .eh_frame, which the compiler writes for each of them,
/// exported or not;
/// - all code lies in such a function, but for what the linker adds: its tables of jumps, and the few functions at the
/// beginning of .text
///   that run constructors and destructors.
[[nodiscard]] std::vector<std::string> uncounted_code(Elf* elf);

}
